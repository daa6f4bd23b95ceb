// ASCII .msh 4.1 as `run` writes it, read without the program, to check what the viewer shows.

import {readFileSync} from "node:fs";

/**
 * {points: [[x, y]], elements: [[vertices]] (triangles, then quads), fields: {name: {on,
 * values: [[components]]}}}; vertices count from 0.
 */
export function readMeshFile(path) {
  const lines = readFileSync(path, "utf8").split("\n");
  const at = (section) => lines.indexOf(`$${section}`) + 1;
  const mesh = {points: readNodes(lines, at("Nodes")), elements: [], fields: {}};
  const elements = readElements(lines, at("Elements"));
  const numbers = new Map(elements.map(({number}, i) => [number, i]));
  mesh.elements = elements.map(({vertices}) => vertices);
  lines.forEach((line, i) => {
    if (line === "$NodeData") addField(mesh, "vertex", lines, i + 1, (number) => number - 1);
    if (line === "$ElementData") {
      addField(mesh, "element", lines, i + 1, (number) => numbers.get(number));
    }
  });
  return mesh;
}

const numbersOf = (line) => line.trim().split(/\s+/).map(Number);

function readNodes(lines, i) {
  const points = [];
  for (let blocks = numbersOf(lines[i++])[0]; blocks > 0; --blocks) {
    const count = numbersOf(lines[i++])[3];
    for (let k = 0; k < count; ++k) {
      points[Number(lines[i + k]) - 1] = numbersOf(lines[i + count + k]).slice(0, 2);
    }
    i += 2 * count;
  }
  return points;
}

function readElements(lines, i) {
  const elements = [];
  for (let blocks = numbersOf(lines[i++])[0]; blocks > 0; --blocks) {
    const [, , type, count] = numbersOf(lines[i++]);
    for (let k = 0; k < count; ++k) {
      const [number, ...nodes] = numbersOf(lines[i++]);
      if (type === 2 || type === 3) {
        elements.push({type, number, vertices: nodes.map((node) => node - 1)});
      }
    }
  }
  return elements.sort((a, b) => a.type - b.type || a.number - b.number);
}

function addField(mesh, on, lines, i, placeOf) {
  const name = lines[i + 1].replaceAll('"', "");
  i += 1 + Number(lines[i]);
  i += 1 + Number(lines[i]);
  const tags = numbersOf(lines.slice(i + 1, i + 1 + Number(lines[i])).join(" "));
  i += 1 + Number(lines[i]);
  const values = [];
  for (let k = 0; k < tags[2]; ++k) {
    const [number, ...components] = numbersOf(lines[i + k]);
    values[placeOf(number)] = components;
  }
  mesh.fields[name] = {on, values};
}

/** The mean of the corners of an element. */
export function middleOf(mesh, element) {
  const corners = mesh.elements[element].map((v) => mesh.points[v]);
  return [0, 1].map((k) => corners.reduce((sum, p) => sum + p[k], 0) / corners.length);
}

/** The shortest edge of the elements at each vertex. */
export function shortestEdges(mesh) {
  const shortest = mesh.points.map(() => Infinity);
  for (const vertices of mesh.elements) {
    vertices.forEach((a, k) => {
      const b = vertices[(k + 1) % vertices.length];
      const [p, q] = [mesh.points[a], mesh.points[b]];
      const length = Math.hypot(p[0] - q[0], p[1] - q[1]);
      for (const v of [a, b]) shortest[v] = Math.min(shortest[v], length);
    });
  }
  return shortest;
}

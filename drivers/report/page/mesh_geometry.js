// What follows from a mesh: edges, sizes, room between edges.

/**
 * {edges (vertex pairs in the order of mesh_edges()), edgeElements (two each, -1: none),
 * elementEdges (by side), areas, sizes (side of the equilateral triangle or square of equal area),
 * rooms (of edges: mean height of the elements beside it), box (from the centre)}; made once.
 */
function meshGeometry(mesh) {
  mesh.geometry ??= {...meshEdges(mesh), ...elementAreas(mesh), box: meshBox(mesh)};
  mesh.geometry.rooms ??= edgeRooms(mesh, mesh.geometry);
  return mesh.geometry;
}

/** Sides of an element in the order in which the program counts edges. */
function orderedSides(sides, element) {
  const begin = sides.begin(element);
  return sides.size(element) === 3 ? [begin + 1, begin + 2, begin]
    : [begin, begin + 1, begin + 2, begin + 3];
}

function meshEdges({sides, edges: count}) {
  const edges = new Int32Array(2 * count);
  const edgeElements = new Int32Array(2 * count).fill(-1);
  const elementEdges = new Int32Array(sides.corners.length);
  let found = 0;
  for (let e = 0; e < sides.elements; ++e) {
    for (const side of orderedSides(sides, e)) {
      const other = sides.across(side);
      const isNew = other < 0 || sides.element(other) > e;
      const edge = isNew ? found++ : elementEdges[other];
      if (isNew) edges.set([sides.corners[side], sides.vertex(side, 1)], 2 * edge);
      edgeElements[2 * edge + (isNew ? 0 : 1)] = e;
      elementEdges[side] = edge;
    }
  }
  return {edges, edgeElements, elementEdges};
}

function elementAreas({sides, x, y}) {
  const areas = new Float64Array(sides.elements);
  const sizes = new Float64Array(sides.elements);
  for (let e = 0; e < sides.elements; ++e) {
    const [begin, n] = [sides.begin(e), sides.size(e)];
    let twice = 0;
    const o = sides.corners[begin];
    for (let k = 1; k + 1 < n; ++k) {
      const [a, b] = [sides.corners[begin + k], sides.corners[begin + k + 1]];
      twice += (x[a] - x[o]) * (y[b] - y[o]) - (x[b] - x[o]) * (y[a] - y[o]);
    }
    areas[e] = twice / 2;
    sizes[e] = Math.sqrt(Math.max(areas[e], 0) * (n === 3 ? 4 / Math.sqrt(3) : 1));
  }
  return {areas, sizes};
}

function edgeRooms({x, y}, {edges, edgeElements, areas}) {
  const rooms = new Float32Array(edges.length / 2);
  for (let i = 0; i < rooms.length; ++i) {
    const [a, b, left, right] = [edges[2 * i], edges[2 * i + 1], edgeElements[2 * i],
      edgeElements[2 * i + 1]];
    const area = right < 0 ? 2 * areas[left] : areas[left] + areas[right];
    rooms[i] = area / Math.hypot(x[b] - x[a], y[b] - y[a]);
  }
  return rooms;
}

/** {x0, y0, x1, y1} */
function meshBox({x, y}) {
  const box = {x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity};
  for (let v = 0; v < x.length; ++v) {
    box.x0 = Math.min(box.x0, x[v]);
    box.x1 = Math.max(box.x1, x[v]);
    box.y0 = Math.min(box.y0, y[v]);
    box.y1 = Math.max(box.y1, y[v]);
  }
  return x.length > 0 ? box : {x0: 0, y0: 0, x1: 1, y1: 1};
}

/** The vertices of an element. */
function elementVertices({sides}, element) {
  const begin = sides.begin(element);
  return sides.corners.subarray(begin, begin + sides.size(element));
}

/** Share of the edges with a length in [1/√2, √2], percent; null without lengths. */
function percentInBand(mesh) {
  const {edgeLengths} = mesh;
  if (!edgeLengths || edgeLengths.length === 0) return null;
  mesh.inBand ??= edgeLengths.reduce((n, l) => n + (l >= Math.SQRT1_2 && l <= Math.SQRT2), 0);
  return 100 * mesh.inBand / edgeLengths.length;
}

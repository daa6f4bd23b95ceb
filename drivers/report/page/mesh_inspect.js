// What is known about the element at a point, and the panel that says it.

/** Four significant digits, powers of ten where numbers are long. */
function meshNumber(value) {
  if (!Number.isFinite(value)) return kUnknown;
  const size = Math.abs(value);
  if (value !== 0 && (size < 1e-3 || size >= 1e5)) {
    const [digits, exponent] = value.toExponential(3).split("e");
    return signText(`${Number(digits)}·${powerOfTenText(Number(exponent))}`.replace(/^1·/, ""));
  }
  return signText(String(Number(value.toPrecision(4))));
}

/** With a real minus. */
function signText(text) {
  return text.replace(/^-/, "−");
}

/** As many digits as the view can tell apart. */
function coordinateText(value, camera) {
  const digits = Math.min(Math.max(Math.ceil(Math.log10(camera.scale)), 0), 12);
  return signText(String(Number(value.toFixed(digits))));
}

/**
 * {element, isQuad, x, y, vertices, region, size, quality, values: [{label, value}],
 * metric: {h1, h2, angle} or null, edges: lengths or null} at a point of the plane, or null.
 */
function inspectMesh(mesh, x, y) {
  const place = locateInMesh(mesh, x - mesh.centre[0], y - mesh.centre[1]);
  if (!place) return null;
  const {element} = place;
  const begin = mesh.sides.begin(element);
  const {sizes, elementEdges} = meshGeometry(mesh);
  const vertices = [...elementVertices(mesh, element)];
  return {element, isQuad: vertices.length === 4, x, y, vertices, size: sizes[element],
    region: regionName(mesh, element), quality: mesh.quality ? mesh.quality[element] : null,
    values: mesh.fields.map((field) => ({label: fieldLabel(field), on: field.on,
      key: `${field.on}:${field.name}`, value: field.on === "element" ? field.values[element]
        : valueInElement(mesh, place, field.values)})),
    metric: mesh.metric ? metricSizesAt(mesh, place) : null,
    edges: mesh.edgeLengths
      ? vertices.map((_, k) => mesh.edgeLengths[elementEdges[begin + k]]) : null};
}

function regionName(mesh, element) {
  const {values, names} = regionClasses(mesh);
  return names[values[element]];
}

/** [[label, text]] of all that is known. */
function inspectionRows(seen, camera) {
  const rows = [
    ["point", `(${coordinateText(seen.x, camera)}, ${coordinateText(seen.y, camera)})`],
    ["vertices", seen.vertices.map((v) => v + 1).join(", ")],
    ["region", seen.region],
    ["size", meshNumber(seen.size)],
  ];
  if (seen.quality !== null) rows.push(["quality", seen.quality.toFixed(3)]);
  for (const {label, value} of seen.values) rows.push([label, meshNumber(value)]);
  if (seen.metric) {
    const {h1, h2, angle} = seen.metric;
    rows.push(["metric sizes", `${meshNumber(h1)} × ${meshNumber(h2)}`]);
    if (h2 / h1 > 1.02) {
      const degrees = (Math.round(angle * 180 / Math.PI) + 180) % 180;
      rows.push(["long side", `${degrees}°, ${(h2 / h1).toFixed(1)} : 1`]);
    }
  }
  if (seen.edges) rows.push(["edge lengths", seen.edges.map((l) => l.toFixed(2)).join(", ")]);
  return rows;
}

function elementTitle({element, isQuad}) {
  return `${isQuad ? "Quadrilateral" : "Triangle"} ${element + 1}`;
}

/** Two lines beside the pointer: the element, the value of the shown quantity. */
function hoverLines(seen, quantity, curveName) {
  const lines = [];
  if (curveName) lines.push(curveName);
  if (!seen) return lines;
  lines.push(elementTitle(seen));
  const value = shownValue(seen, quantity);
  if (value) lines.push(`${quantity.label} ${value}`);
  return lines;
}

function shownValue(seen, quantity) {
  if (quantity.key === "none") return "";
  if (quantity.key === "region") return seen.region;
  if (quantity.key === "quality") return seen.quality.toFixed(3);
  if (quantity.key === "size") return meshNumber(seen.size);
  const entry = seen.values.find(({key}) => key === quantity.key);
  return entry ? meshNumber(entry.value) : "";
}

function fillInspector(panel, seen, camera, close) {
  const list = htmlElement("dl");
  for (const [label, text] of inspectionRows(seen, camera)) {
    list.append(htmlElement("div", {}, htmlElement("dt", {}, label),
      htmlElement("dd", {}, text)));
  }
  panel.replaceChildren(
    htmlElement("div", {class: "mesh-panel-head"}, htmlElement("strong", {}, elementTitle(seen)),
      htmlElement("button", {type: "button", class: "mesh-close", "aria-label": "Close",
        title: "Close (Esc)", onclick: close}, "×")),
    list);
}

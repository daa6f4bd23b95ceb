// Draws fills and edges on a plain canvas, where there is no WebGL: the same picture, slower.

const kFillBins = 64;       // colours of flat fills
const kFadeBins = 6;        // opacities of edges
const kMostGradients = 4000;  // more elements in view are filled flat
const kMostInPath = 200;    // elements or edges; the time of a path grows faster than its length

function createMeshCanvas(canvas) {
  const context = canvas.getContext("2d", {alpha: false});
  const state = {context, mesh: null, fill: null, edges: null};
  return {
    name: "canvas",
    setMesh: (mesh) => Object.assign(state, {mesh, fill: null, edges: null}),
    setFill: (fill) => state.fill = fill,
    setEdges: (edges) => state.edges = edges,
    draw: (camera, look) => drawOnCanvas(state, canvas, camera, look),
  };
}

function drawOnCanvas({context, mesh, fill, edges}, canvas, camera, look) {
  const ratio = canvas.width / camera.width;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillStyle = rgbText(look.surface);
  context.fillRect(0, 0, camera.width, camera.height);
  if (!mesh) return;
  const points = screenPoints(mesh, camera);
  const shown = elementsInView(mesh, points, camera);
  context.lineJoin = "round";
  if (fill.on === "vertex" && shown.length <= kMostGradients) {
    for (const e of shown) fillSmooth(context, mesh, points, e, fill);
  } else fillFlat(context, mesh, points, shown, fill);
  if (edges?.isShown) drawCanvasEdges(context, mesh, points, camera, edges);
}

/** Pixels of all vertices. */
function screenPoints(mesh, camera) {
  const x = new Float64Array(mesh.vertices), y = new Float64Array(mesh.vertices);
  for (let v = 0; v < mesh.vertices; ++v) {
    x[v] = screenX(camera, mesh.x[v] + mesh.centre[0]);
    y[v] = screenY(camera, mesh.y[v] + mesh.centre[1]);
  }
  return {x, y};
}

function isInView({x, y}, vertices, {width, height}) {
  let [left, right, above, below] = [true, true, true, true];
  for (const v of vertices) {
    left &&= x[v] < 0;
    right &&= x[v] > width;
    above &&= y[v] < 0;
    below &&= y[v] > height;
  }
  return !(left || right || above || below);
}

function elementsInView(mesh, points, camera) {
  const shown = [];
  for (let e = 0; e < mesh.elements; ++e) {
    if (isInView(points, elementVertices(mesh, e), camera)) shown.push(e);
  }
  return shown;
}

function tracePolygon(context, {x, y}, vertices) {
  context.moveTo(x[vertices[0]], y[vertices[0]]);
  for (let k = 1; k < vertices.length; ++k) context.lineTo(x[vertices[k]], y[vertices[k]]);
  context.closePath();
}

/** One colour for each element; equal colours in one stroke, which also hides the seams. */
function fillFlat(context, mesh, points, shown, fill) {
  const bins = Array.from({length: kFillBins + 1}, () => []);
  for (const e of shown) {
    const t = elementPosition(mesh, e, fill);
    bins[t < 0 ? kFillBins : Math.min(Math.floor(t * kFillBins), kFillBins - 1)].push(e);
  }
  bins.forEach((elements, bin) => {
    const t = bin === kFillBins ? -1 : (bin + 0.5) / kFillBins;
    const style = rgbText(paletteRgb(fill.palette, t));
    inPaths(context, elements, (e) => tracePolygon(context, points, elementVertices(mesh, e)),
      () => fillWithRim(context, style));
  });
}

/** Traces all items in paths of moderate length; `finish` fills or strokes a path. */
function inPaths(context, items, trace, finish) {
  for (let i = 0; i < items.length; i += kMostInPath) {
    context.beginPath();
    for (let k = i; k < Math.min(i + kMostInPath, items.length); ++k) trace(items[k]);
    finish();
  }
}

function fillWithRim(context, style) {
  context.fillStyle = context.strokeStyle = style;
  context.lineWidth = 0.7;
  context.fill();
  context.stroke();
}

function elementPosition(mesh, element, {on, positions}) {
  if (on === "element") return positions[element];
  let sum = 0;
  const vertices = elementVertices(mesh, element);
  for (const v of vertices) {
    if (positions[v] < 0) return -1;
    sum += positions[v];
  }
  return sum / vertices.length;
}

/** The colour of a linear function is a linear gradient; a quad is four triangles. */
function fillSmooth(context, mesh, points, element, fill) {
  const v = [...elementVertices(mesh, element)];
  const corner = (i) => ({x: points.x[i], y: points.y[i], t: fill.positions[i]});
  const corners = v.map(corner);
  if (corners.some(({t}) => t < 0)) {
    context.beginPath();
    tracePolygon(context, points, v);
    fillWithRim(context, rgbText(kNoValueColour));
  } else if (v.length === 3) fillGradient(context, corners, fill.palette);
  else {
    const mean = (key) => corners.reduce((sum, c) => sum + c[key], 0) / 4;
    const middle = {x: mean("x"), y: mean("y"), t: mean("t")};
    for (let k = 0; k < 4; ++k) {
      fillGradient(context, [corners[k], corners[(k + 1) % 4], middle], fill.palette);
    }
  }
}

function fillGradient(context, [a, b, c], palette) {
  const area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  const gx = ((b.t - a.t) * (c.y - a.y) - (c.t - a.t) * (b.y - a.y)) / area;
  const gy = ((b.x - a.x) * (c.t - a.t) - (c.x - a.x) * (b.t - a.t)) / area;
  const [low, high] = [Math.min(a.t, b.t, c.t), Math.max(a.t, b.t, c.t)];
  context.beginPath();
  context.moveTo(a.x, a.y);
  context.lineTo(b.x, b.y);
  context.lineTo(c.x, c.y);
  context.closePath();
  const steep = gx * gx + gy * gy;
  if (!(high - low > 1e-3) || !Number.isFinite(steep)) {
    return fillWithRim(context, rgbText(paletteRgb(palette, (low + high) / 2)));
  }
  const at = (t) => [a.x + (t - a.t) * gx / steep, a.y + (t - a.t) * gy / steep];
  const gradient = context.createLinearGradient(...at(low), ...at(high));
  const stops = Math.max(1, Math.ceil((high - low) * 24));
  for (let i = 0; i <= stops; ++i) {
    const t = low + (high - low) * i / stops;
    gradient.addColorStop(i / stops, rgbText(paletteRgb(palette, t)));
  }
  fillWithRim(context, gradient);
}

/** Edges of like colour and opacity are stroked together. */
function drawCanvasEdges(context, mesh, points, camera, edges) {
  const {edges: ends, rooms} = meshGeometry(mesh);
  const groups = new Map();
  for (let i = 0; i < rooms.length; ++i) {
    const pair = [ends[2 * i], ends[2 * i + 1]];
    if (!isInView(points, pair, camera)) continue;
    const fade = Math.min(Math.max(rooms[i] * camera.scale / edges.fadeBelow, edges.leastFade), 1);
    const t = edges.positions ? Math.round(edges.positions[i] * 48) : 0;
    const key = t * (kFadeBins + 1) + Math.ceil(fade * kFadeBins);
    if (!groups.has(key)) groups.set(key, []);
    groups.get(key).push(pair);
  }
  context.lineWidth = edges.width;
  context.lineCap = "butt";
  for (const [key, pairs] of groups) {
    const rgb = edges.positions
      ? paletteRgb(edges.palette, Math.floor(key / (kFadeBins + 1)) / 48) : edges.colour;
    const fade = key % (kFadeBins + 1) / kFadeBins;
    context.strokeStyle = rgbText(rgb, edges.alpha * fade);
    inPaths(context, pairs, ([a, b]) => {
      context.moveTo(points.x[a], points.y[a]);
      context.lineTo(points.x[b], points.y[b]);
    }, () => context.stroke());
  }
}

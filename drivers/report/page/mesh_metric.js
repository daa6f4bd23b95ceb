// The metric of a mesh: sizes, directions, and the choice of ellipses that are drawn.

/** {h1 <= h2, angle (of h2 to the x axis, radians)} of log2 sizes as a tensor (xx, xy, yy). */
function sizesOfLog(xx, xy, yy) {
  const [middle, half] = [(xx + yy) / 2, (xx - yy) / 2];
  const radius = Math.hypot(half, xy);
  return {h1: 2 ** (middle - radius), h2: 2 ** (middle + radius),
    angle: radius > 0 ? Math.atan2(xy, half) / 2 : 0};
}

function metricSizes({metric: [xx, xy, yy]}, vertex) {
  return sizesOfLog(xx[vertex], xy[vertex], yy[vertex]);
}

function metricSizesAt(mesh, place) {
  return sizesOfLog(...mesh.metric.map((entries) => valueInElement(mesh, place, entries)));
}

/**
 * Vertices of which no two are nearer than three edges: their ellipses stand beside each other
 * where the mesh fits the metric. Inner ones, if there are any. The choice never changes.
 */
function spacedVertices(mesh) {
  mesh.spaced ??= chooseSpaced(mesh, vertexNeighbours(mesh));
  return mesh.spaced;
}

function chooseSpaced(mesh, {first, vertices}) {
  const near = new Uint8Array(mesh.vertices);
  for (const v of mesh.curves.vertices) near[v] = 1;
  if (near.every(Boolean)) near.fill(0);
  const chosen = [];
  for (let v = 0; v < mesh.vertices; ++v) {
    if (near[v]) continue;
    chosen.push(v);
    for (let i = first[v]; i < first[v + 1]; ++i) {
      near[vertices[i]] = 1;
      for (let k = first[vertices[i]]; k < first[vertices[i] + 1]; ++k) near[vertices[k]] = 1;
    }
  }
  return chosen;
}

/** Those of v are vertices[first[v]] .. vertices[first[v + 1] - 1]. */
function vertexNeighbours(mesh) {
  const {edges} = meshGeometry(mesh);
  const first = new Int32Array(mesh.vertices + 1);
  for (const v of edges) ++first[v + 1];
  for (let v = 0; v < mesh.vertices; ++v) first[v + 1] += first[v];
  const next = first.slice();
  const vertices = new Int32Array(edges.length);
  for (let i = 0; i < edges.length; i += 2) {
    vertices[next[edges[i]]++] = edges[i + 1];
    vertices[next[edges[i + 1]]++] = edges[i];
  }
  return {first, vertices};
}

const kEllipseCell = 26;  // pixels: cells that hold one ellipse at most

/**
 * The ellipses to be drawn: of the spaced vertices in view the first of each cell of a lattice
 * that is fixed to the plane, so that none jump while the view moves.
 */
function chooseEllipses(mesh, camera) {
  if (!mesh.metric) return [];
  const cell = 2 ** Math.ceil(Math.log2(kEllipseCell / camera.scale));
  const taken = new Set();
  const view = cameraBox(camera);
  const chosen = [];
  for (const v of spacedVertices(mesh)) {
    const [x, y] = [mesh.x[v] + mesh.centre[0], mesh.y[v] + mesh.centre[1]];
    const key = `${Math.floor(x / cell)} ${Math.floor(y / cell)}`;
    if (taken.has(key)) continue;
    taken.add(key);
    const sizes = metricSizes(mesh, v);
    if (x + sizes.h2 < view.x0 || x - sizes.h2 > view.x1) continue;
    if (y + sizes.h2 < view.y0 || y - sizes.h2 > view.y1) continue;
    chosen.push({x, y, ...sizes});
  }
  return chosen;
}

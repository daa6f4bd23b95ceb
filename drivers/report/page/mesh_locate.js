// Which element holds a point, and values in it.

/** {element, weights (of its vertices)} at a point from the centre, or null outside. */
function locateInMesh(mesh, px, py) {
  const grid = mesh.grid ??= createGrid(mesh);
  const column = Math.floor((px - grid.x) / grid.width);
  const row = Math.floor((py - grid.y) / grid.height);
  if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) return null;
  const cell = row * grid.columns + column;
  for (let i = grid.first[cell]; i < grid.first[cell + 1]; ++i) {
    const weights = weightsInElement(mesh, grid.elements[i], px, py);
    if (weights) return {element: grid.elements[i], weights};
  }
  return null;
}

/** About two cells for each element; the elements whose boxes meet a cell. */
function createGrid(mesh) {
  const box = meshBox(mesh);
  const size = Math.sqrt((box.x1 - box.x0) * (box.y1 - box.y0) / (2 * mesh.elements + 1)) || 1;
  const columns = Math.max(1, Math.min(2000, Math.round((box.x1 - box.x0) / size)));
  const rows = Math.max(1, Math.min(2000, Math.round((box.y1 - box.y0) / size)));
  const grid = {x: box.x0, y: box.y0, columns, rows,
    width: (box.x1 - box.x0) / columns * (1 + 1e-12) || 1,
    height: (box.y1 - box.y0) / rows * (1 + 1e-12) || 1};
  grid.first = new Int32Array(columns * rows + 1);
  forEachCell(mesh, grid, (cell) => ++grid.first[cell + 1]);
  for (let c = 0; c < columns * rows; ++c) grid.first[c + 1] += grid.first[c];
  const fill = grid.first.slice();
  grid.elements = new Int32Array(grid.first[columns * rows]);
  forEachCell(mesh, grid, (cell, element) => grid.elements[fill[cell]++] = element);
  return grid;
}

function forEachCell(mesh, grid, visit) {
  for (let e = 0; e < mesh.elements; ++e) {
    const box = elementBox(mesh, e);
    const c0 = Math.floor((box.x0 - grid.x) / grid.width);
    const c1 = Math.min(grid.columns - 1, Math.floor((box.x1 - grid.x) / grid.width));
    const r1 = Math.min(grid.rows - 1, Math.floor((box.y1 - grid.y) / grid.height));
    for (let r = Math.floor((box.y0 - grid.y) / grid.height); r <= r1; ++r) {
      for (let c = c0; c <= c1; ++c) visit(r * grid.columns + c, e);
    }
  }
}

function elementBox(mesh, element) {
  const box = {x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity};
  for (const v of elementVertices(mesh, element)) {
    box.x0 = Math.min(box.x0, mesh.x[v]);
    box.x1 = Math.max(box.x1, mesh.x[v]);
    box.y0 = Math.min(box.y0, mesh.y[v]);
    box.y1 = Math.max(box.y1, mesh.y[v]);
  }
  return box;
}

/** Shape functions of an element at a point, or null when it lies outside. */
function weightsInElement(mesh, element, px, py) {
  const v = elementVertices(mesh, element);
  return v.length === 3 ? triangleWeights(mesh, v[0], v[1], v[2], px, py)
    : quadWeights(mesh, v, px, py);
}

function triangleWeights({x, y}, a, b, c, px, py) {
  const area = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
  const wb = ((px - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (py - y[a])) / area;
  const wc = ((x[b] - x[a]) * (py - y[a]) - (px - x[a]) * (y[b] - y[a])) / area;
  const slack = -1e-9;
  return wb >= slack && wc >= slack && 1 - wb - wc >= slack ? [1 - wb - wc, wb, wc] : null;
}

/** Inverse of the bilinear map by Newton's method, from the middle. */
function quadWeights({x, y}, v, px, py) {
  let [s, t] = [0.5, 0.5];
  for (let i = 0; i < 12; ++i) {
    const w = [(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t];
    const rx = px - w.reduce((sum, wk, k) => sum + wk * x[v[k]], 0);
    const ry = py - w.reduce((sum, wk, k) => sum + wk * y[v[k]], 0);
    const along = (z) => (1 - t) * (z[v[1]] - z[v[0]]) + t * (z[v[2]] - z[v[3]]);
    const across = (z) => (1 - s) * (z[v[3]] - z[v[0]]) + s * (z[v[2]] - z[v[1]]);
    const [xs, xt, ys, yt] = [along(x), across(x), along(y), across(y)];
    const det = xs * yt - xt * ys;
    s += (rx * yt - xt * ry) / det;
    t += (xs * ry - rx * ys) / det;
  }
  const slack = 1e-9;
  if (!(s >= -slack && s <= 1 + slack && t >= -slack && t <= 1 + slack)) return null;
  return [(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t];
}

/** A vertex array inside an element. */
function valueInElement(mesh, {element, weights}, values) {
  return elementVertices(mesh, element)
    .reduce((sum, v, k) => sum + weights[k] * values[v], 0);
}

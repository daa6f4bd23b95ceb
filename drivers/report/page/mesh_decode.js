// From the bytes of a mesh blob (mesh_blob.hpp says what they mean) to a mesh.

const kNoNumberCode = 2 ** 30;
const kZeroCode = -(2 ** 30);

/**
 * {vertices, triangles, quads, elements, edges: counts, corners, sides, centre, x, y (from the
 * centre), curves: {vertices, tags, names}, regions: {tags or null, names}, metric: [xx, xy, yy] or
 * null, quality, edgeLengths: or null, fields: [{name, on, values, isLog}], note}
 */
function decodeMesh(bytes) {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  const arrays = new Map();
  let offset = 4 + length;
  for (const array of header.arrays) {
    const residuals = readPlanes(bytes, offset, array);
    arrays.set(`${array.on}:${array.name}`, {...array, residuals});
    offset += array.count * (array.planes ?? 1);
  }
  return assembleMesh(header, arrays);
}

/** Folded numbers, their lowest bytes first: 0, 1, 2, 3 ... stand for 0, -1, 1, -2 ... */
function readPlanes(bytes, offset, {count, planes = 1}) {
  const numbers = new Float64Array(count);
  for (let i = 0; i < count; ++i) {
    let folded = 0;
    for (let k = planes - 1; k >= 0; --k) folded = folded * 256 + bytes[offset + k * count + i];
    numbers[i] = folded % 2 === 0 ? folded / 2 : -(folded + 1) / 2;
  }
  return numbers;
}

function assembleMesh(header, arrays) {
  const {vertices, triangles, quads, edges, centre, note = ""} = header;
  const corners = readCorners(arrays, 3 * triangles + 4 * quads);
  const sides = meshSides(corners, triangles, vertices);
  const walk = meshWalk(sides);
  const read = (key) => arrays.has(key) ? readValues(arrays.get(key), walk) : null;
  const [x, y] = readPoints(arrays, read("vertex:point-exponent")[0], walk);
  return {vertices, triangles, quads, elements: triangles + quads, edges, corners, sides, centre,
    x, y, note,
    curves: {vertices: read("curve-edge:curve-edge")[0], tags: read("curve-edge:curve-tag")[0],
      names: header.curves},
    regions: {tags: read("element:region")?.[0] ?? null, names: header.regions},
    metric: read("vertex:metric"), quality: read("element:quality")?.[0] ?? null,
    edgeLengths: read("edge:edge-length")?.[0] ?? null,
    fields: readFields(arrays, read)};
}

const kMeshArrays = ["vertex:point-exponent", "vertex:point", "vertex:metric", "element:region",
  "element:quality"];

function readFields(arrays, read) {
  return [...arrays].filter(([key, {on}]) =>
    (on === "vertex" || on === "element") && !kMeshArrays.includes(key))
    .map(([key, {name, on, scale}]) => ({name, on, values: read(key)[0], isLog: scale === "log2"}));
}

function readCorners(arrays, count) {
  const codes = arrays.get("corner:corner-recent").residuals;
  const far = afterPrevious(arrays.get("corner:corner-far").residuals);
  const corners = new Int32Array(count);
  const recent = [];  // latest last
  let [highest, used] = [-1, 0];
  for (let i = 0; i < count; ++i) {
    const code = codes[i];
    const v = code === 0 ? highest + 1 : code < 0 ? far[used++]
      : recent.splice(recent.length - code, 1)[0];
    highest = Math.max(highest, v);
    recent.push(v);
    if (recent.length > 127) recent.shift();
    corners[i] = v;
  }
  return corners;
}

/** One array of numbers for each component. */
function readValues(array, walk) {
  const {residuals, components = 1, after = "nothing"} = array;
  const length = residuals.length / components;
  return Array.from({length: components}, (_, c) => {
    const part = residuals.subarray(c * length, (c + 1) * length);
    const codes = after === "neighbours" ? afterNeighbours(part, walk)
      : after === "previous" ? afterPrevious(part) : part;
    return codes.map((code) => codeValue(code, array));
  });
}

function codeValue(code, {scale = "linear", step = 1}) {
  if (code === kNoNumberCode) return NaN;
  if (scale === "linear") return code * step;
  return code === kZeroCode ? 0 : 2 ** (code * step);
}

function codeNumber(code) {
  return code === kNoNumberCode || code === kZeroCode ? 0 : code;
}

function afterPrevious(residuals) {
  const codes = new Float64Array(residuals.length);
  for (let i = 0; i < codes.length; ++i) {
    codes[i] = residuals[i] + (i === 0 ? 0 : codeNumber(codes[i - 1]));
  }
  return codes;
}

/** Twice the guess for the i-th vertex of the walk. */
function twiceGuess(walk, i, known) {
  const {from, weight} = walk;
  return weight[i] * known(from[4 * i]) + (4 - weight[i]) * known(from[4 * i + 1]) -
    known(from[4 * i + 2]) - known(from[4 * i + 3]);
}

function afterNeighbours(residuals, walk) {
  const codes = new Float64Array(residuals.length);
  const known = (v) => v < 0 ? 0 : codeNumber(codes[v]);
  for (let i = 0; i < codes.length; ++i) {
    codes[walk.vertex[i]] = residuals[i] + Math.floor((twiceGuess(walk, i, known) + 1) / 2);
  }
  return codes;
}

/** Coordinates in units of 2^exponent, guessed in numbers. */
function readPoints(arrays, exponents, walk) {
  const {residuals} = arrays.get("vertex:point");
  const count = exponents.length;
  return [0, 1].map((c) => {
    const values = new Float64Array(count);
    const known = (v) => v < 0 ? 0 : values[v];
    for (let i = 0; i < count; ++i) {
      const unit = 2 ** exponents[walk.vertex[i]];
      const guess = Math.floor(0.5 * twiceGuess(walk, i, known) / unit + 0.5);
      values[walk.vertex[i]] = (guess + residuals[c * count + i]) * unit;
    }
    return values;
  });
}

// Sides of elements, and the order in which vertices are stored: the walk of mesh_walk.hpp.

/**
 * Side s runs from corner s to the next corner of its element; triangles come first.
 * `corners`: the vertices of all elements.
 */
function meshSides(corners, triangles, vertices) {
  const first = new Int32Array(vertices).fill(-1);  // first side that starts at a vertex
  const next = new Int32Array(corners.length).fill(-1);  // next one that starts there
  for (let s = corners.length - 1; s >= 0; --s) {
    next[s] = first[corners[s]];
    first[corners[s]] = s;
  }
  const size = (e) => e < triangles ? 3 : 4;
  const begin = (e) => e < triangles ? 3 * e : 4 * e - triangles;
  const element = (s) => s < 3 * triangles ? Math.floor(s / 3) : (s + triangles) >> 2;
  const vertex = (s, steps) => {
    const e = element(s);
    return corners[begin(e) + (s - begin(e) + steps) % size(e)];
  };
  /** The first side that runs the other way, or -1. */
  const across = (s) => {
    const [a, b] = [corners[s], vertex(s, 1)];
    let other = first[b];
    while (other >= 0 && vertex(other, 1) !== a) other = next[other];
    return other;
  };
  return {corners, triangles, vertices, elements: triangles + (corners.length - 3 * triangles) / 4,
    size, begin, element, vertex, across};
}

/**
 * {vertex, from (four each), weight}: values at a vertex are guessed from those before, half of
 * weight v0 + (4 - weight) v1 - v2 - v3.
 */
function meshWalk(sides) {
  const walk = {vertex: new Int32Array(sides.vertices), from: new Int32Array(4 * sides.vertices),
    weight: new Uint8Array(sides.vertices), count: 0, known: new Uint8Array(sides.vertices)};
  const reached = new Uint8Array(sides.elements);
  for (let e = 0; e < sides.elements; ++e) if (!reached[e]) walkPiece(sides, walk, reached, e);
  for (let v = 0; v < sides.vertices; ++v) addBesideLast(walk, v);
  return walk;
}

function walkPiece(sides, walk, reached, start) {
  for (let k = 0; k < sides.size(start); ++k) {
    addBesideLast(walk, sides.corners[sides.begin(start) + k]);
  }
  reached[start] = 1;
  const queue = [start];
  for (let i = 0; i < queue.length; ++i) {
    const begin = sides.begin(queue[i]);
    for (let side = begin; side < begin + sides.size(queue[i]); ++side) {
      const other = sides.across(side);
      if (other < 0 || reached[sides.element(other)]) continue;
      reached[sides.element(other)] = 1;
      queue.push(sides.element(other));
      addBeyond(sides, walk, side, other);
    }
  }
}

function addBeyond(sides, walk, side, other) {
  const [a, b, c] = [0, 1, 2].map((k) => sides.vertex(side, k));
  const d = sides.vertex(side, sides.size(sides.element(side)) - 1);
  const beyondA = sides.vertex(other, 2);
  if (sides.size(sides.element(other)) === 3) return addGuess(walk, beyondA, a, b, c, d, 2);
  const beyondB = sides.vertex(other, 3);
  if (walk.known[beyondB]) addGuess(walk, beyondA, a, beyondB, b, b, 2);
  else addGuess(walk, beyondA, a, b, c, d, 3);
  addGuess(walk, beyondB, b, beyondA, a, a, 2);
}

function addBesideLast(walk, vertex) {
  const last = walk.count === 0 ? -1 : walk.vertex[walk.count - 1];
  addGuess(walk, vertex, last, last, last, last, 2);
}

function addGuess(walk, vertex, a, b, c, d, weight) {
  if (walk.known[vertex]) return;
  walk.known[vertex] = 1;
  walk.from.set([a, b, c, d], 4 * walk.count);
  walk.weight[walk.count] = weight;
  walk.vertex[walk.count++] = vertex;
}

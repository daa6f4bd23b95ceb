// Draws fills and edges by WebGL 2.

/**
 * Draws on a canvas of its own and copies the result to `target`: a plain canvas can be printed and
 * outlives the card. null where the browser has no WebGL 2; `onLost`: the card has given up.
 */
function createMeshGl(target, onLost) {
  const canvas = document.createElement("canvas");
  const gl = canvas.getContext("webgl2", {antialias: !isGlEmulated(), alpha: false, depth: false,
    powerPreference: "high-performance"});
  if (!gl) return null;
  const fill = glProgram(gl, kFillVertexShader, kFillFragmentShader);
  const edge = glProgram(gl, kEdgeVertexShader, kEdgeFragmentShader);
  if (!fill || !edge) return null;
  canvas.addEventListener("webglcontextlost", onLost, {once: true});
  const state = {gl, fill: {...fill, array: gl.createVertexArray()},
    edge: {...edge, array: gl.createVertexArray()}, buffers: {}, mesh: null};
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  return {
    name: "webgl",
    setMesh: (mesh) => setGlMesh(state, mesh),
    setFill: (colours) => setGlFill(state, colours),
    setEdges: (edges) => setGlEdges(state, edges),
    draw: (camera, look) => {
      [canvas.width, canvas.height] = [target.width, target.height];
      drawGl(state, canvas, camera, look);
      const context = target.getContext("2d", {alpha: false});
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.drawImage(canvas, 0, 0);
    },
  };
}

let glEmulated = null;

/** Whether the processor draws what is meant for a card. */
function isGlEmulated() {
  if (glEmulated !== null) return glEmulated;
  const gl = document.createElement("canvas").getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  glEmulated = /swiftshader|llvmpipe|software|basic render/i.test(name);
  return glEmulated;
}

/** Numbers as pairs of floats: [high x, high y, low x, low y]. */
function splitPoint(target, at, x, y) {
  const [hx, hy] = [Math.fround(x), Math.fround(y)];
  target[at] = hx;
  target[at + 1] = hy;
  target[at + 2] = x - hx;
  target[at + 3] = y - hy;
}

function setGlBuffer({gl, buffers}, name, data) {
  buffers[name] ??= gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffers[name]);
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
}

/** To be called with the buffer bound. */
function useGlAttribute({gl}, part, name, size, stride = 0, offset = 0) {
  const place = part.attribute(name);
  gl.bindVertexArray(part.array);
  gl.enableVertexAttribArray(place);
  gl.vertexAttribPointer(place, size, gl.FLOAT, false, stride, offset);
}

/** A triangle has three corners; a quad is four triangles around its middle. */
function fillCornerCount(mesh) {
  return 3 * mesh.triangles + 12 * mesh.quads;
}

/** Calls write(place, element, vertex, null); in the middle of a quad (place, element, -1, v). */
function forEachFillCorner(mesh, write) {
  let place = 0;
  for (let e = 0; e < mesh.elements; ++e) {
    const v = elementVertices(mesh, e);
    if (v.length === 3) for (let k = 0; k < 3; ++k) write(place++, e, v[k], null);
    else {
      for (let k = 0; k < 4; ++k) {
        write(place++, e, v[k], null);
        write(place++, e, v[(k + 1) % 4], null);
        write(place++, e, -1, v);
      }
    }
  }
}

function middleOf(values, vertices) {
  const [a, b, c, d] = vertices;
  return (values[a] + values[b] + values[c] + values[d]) / 4;
}

function setGlMesh(state, mesh) {
  state.mesh = mesh;
  if (!mesh) return;
  const {x, y} = mesh;
  const corners = new Float32Array(4 * fillCornerCount(mesh));
  forEachFillCorner(mesh, (place, e, v, quad) => splitPoint(corners, 4 * place,
    quad ? middleOf(x, quad) : x[v], quad ? middleOf(y, quad) : y[v]));
  setGlBuffer(state, "corners", corners);
  useGlAttribute(state, state.fill, "corner", 4);
  setGlEnds(state, mesh, meshGeometry(mesh));
  state.cornerCount = corners.length / 4;
}

/** Four vertices for each edge: [near end, far end, room]; two triangles between them. */
function setGlEnds(state, {x, y}, {edges, rooms}) {
  const {gl} = state;
  const kRow = 9;
  const ends = new Float32Array(4 * kRow * rooms.length);
  const triangles = new Uint32Array(6 * rooms.length);
  for (let i = 0; i < rooms.length; ++i) {
    for (let corner = 0; corner < 4; ++corner) {
      const at = kRow * (4 * i + corner);
      const [near, far] = corner < 2 ? [edges[2 * i], edges[2 * i + 1]]
        : [edges[2 * i + 1], edges[2 * i]];
      splitPoint(ends, at, x[near], y[near]);
      splitPoint(ends, at + 4, x[far], y[far]);
      ends[at + 8] = rooms[i];
    }
    triangles.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3], 6 * i);
  }
  setGlBuffer(state, "ends", ends);
  useGlAttribute(state, state.edge, "near", 4, 4 * kRow, 0);
  useGlAttribute(state, state.edge, "far", 4, 4 * kRow, 16);
  useGlAttribute(state, state.edge, "room", 1, 4 * kRow, 32);
  state.edgeTriangles ??= gl.createBuffer();
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, state.edgeTriangles);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
  state.edgeCount = rooms.length;
}

function setGlFill(state, {on, positions, palette}) {
  const {mesh} = state;
  const values = new Float32Array(fillCornerCount(mesh));
  const hasGaps = positions.some((t) => t < 0);
  forEachFillCorner(mesh, (place, e, v, quad) => {
    values[place] = on === "element" ? positions[e] : quad ? middleOf(positions, quad)
      : positions[v];
  });
  if (on === "vertex" && hasGaps) {
    forEachFillCorner(mesh, (place, e) => {
      if (elementVertices(mesh, e).some((v) => positions[v] < 0)) values[place] = -1;
    });
  }
  setGlBuffer(state, "positions", values);
  useGlAttribute(state, state.fill, "position", 1);
  setGlPalette(state, "fillPalette", palette);
}

/** {isShown, positions: or null, palette, width, colour: [r, g, b], alpha, fadeBelow, leastFade} */
function setGlEdges(state, edges) {
  state.edges = edges;
  if (!edges.isShown) return;
  const positions = new Float32Array(4 * state.edgeCount);
  edges.positions?.forEach((t, i) => positions.fill(t, 4 * i, 4 * i + 4));
  setGlBuffer(state, "edgePositions", positions);
  useGlAttribute(state, state.edge, "position", 1);
  if (edges.palette) setGlPalette(state, "edgePalette", edges.palette);
}

function setGlPalette(state, name, palette) {
  const {gl} = state;
  state[name] ??= gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, state[name]);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, kPaletteSize, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, palette);
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) {
    gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  }
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
}

function unitColour(rgb) {
  return rgb.map((value) => value / 255);
}

function drawGl(state, canvas, camera, look) {
  const {gl, mesh} = state;
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(...unitColour(look.surface), 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
  if (!mesh) return;
  useGlPart(state, state.fill, canvas, camera);
  gl.bindTexture(gl.TEXTURE_2D, state.fillPalette);
  gl.drawArrays(gl.TRIANGLES, 0, state.cornerCount);
  if (state.edges?.isShown) drawGlEdges(state, canvas, camera);
}

function drawGlEdges(state, canvas, camera) {
  const {gl, edges, edge: {uniforms}} = state;
  const ratio = canvas.width / camera.width;
  useGlPart(state, state.edge, canvas, camera);
  gl.uniform1f(uniforms.halfWidth, edges.width * ratio / 2);
  gl.uniform1f(uniforms.fadeBelow, edges.fadeBelow * ratio);
  gl.uniform1f(uniforms.leastFade, edges.leastFade);
  gl.uniform1i(uniforms.isColoured, edges.positions ? 1 : 0);
  gl.uniform4f(uniforms.plainColour, ...unitColour(edges.colour), edges.alpha);
  gl.bindTexture(gl.TEXTURE_2D, edges.palette ? state.edgePalette : state.fillPalette);
  gl.drawElements(gl.TRIANGLES, 6 * state.edgeCount, gl.UNSIGNED_INT, 0);
}

function useGlPart({gl, mesh}, part, canvas, camera) {
  const {uniforms} = part;
  const centre = [0, 0, 0, 0];
  splitPoint(centre, 0, camera.x - mesh.centre[0], camera.y - mesh.centre[1]);
  gl.useProgram(part.program);
  gl.bindVertexArray(part.array);
  gl.uniform4fv(uniforms.centre, centre);
  gl.uniform1f(uniforms.scale, camera.scale * canvas.width / camera.width);
  gl.uniform2f(uniforms.halfSize, canvas.width / 2, canvas.height / 2);
  gl.uniform3fv(uniforms.noValue, unitColour(kNoValueColour));
}

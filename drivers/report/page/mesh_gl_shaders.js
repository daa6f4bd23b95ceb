// Programs for the graphics card. Positions come as two floats, the second what the first leaves
// over, and are taken relative to the centre of the view before they are added: so they stay exact
// at any zoom. (The same trick: Cozzi, Ring, 3D Engine Design for Virtual Globes, 2011, ch. 5.)

const kPixelOf = `
uniform vec4 centre;      // of the view: x, y and what they leave over
uniform float scale;      // device pixels per length
uniform vec2 halfSize;    // of the view, device pixels
vec2 pixelOf(vec4 p) {
  return ((p.xy - centre.xy) + (p.zw - centre.zw)) * scale;
}
`;

const kColourOf = `
uniform sampler2D palette;
uniform vec3 noValue;
vec3 colourOf(float t) {
  return t < 0.0 ? noValue : texture(palette, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}
`;

const kFillVertexShader = `#version 300 es
precision highp float;
in vec4 corner;
in float position;
out float t;
${kPixelOf}
void main() {
  t = position;
  gl_Position = vec4(pixelOf(corner) / halfSize, 0, 1);
}`;

const kFillFragmentShader = `#version 300 es
precision highp float;
in float t;
out vec4 colour;
${kColourOf}
void main() {
  colour = vec4(colourOf(t), 1);
}`;

// Each edge is two triangles, a pixel wider than the line: the rim is smooth. Four vertices: two
// on either side of an end; both look towards the other end.
const kEdgeVertexShader = `#version 300 es
precision highp float;
in vec4 near;
in vec4 far;
in float room;
in float position;
uniform float halfWidth;  // device pixels
uniform float fadeBelow;  // room in device pixels
uniform float leastFade;
out float t;
out float offset;
out float fade;
${kPixelOf}
void main() {
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  float turned = (gl_VertexID & 2) == 0 ? 1.0 : -1.0;
  vec2 along = ((far.xy - near.xy) + (far.zw - near.zw)) * scale;
  vec2 normal = vec2(-along.y, along.x) / max(length(along), 1e-20);
  offset = side * turned * (halfWidth + 1.0);
  vec2 pixel = pixelOf(near) + side * (halfWidth + 1.0) * normal;
  t = position;
  fade = clamp(room * scale / fadeBelow, leastFade, 1.0);
  gl_Position = vec4(pixel / halfSize, 0, 1);
}`;

const kEdgeFragmentShader = `#version 300 es
precision highp float;
in float t;
in float offset;
in float fade;
uniform vec4 plainColour;
uniform bool isColoured;
uniform float halfWidth;
out vec4 colour;
${kColourOf}
void main() {
  float cover = clamp(halfWidth + 0.5 - abs(offset), 0.0, 1.0) * min(2.0 * halfWidth, 1.0);
  colour = isColoured ? vec4(colourOf(t), 1) : plainColour;
  colour.a *= cover * fade;
}`;

function glProgram(gl, vertexText, fragmentText) {
  const program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertexText],
    [gl.FRAGMENT_SHADER, fragmentText]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return null;
  const uniforms = {};
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
  for (let i = 0; i < count; ++i) {
    const {name} = gl.getActiveUniform(program, i);
    uniforms[name] = gl.getUniformLocation(program, name);
  }
  return {program, uniforms, attribute: (name) => gl.getAttribLocation(program, name)};
}

// What lies over the mesh: curves, ellipses, marks, the scale bar.

/**
 * `shown`: {mesh, hasEllipses, curve (tag under the pointer or null), hovered, pinned (elements or
 * -1), hasCursor, zoomBox: {a, b} if there is one}
 */
function drawOverlay(canvas, camera, shown, look) {
  const context = canvas.getContext("2d");
  const ratio = canvas.width / camera.width;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  if (shown.mesh) {
    drawCurves(context, camera, shown, look);
    if (shown.hasEllipses) drawEllipses(context, camera, shown.mesh, look);
    drawElementMark(context, camera, shown.mesh, shown.hovered, rgbText(look.accent, 0.9), 1.5);
    drawElementMark(context, camera, shown.mesh, shown.pinned, rgbText(look.accent2), 2.5);
    drawScaleBar(context, camera, look);
  }
  if (shown.hasCursor) drawCursor(context, camera, look);
  if (shown.zoomBox) drawZoomBox(context, shown.zoomBox, look);
}

function vertexPixel(mesh, camera, v) {
  return {x: screenX(camera, mesh.x[v] + mesh.centre[0]),
    y: screenY(camera, mesh.y[v] + mesh.centre[1])};
}

function drawCurves(context, camera, {mesh, curve}, look) {
  context.lineCap = "round";
  strokeCurves(context, camera, mesh, (tag) => tag !== curve, rgbText(look.text, 0.85), 1.6);
  if (curve !== null) {
    strokeCurves(context, camera, mesh, (tag) => tag === curve, rgbText(look.accent), 3.5);
  }
}

function strokeCurves(context, camera, mesh, isMeant, style, width) {
  const {vertices, tags} = mesh.curves;
  context.strokeStyle = style;
  context.lineWidth = width;
  context.beginPath();
  for (let i = 0; i < tags.length; ++i) {
    if (!isMeant(tags[i])) continue;
    for (const k of [0, 1]) {
      const {x, y} = vertexPixel(mesh, camera, vertices[2 * i + k]);
      if (k === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    }
  }
  context.stroke();
}

/** The tag of the curve within a few pixels, or null. */
function curveAtPixel(mesh, camera, px, py) {
  const {vertices, tags} = mesh.curves;
  let [nearest, found] = [7, null];
  for (let i = 0; i < tags.length; ++i) {
    const [a, b] = [0, 1].map((k) => vertexPixel(mesh, camera, vertices[2 * i + k]));
    const distance = distanceToSegment(px, py, a, b);
    if (distance < nearest) [nearest, found] = [distance, tags[i]];
  }
  return found;
}

function distanceToSegment(px, py, a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const t = ((px - a.x) * dx + (py - a.y) * dy) / (dx * dx + dy * dy || 1);
  const along = Math.min(Math.max(t, 0), 1);
  return Math.hypot(px - a.x - along * dx, py - a.y - along * dy);
}

/** At their true size; a halo keeps them apart from what lies below. */
function drawEllipses(context, camera, mesh, look) {
  const ellipses = chooseEllipses(mesh, camera);
  const trace = () => {
    context.beginPath();
    for (const {x, y, h1, h2, angle} of ellipses) {
      const [cx, cy] = [screenX(camera, x), screenY(camera, y)];
      const [long, short] = [h2, h1].map((h) => Math.max(h * camera.scale, 0.75));
      context.moveTo(cx + long * Math.cos(angle), cy - long * Math.sin(angle));
      context.ellipse(cx, cy, long, short, -angle, 0, 2 * Math.PI);
    }
  };
  trace();
  context.lineWidth = 3;
  context.strokeStyle = rgbText(look.surface, 0.55);
  context.stroke();
  context.lineWidth = 1.25;
  context.strokeStyle = rgbText(look.accent2);
  context.stroke();
}

function drawElementMark(context, camera, mesh, element, style, width) {
  if (element < 0) return;
  context.beginPath();
  elementVertices(mesh, element).forEach((v, k) => {
    const {x, y} = vertexPixel(mesh, camera, v);
    if (k === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.closePath();
  context.lineJoin = "round";
  context.strokeStyle = style;
  context.lineWidth = width;
  context.stroke();
}

/** A round length of about a hundred pixels. */
function scaleBarLength(camera) {
  return niceStep(camera.width / camera.scale, Math.max(camera.width / 110, 3));
}

function drawScaleBar(context, camera, look) {
  const length = scaleBarLength(camera);
  const width = length * camera.scale;
  const [x, y] = [14.5, camera.height - 13.5];
  const trace = () => {
    context.beginPath();
    context.moveTo(x, y - 5);
    context.lineTo(x, y);
    context.lineTo(x + width, y);
    context.lineTo(x + width, y - 5);
  };
  trace();
  context.lineCap = "square";
  context.lineJoin = "miter";
  context.lineWidth = 3;
  context.strokeStyle = rgbText(look.surface, 0.8);
  context.stroke();
  context.lineWidth = 1;
  context.strokeStyle = rgbText(look.text);
  context.stroke();
  drawHaloText(context, meshNumber(length), x + width / 2, y - 5, look);
}

function drawHaloText(context, text, x, y, look) {
  context.font = `11.5px ${look.font}`;
  context.textAlign = "center";
  context.textBaseline = "bottom";
  context.lineWidth = 3;
  context.lineJoin = "round";
  context.strokeStyle = rgbText(look.surface, 0.85);
  context.strokeText(text, x, y);
  context.fillStyle = rgbText(look.text);
  context.fillText(text, x, y);
}

function drawCursor(context, camera, look) {
  const [x, y] = [camera.width / 2, camera.height / 2];
  for (const [width, style] of [[3.5, rgbText(look.surface, 0.8)], [1.5, rgbText(look.accent2)]]) {
    context.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(x + 4 * dx, y + 4 * dy);
      context.lineTo(x + 11 * dx, y + 11 * dy);
    }
    context.lineWidth = width;
    context.strokeStyle = style;
    context.stroke();
  }
}

function drawZoomBox(context, {a, b}, look) {
  context.beginPath();
  context.rect(Math.min(a.x, b.x), Math.min(a.y, b.y), Math.abs(a.x - b.x), Math.abs(a.y - b.y));
  context.fillStyle = rgbText(look.accent, 0.12);
  context.fill();
  context.lineWidth = 1;
  context.strokeStyle = rgbText(look.accent);
  context.stroke();
}

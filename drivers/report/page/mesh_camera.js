// What part of the plane is seen: {x, y: centre, scale: pixels per length, width, height}.

const kFitMargin = 26;  // pixels
const kMostZoom = 1e6;  // against the whole mesh

function fitCamera(camera, box) {
  const [w, h] = [box.x1 - box.x0, box.y1 - box.y0];
  const room = (pixels) => Math.max(pixels - 2 * kFitMargin, pixels / 2, 1);
  const scale = Math.min(room(camera.width) / (w || h || 1), room(camera.height) / (h || w || 1));
  Object.assign(camera, {x: (box.x0 + box.x1) / 2, y: (box.y0 + box.y1) / 2, scale,
    fitScale: scale, box});
}

function screenX(camera, x) {
  return camera.width / 2 + (x - camera.x) * camera.scale;
}

function screenY(camera, y) {
  return camera.height / 2 - (y - camera.y) * camera.scale;
}

function worldX(camera, px) {
  return camera.x + (px - camera.width / 2) / camera.scale;
}

function worldY(camera, py) {
  return camera.y - (py - camera.height / 2) / camera.scale;
}

/** The point under a pixel stays where it is. */
function zoomCamera(camera, px, py, factor) {
  const [x, y] = [worldX(camera, px), worldY(camera, py)];
  const fit = camera.fitScale || camera.scale;
  camera.scale = Math.min(Math.max(camera.scale * factor, fit / 20), fit * kMostZoom);
  camera.x = x - (px - camera.width / 2) / camera.scale;
  camera.y = y + (py - camera.height / 2) / camera.scale;
  holdCamera(camera);
}

function panCamera(camera, dx, dy) {
  camera.x -= dx / camera.scale;
  camera.y += dy / camera.scale;
  holdCamera(camera);
}

/** The centre of the view stays over the box of the mesh, so that nobody gets lost. */
function holdCamera(camera) {
  const {box} = camera;
  if (!box) return;
  camera.x = Math.min(Math.max(camera.x, box.x0), box.x1);
  camera.y = Math.min(Math.max(camera.y, box.y0), box.y1);
}

/** A box of pixels becomes the whole view. */
function zoomToPixels(camera, a, b) {
  const [w, h] = [Math.abs(a.x - b.x), Math.abs(a.y - b.y)];
  if (w < 6 || h < 6) return;
  const [x, y] = [worldX(camera, (a.x + b.x) / 2), worldY(camera, (a.y + b.y) / 2)];
  zoomCamera(camera, 0, 0, Math.min(camera.width / w, camera.height / h));
  Object.assign(camera, {x, y});
  holdCamera(camera);
}

/** The part of the plane that is seen. */
function cameraBox(camera) {
  return {x0: worldX(camera, 0), x1: worldX(camera, camera.width),
    y0: worldY(camera, camera.height), y1: worldY(camera, 0)};
}

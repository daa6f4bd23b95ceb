// From the state of a view to its picture.

const kSlowSeconds = 0.06;  // to draw
const kRestSeconds = 0.15;

function requestMeshDraw(view) {
  view.frame ||= requestAnimationFrame(() => drawMeshFrame(view));
}

/** Where drawing takes long, the last picture moves along until the view rests. */
function drawMeshFrame(view) {
  view.frame = 0;
  if (!view.drawn || view.camera.width === 0) return;
  if (isSameView(view.drawn, view.camera)) return drawOver(view);
  if (!(view.drawSeconds > kSlowSeconds)) return drawMeshView(view);
  moveDrawn(view.stage.base, view.drawn, view.camera);
  drawOver(view);
  clearTimeout(view.rest);
  view.rest = setTimeout(() => drawMeshView(view), 1000 * kRestSeconds);
}

function drawMeshView(view) {
  cancelAnimationFrame(view.frame);
  clearTimeout(view.rest);
  view.frame = 0;
  const {camera, stage} = view;
  if (camera.width === 0) return;
  view.look ??= readLook(view.element);
  const start = performance.now();
  stage.base.style.transform = "";
  view.renderer.draw(camera, view.look);
  view.drawn = {...camera};
  requestAnimationFrame((now) => view.drawSeconds = (now - start) / 1000);
  drawOver(view);
  drawLegend(view);
}

function isSameView(a, b) {
  return a.x === b.x && a.y === b.y && a.scale === b.scale;
}

/** The picture of one camera as another one sees it. */
function moveDrawn(canvas, drawn, camera) {
  const dx = screenX(camera, drawn.x) - camera.width / 2;
  const dy = screenY(camera, drawn.y) - camera.height / 2;
  canvas.style.transform = `translate(${dx}px, ${dy}px) scale(${camera.scale / drawn.scale})`;
}

/** On paper there is one canvas: overlays print white where they are empty. */
function drawMeshForPaper(view) {
  drawMeshView(view);
  const {camera, stage, look, mesh} = view;
  if (mesh && camera.width > 0) drawOverlay(stage.base, camera, shownOver(view), look);
}

function drawOver(view) {
  const {camera, stage, mesh} = view;
  const under = pointerInspection(view);
  const pinned = view.pinned && mesh ? inspectMesh(mesh, view.pinned.x, view.pinned.y) : null;
  const context = stage.over.getContext("2d");
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, stage.over.width, stage.over.height);
  drawOverlay(stage.over, camera, {...shownOver(view), curve: under.curve,
    hovered: under.seen ? under.seen.element : -1, pinned: pinned ? pinned.element : -1,
    zoomBox: view.zoomBox, hasCursor: stage.area.matches(":focus-visible")}, view.look);
  placeHover(stage, view.pointer, under.lines);
  showPinned(view, pinned);
}

/** Without what pointer and keys add. */
function shownOver({mesh, hasEllipses}) {
  return {mesh, hasEllipses: hasEllipses && mesh?.metric, curve: null, hovered: -1, pinned: -1};
}

/** What the tooltip says. */
function pointerInspection({mesh, pointer, camera, quantity}) {
  if (!mesh || !pointer) return {seen: null, curve: null, lines: []};
  const curve = curveAtPixel(mesh, camera, pointer.x, pointer.y);
  const seen = inspectMesh(mesh, worldX(camera, pointer.x), worldY(camera, pointer.y));
  const name = curve === null ? "" : mesh.curves.names[curve] || `curve ${curve}`;
  return {seen, curve, lines: hoverLines(seen, quantity, name)};
}

function showPinned(view, pinned) {
  const {panel} = view.stage;
  if (view.isHelp) return;
  panel.hidden = pinned === null;
  view.inspected = pinned;
  const key = pinned && `${view.name} ${view.cycle} ${pinned.element} ${pinned.x} ${pinned.y}`;
  if (pinned && view.panelKey !== key) {
    fillInspector(panel, pinned, view.camera, view.act.close);
  }
  view.panelKey = key;
}

function drawLegend(view) {
  const items = view.mesh ? legendItems(view) : [];
  const {legend, camera} = view;
  legend.hidden = items.length === 0;
  if (legend.hidden) return;
  const ratio = Math.min(window.devicePixelRatio || 1, 3);
  const key = [legendText(items), camera.width, ratio, view.look.surface].join(" ");
  if (legend.dataset.key === key) return;
  legend.dataset.key = key;
  const height = legendHeight(items, camera.width);
  legend.width = camera.width * ratio;
  legend.height = height * ratio;
  legend.style.width = `${camera.width}px`;
  const context = legend.getContext("2d");
  context.scale(ratio, ratio);
  paintLegend(context, items, camera.width, view.look);
  legend.setAttribute("aria-label", legendText(items));
}

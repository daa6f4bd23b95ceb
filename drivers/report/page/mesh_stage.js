// The stage: two canvases, one for the mesh, one for what lies over it; tooltip and panel above.

function createStage(title) {
  const layer = (kind) => htmlElement("canvas", {class: `mesh-${kind}`, "aria-hidden": "true"});
  const stage = {
    base: layer("base"), over: layer("over"),
    hover: htmlElement("div", {class: "mesh-hover", hidden: true, "aria-hidden": "true"}),
    panel: htmlElement("div", {class: "mesh-panel", hidden: true, role: "region",
      "aria-label": "Details"}),
    note: htmlElement("p", {class: "mesh-note", hidden: true}),
  };
  stage.area = htmlElement("div", {class: "mesh-area", tabindex: 0, role: "application",
    "aria-label": `${title}: arrow keys move, plus and minus zoom, 0 shows all, ` +
      "brackets step through the cycles, Enter inspects the element in the middle"},
  stage.base, stage.over);
  stage.element = htmlElement("div", {class: "mesh-stage"}, stage.area, stage.note, stage.hover,
    stage.panel);
  return stage;
}

/**
 * WebGL where a card draws it, else a plain canvas, which is faster without one and smooth at the
 * rims; or as `wanted`: "webgl", "canvas". `onLost` is called when the card gives up.
 */
function createRenderer(canvas, wanted, onLost) {
  const isWebgl = wanted === "webgl" || (wanted !== "canvas" && !isGlEmulated());
  return (isWebgl && createMeshGl(canvas, onLost)) || createMeshCanvas(canvas);
}

/** Fits the canvases to the stage; false when nothing can be seen or nothing has changed. */
function resizeStage(stage, camera) {
  const [width, height] = [stage.area.clientWidth, stage.area.clientHeight];
  const ratio = Math.min(window.devicePixelRatio || 1, 3);
  const pixels = [Math.round(width * ratio), Math.round(height * ratio)];
  if (width === 0 || height === 0) return false;
  if (camera.width === width && camera.height === height && stage.base.width === pixels[0]) {
    return false;
  }
  for (const canvas of [stage.base, stage.over]) [canvas.width, canvas.height] = pixels;
  Object.assign(camera, {width, height});
  return true;
}

/** Beside the pointer, inside the stage. */
function placeHover(stage, at, lines) {
  const {hover, element} = stage;
  hover.hidden = lines.length === 0;
  if (hover.hidden) return;
  hover.replaceChildren(...lines.map((line, i) =>
    htmlElement(i === 0 ? "strong" : "span", {}, line)));
  const left = at.x + 16 + hover.offsetWidth > element.clientWidth
    ? at.x - 12 - hover.offsetWidth : at.x + 16;
  const top = Math.min(at.y + 14, element.clientHeight - hover.offsetHeight - 4);
  hover.style.left = `${Math.max(left, 2)}px`;
  hover.style.top = `${Math.max(top, 2)}px`;
}

// The viewer of meshes: one variant, one cycle after the other.

/**
 * Fills `host`. Options: loadMesh (id => promise of a mesh), title, renderer ("webgl" or "canvas").
 * Returns {show({name, meshes: [{cycle, id, note}]}, cycle?), state(), setState(part of a state),
 * onChange(callback; called after what the reader does, not after setState), element}; it is
 * element.meshView too.
 */
function createMeshView(host, options) {
  const view = {options, stage: createStage(options.title), camera: {width: 0, height: 0},
    name: "", entries: [], cycle: 0, mesh: null, quantities: [], quantity: null, range: null,
    colour: "none", edges: "plain", hasEllipses: false, isSameRange: false,
    pointer: null, pinned: null, listeners: [], request: 0, frame: 0, timer: 0, isFitted: true};
  view.legend = htmlElement("canvas", {class: "mesh-legend", role: "img"});
  view.live = htmlElement("p", {class: "mesh-live", "aria-live": "polite"});
  view.act = meshActions(view);
  view.controls = createMeshControls(view.act);
  view.stage.element.append(view.controls.buttons);
  view.element = htmlElement("div", {class: "mesh-view", role: "group",
    "aria-label": options.title}, view.controls.bar, view.controls.options, view.stage.element,
  htmlElement("div", {class: "mesh-legend-box"}, view.legend), view.live);
  host.append(view.element);
  startRenderer(view);
  watchMeshView(view);
  view.element.meshView = {show: (variant, cycle) => showVariant(view, variant, cycle),
    state: () => meshViewState(view), setState: (state) => setMeshViewState(view, state),
    onChange: (callback) => view.listeners.push(callback), element: view.element};
  return view.element.meshView;
}

function startRenderer(view, wanted = view.options.renderer) {
  view.renderer = createRenderer(view.stage.base, wanted, () => {
    startRenderer(view, "canvas");
    if (view.mesh) placeMesh(view, view.mesh);
  });
}

function watchMeshView(view) {
  watchPointers(view.stage.area, view.act);
  watchKeys(view.stage.area, view.act);
  for (const kind of ["focus", "blur"]) {
    view.stage.area.addEventListener(kind, () => requestMeshDraw(view));
  }
  new ResizeObserver(() => fitStage(view)).observe(view.stage.area);
  const redraw = (draw) => {
    view.look = null;
    colourMesh(view);
    draw(view);
  };
  document.addEventListener("themechange", () => redraw(drawMeshView));
  window.addEventListener("beforeprint", () => redraw(drawMeshForPaper));
  window.addEventListener("afterprint", () => redraw(drawMeshView));
}

function fitStage(view) {
  if (window.matchMedia("print").matches) return;  // on paper the picture is scaled as it is
  if (!resizeStage(view.stage, view.camera)) return;
  if (view.mesh && (view.isFitted || !view.camera.scale)) {
    fitCamera(view.camera, worldBox(view.mesh));
  }
  drawMeshView(view);
}

function worldBox(mesh) {
  const {box} = meshGeometry(mesh);
  const [cx, cy] = mesh.centre;
  return {x0: box.x0 + cx, x1: box.x1 + cx, y0: box.y0 + cy, y1: box.y1 + cy};
}

/** Shows another variant: the cycle given or the same as before, or else the last one. */
function showVariant(view, {name, meshes}, cycle = view.cycle) {
  const isFirst = view.name === "";
  Object.assign(view, {name, entries: meshes});
  fillStepper(view.controls.stepper, meshes, view.act);
  const wanted = !isFirst && meshes.find((entry) => entry.cycle === cycle && entry.id !== null);
  const drawable = meshes.filter((entry) => entry.id !== null);
  return goToEntry(view, wanted || drawable.at(-1) || meshes.at(-1));
}

async function goToEntry(view, entry) {
  if (!entry) return;
  view.cycle = entry.cycle;
  markStepper(view.controls.stepper, view.entries, view.cycle);
  const request = ++view.request;
  try {
    const mesh = entry.id === null ? null : await view.options.loadMesh(entry.id);
    if (view.request !== request) return;
    const note = mesh ? mesh.note : entry.note || "There is no mesh of this cycle.";
    setMesh(view, mesh, note);
  } catch (error) {
    if (view.request === request) setMesh(view, null, `The mesh cannot be read: ${error.message}`);
  }
  if (view.isSameRange) await uniteRanges(view, request);
}

function setMesh(view, mesh, note) {
  view.mesh = mesh;
  view.stage.note.textContent = note;
  view.stage.note.hidden = !note;
  view.controls.numbers.textContent = mesh ? numbersText(mesh) : "";
  if (mesh) placeMesh(view, mesh);
  else {
    view.renderer.setMesh(null);
    drawMeshView(view);
  }
  view.live.textContent = mesh ? `${view.name}, cycle ${view.cycle}: ${numbersText(mesh)}` : note;
}

function placeMesh(view, mesh) {
  resizeStage(view.stage, view.camera);
  const box = worldBox(mesh);
  const isKnown = view.camera.box && isSameBox(view.camera.box, box);
  if (!isKnown && view.camera.width > 0) {
    fitCamera(view.camera, box);
    view.isFitted = true;
  }
  view.renderer.setMesh(mesh);
  view.quantities = meshQuantities(mesh);
  fillColourList(view.controls.colour, view.quantities);
  colourMesh(view);
  drawMeshView(view);
}

function isSameBox(a, b) {
  const slack = 0.02 * Math.max(b.x1 - b.x0, b.y1 - b.y0);
  return ["x0", "x1", "y0", "y1"].every((key) => Math.abs(a[key] - b[key]) <= slack);
}

// What the reader does to a view, and its state as others see it.

const kPlaySeconds = 0.9;

function meshViewState(view) {
  const {camera, mesh, range} = view;
  return {cycle: view.cycle, colour: view.quantity ? view.quantity.key : view.colour,
    edges: view.edges, ellipses: view.hasEllipses, sameRange: view.isSameRange, range,
    view: {centre: [camera.x, camera.y], scale: camera.scale}, renderer: view.renderer.name,
    inspected: view.mesh && view.pinned ? view.inspected : null,
    legend: mesh ? legendText(legendItems(view)) : "",
    counts: mesh ? {vertices: mesh.vertices, elements: mesh.elements, triangles: mesh.triangles,
      quads: mesh.quads, edges: mesh.edges, percentInBand: percentInBand(mesh)} : null};
}

/** Takes what it can of a state, as of another view; a promise of the drawn result. */
async function setMeshViewState(view, state) {
  const before = lookKey(view);
  view.colour = state.colour ?? view.colour;
  view.edges = state.edges ?? view.edges;
  view.hasEllipses = state.ellipses ?? view.hasEllipses;
  view.isSameRange = state.sameRange ?? view.isSameRange;
  if (state.inspected !== undefined) {
    view.pinned = state.inspected && {x: state.inspected.x, y: state.inspected.y};
  }
  if (state.view) {
    const {centre: [x, y], scale} = state.view;
    Object.assign(view.camera, {x, y, scale});
    view.isFitted = false;
  }
  const entry = view.entries.find(({cycle}) => cycle === state.cycle);
  if (entry && entry.cycle !== view.cycle) await goToEntry(view, entry);
  else if (lookKey(view) !== before) {
    colourMesh(view);
    if (view.isSameRange) await uniteRanges(view);
  }
  drawMeshView(view);
}

function lookKey({colour, edges, hasEllipses, isSameRange}) {
  return [colour, edges, hasEllipses, isSameRange].join(" ");
}

/** After something the reader has done. */
function meshChanged(view) {
  requestMeshDraw(view);
  for (const callback of view.listeners) callback(meshViewState(view));
}

/** Everything that buttons, keys and pointers can do. */
function meshActions(view) {
  return {...cameraActions(view), ...cycleActions(view), ...lookActions(view),
    ...inspectActions(view)};
}

function cameraActions(view) {
  const {camera} = view;
  const moved = (move) => {
    if (!view.mesh) return;
    move();
    view.isFitted = false;
    meshChanged(view);
  };
  const pan = (dx, dy) => moved(() => panCamera(camera, dx, dy));
  const zoom = (x, y, factor) => moved(() => zoomCamera(camera, x, y, factor));
  const zoomMiddle = (factor) => zoom(camera.width / 2, camera.height / 2, factor);
  const [step, factor] = [60, 1.5];
  return {pan, zoom,
    left: () => pan(step, 0), right: () => pan(-step, 0),
    up: () => pan(0, step), down: () => pan(0, -step),
    in: () => zoomMiddle(factor), out: () => zoomMiddle(1 / factor),
    fit: () => moved(() => fitCamera(camera, worldBox(view.mesh))),
    zoomTo: (a, b) => moved(() => zoomToPixels(camera, a, b)),
    zoomBox: (box) => {
      view.zoomBox = box;
      requestMeshDraw(view);
    }};
}

function cycleActions(view) {
  const goTo = async (cycle) => {
    await goToEntry(view, view.entries.find((entry) => entry.cycle === cycle));
    meshChanged(view);
  };
  const index = () => view.entries.findIndex(({cycle}) => cycle === view.cycle);
  const step = (by) => {
    const entry = view.entries[index() + by];
    if (entry) goTo(entry.cycle);
    return Boolean(entry);
  };
  const pause = () => {
    clearInterval(view.timer);
    view.timer = 0;
    markPlay(view.controls.play, false);
  };
  const play = () => {
    if (view.timer) return pause();
    if (index() === view.entries.length - 1 && view.entries.length > 0) goTo(view.entries[0].cycle);
    view.timer = setInterval(() => step(1) || pause(), 1000 * kPlaySeconds);
    markPlay(view.controls.play, true);
  };
  return {goTo, step, play, previous: () => step(-1), next: () => step(1)};
}

function markPlay(button, isPlaying) {
  const label = isPlaying ? "Pause" : "Play the cycles";
  setAttributes(button, {"aria-label": label, title: label});
  button.replaceChildren(meshIcon(isPlaying ? "pause" : "play"));
}

function lookActions(view) {
  const set = (state) => setMeshViewState(view, state).then(() => meshChanged(view));
  const following = (values, value) => values[(values.indexOf(value) + 1) % values.length];
  return {
    setColour: (colour) => set({colour}),
    setEdges: (edges) => set({edges}),
    setEllipses: (ellipses) => set({ellipses}),
    setSameRange: (sameRange) => set({sameRange}),
    colour: () => set({colour: following(view.quantities.map(({key}) => key), view.quantity?.key)}),
    edges: () => set({edges: following(["hidden", "plain", "length"], view.edges)}),
    ellipses: () => set({ellipses: !view.hasEllipses}),
    save: () => savePicture(view),
    full: () => document.fullscreenElement ? document.exitFullscreen()
      : view.element.requestFullscreen?.(),
  };
}

function inspectActions(view) {
  const {camera} = view;
  const pin = (x, y) => {
    view.isHelp = false;
    view.pinned = {x, y};
    meshChanged(view);
  };
  let before = null;
  return {
    hover: (at) => {
      view.pointer = at;
      requestMeshDraw(view);
    },
    click: ({x, y}) => {
      before = view.pinned;
      pin(worldX(camera, x), worldY(camera, y));
    },
    doubleClick: ({x, y}, isOut) => {
      view.pinned = before;
      view.act.zoom(x, y, isOut ? 0.5 : 2);
    },
    inspect: () => {
      pin(camera.x, camera.y);
      drawMeshView(view);
      if (view.inspected) view.live.textContent = inspectionText(view.inspected, camera);
    },
    close: () => closePanel(view),
    help: () => {
      view.isHelp = true;
      view.panelKey = null;
      view.stage.panel.hidden = false;
      fillKeyHelp(view.stage.panel, view.act.close);
    },
  };
}

function closePanel(view) {
  if (!view.isHelp && !view.pinned) return false;
  if (!view.isHelp) view.pinned = null;
  view.isHelp = false;
  view.stage.area.focus({preventScroll: true});
  meshChanged(view);
  return true;
}

function inspectionText(seen, camera) {
  return `${elementTitle(seen)}: ` +
    inspectionRows(seen, camera).map(([label, text]) => `${label} ${text}`).join("; ");
}

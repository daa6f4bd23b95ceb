// Mouse, touch and wheel on the stage.

const kWheelLatch = 250;  // milliseconds in which a wheel keeps doing what it has begun

/**
 * `act`: {pan(dx, dy), zoom(x, y, factor), hover({x, y} or null), click({x, y}),
 * doubleClick({x, y}, isOut), zoomBox({a, b} or null), zoomTo(a, b)}; pixels of the stage.
 */
function watchPointers(stage, act) {
  const pointers = new Map();
  const gesture = {moved: false, box: null, last: null};
  const place = (event) => {
    const rim = stage.getBoundingClientRect();
    return {x: event.clientX - rim.left, y: event.clientY - rim.top};
  };
  stage.addEventListener("pointerdown", (event) => {
    if (event.button > 0) return;
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
    startGesture(gesture, pointers, event.shiftKey && pointers.size === 1);
  });
  stage.addEventListener("pointermove", (event) => {
    if (pointers.has(event.pointerId)) {
      movePointer(gesture, pointers, event.pointerId, place(event), act);
    } else act.hover(place(event));
  });
  const end = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (gesture.box) endBox(gesture, act);
    startGesture(gesture, pointers, false, true);
  };
  stage.addEventListener("pointerup", end);
  stage.addEventListener("pointercancel", end);
  stage.addEventListener("pointerleave", () => act.hover(null));
  stage.addEventListener("click", (event) => {
    if (!gesture.moved && event.detail < 2) act.click(place(event));
  });
  stage.addEventListener("dblclick", (event) => act.doubleClick(place(event), event.shiftKey));
  watchWheel(stage, place, act);
}

/** The middle of the fingers and their distance. */
function pointerSpread(pointers) {
  const all = [...pointers.values()];
  const mean = (key) => all.reduce((sum, p) => sum + p[key], 0) / all.length;
  const [x, y] = [mean("x"), mean("y")];
  return {x, y, spread: all.length < 2 ? 0 : Math.hypot(all[0].x - x, all[0].y - y)};
}

function startGesture(gesture, pointers, isBox, keepMoved = false) {
  gesture.last = pointers.size > 0 ? pointerSpread(pointers) : null;
  gesture.box = isBox ? {a: gesture.last, b: gesture.last} : null;
  if (!keepMoved && pointers.size === 1) gesture.moved = false;
}

function movePointer(gesture, pointers, id, at, act) {
  const before = pointers.get(id);
  if (!gesture.moved && Math.hypot(at.x - before.x, at.y - before.y) < 3) return;
  gesture.moved = true;
  pointers.set(id, at);
  const now = pointerSpread(pointers);
  if (gesture.box) {
    gesture.box.b = now;
    act.zoomBox(gesture.box);
    return;
  }
  act.pan(now.x - gesture.last.x, now.y - gesture.last.y);
  if (gesture.last.spread > 0) act.zoom(now.x, now.y, now.spread / gesture.last.spread);
  gesture.last = now;
}

function endBox(gesture, act) {
  act.zoomBox(null);
  if (gesture.moved) act.zoomTo(gesture.box.a, gesture.box.b);
}

/** A wheel that scrolls the page goes on doing so when the stage comes under the pointer. */
function watchWheel(stage, place, act) {
  let [lastScroll, lastZoom] = [-Infinity, -Infinity];
  window.addEventListener("scroll", () => lastScroll = performance.now(), {passive: true});
  stage.addEventListener("wheel", (event) => {
    const now = performance.now();
    if (now - lastScroll < kWheelLatch && now - lastZoom > kWheelLatch && !event.ctrlKey) return;
    event.preventDefault();
    lastZoom = now;
    const pixels = event.deltaY * (event.deltaMode === 1 ? 20 : event.deltaMode === 2 ? 400 : 1);
    const {x, y} = place(event);
    const factor = Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0018));
    act.zoom(x, y, Math.min(Math.max(factor, 0.2), 5));
  }, {passive: false});
}

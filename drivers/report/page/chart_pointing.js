// Exact values by mouse and by keyboard, and zooming by a drag.

function addPointing(chart, svg, area, scaleX) {
  const overlay = svgElement("g", {class: "overlay"});
  svg.append(overlay);
  chart.overlay = overlay;
  svg.addEventListener("pointermove", (event) => pointAt(chart, svg, event));
  svg.addEventListener("pointerleave", () => leaveChart(chart));
  svg.addEventListener("blur", () => leaveChart(chart));
  svg.addEventListener("keydown", (event) => walkByKey(chart, event));
  svg.addEventListener("click", () => pickFocused(chart));
  if (chart.spec.canZoom) addZoomDrag(chart, svg, area, scaleX);
}

function leaveChart(chart) {
  hideTooltip(chart);
  chart.overlay.replaceChildren();
}

/** Place of an event in the drawing's own pixels. */
function placeInDrawing(chart, svg, event) {
  const box = svg.getBoundingClientRect();
  const scale = chart.width / (box.width || 1);
  return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
}

function pointAt(chart, svg, event) {
  const [x, y] = placeInDrawing(chart, svg, event);
  const weight = chart.spec.isByX ? 0.01 : 1;
  const distance = (shown) => (shown.sx - x) ** 2 + weight * (shown.sy - y) ** 2;
  let nearest = null;
  for (const shown of chart.shown) {
    if (!nearest || distance(shown) < distance(nearest)) nearest = shown;
  }
  if (nearest && distance(nearest) < 45 ** 2) focusPoint(chart, nearest);
  else leaveChart(chart);
}

function focusPoint(chart, shown) {
  if (chart.focus === shown) return;
  const {spec} = chart;
  const all = spec.isByX ? chart.shown.filter((s) => Math.abs(s.sx - shown.sx) < 0.5) : [shown];
  chart.overlay.replaceChildren(...all.map((s) => svgElement("circle",
    {cx: s.sx, cy: s.sy, r: 6, class: "focus-ring", style: `stroke:${s.series.color}`})));
  const {title, rows} = spec.isByX ? describeAll(chart, all) : spec.describe(shown.point);
  showTooltip(chart, shown.sx, shown.sy, title, rows);
  chart.focus = shown;
}

/** Rows for every series at one x, the largest value first. */
function describeAll(chart, all) {
  const sorted = [...all].sort((a, b) => a.sy - b.sy);
  const title = chart.spec.describeX ? chart.spec.describeX(all[0].point)
    : `${chart.spec.x.label} ${exactText(all[0].point.x)}`;
  return {title, rows: sorted.map(({point, series}) => [series.name, exactText(point.y), series])};
}

/** Left and right along a series, up and down between the series, Enter picks. */
function walkByKey(chart, event) {
  const steps = {ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0]};
  if (event.key === "Escape") leaveChart(chart);
  if (event.key === "Enter") pickFocused(chart);
  if (!(event.key in steps) || chart.shown.length === 0) return;
  event.preventDefault();
  const [seriesStep, pointStep] = steps[event.key];
  focusPoint(chart, chart.focus ? steppedPoint(chart, seriesStep, pointStep) : chart.shown[0]);
}

function steppedPoint(chart, seriesStep, pointStep) {
  const {shown, focus} = chart;
  const names = [...new Set(shown.map((s) => s.series))];
  const wanted = (names.indexOf(focus.series) + seriesStep + names.length) % names.length;
  const same = shown.filter((s) => s.series === names[wanted]);
  if (seriesStep !== 0) {
    return same.reduce((a, b) => (Math.abs(b.sx - focus.sx) < Math.abs(a.sx - focus.sx) ? b : a));
  }
  const index = same.indexOf(focus) + pointStep;
  return same[Math.min(Math.max(index, 0), same.length - 1)];
}

function pickFocused(chart) {
  if (chart.focus && chart.spec.onPick) chart.spec.onPick(chart.focus.point, chart.focus.series);
}

function zoomTo(chart, range) {
  chart.zoom = range;
  chart.wholeRange.hidden = range === null;
  redrawChart(chart);
}

/** A drag along x shows what it spans; a double click shows all again. */
function addZoomDrag(chart, svg, area, scaleX) {
  let start = null;
  const inside = (event) =>
    Math.min(Math.max(placeInDrawing(chart, svg, event)[0], area.left), area.right);
  svg.classList.add("zooms");
  svg.addEventListener("pointerdown", (event) => {
    start = inside(event);
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", (event) => {
    if (start !== null) drawZoomSpan(chart, area, start, inside(event));
  });
  svg.addEventListener("pointerup", (event) => {
    const end = inside(event);
    const range = [start, end].sort((a, b) => a - b).map((x) => scaleX.invert(x));
    if (start !== null && Math.abs(end - start) > 8) zoomTo(chart, range);
    start = null;
  });
  svg.addEventListener("dblclick", () => zoomTo(chart, null));
}

function drawZoomSpan(chart, area, from, to) {
  chart.overlay.append(svgElement("rect", {class: "zoom-box", x: Math.min(from, to), y: area.top,
    width: Math.abs(to - from), height: area.bottom - area.top}));
}

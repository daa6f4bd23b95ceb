// The frame of a plot: grid, ticks, labels, bands and reference lines.

const kCharWidth = 6.7;

/** Room round the plot for ticks and labels, in pixels. */
function plotMargins(spec, rangeY, height) {
  const ticks = axisTicks(rangeY[0], rangeY[1], spec.y.isLog, height - 70);
  const widest = Math.max(...ticks.map((tick) => tick.label.length), 1);
  return {left: Math.max(54, Math.ceil(widest * kCharWidth) + 14), right: 14, top: 26, bottom: 40};
}

function drawAxes(svg, spec, area, scaleX, scaleY) {
  const group = svgElement("g", {class: "axes"});
  for (const tick of scaleX.ticks) {
    const x = round(scaleX.at(tick.value));
    group.append(gridLine(tick, x, area.top, x, area.bottom));
    if (tick.label) group.append(axisText(tick.label, x, area.bottom + 16, "middle"));
  }
  for (const tick of scaleY.ticks) {
    const y = round(scaleY.at(tick.value));
    group.append(gridLine(tick, area.left, y, area.right, y));
    if (tick.label) group.append(axisText(tick.label, area.left - 7, y + 4, "end"));
  }
  group.append(
    svgElement("path",
      {class: "axis", d: `M${area.left} ${area.top}V${area.bottom}H${area.right}`}),
    axisText(spec.y.label, 2, 13, "start", "axis-label"),
    axisText(spec.x.label, area.right, area.bottom + 34, "end", "axis-label"));
  svg.append(group);
}

function gridLine(tick, x1, y1, x2, y2) {
  return svgElement("line", {x1, y1, x2, y2, class: tick.isMinor ? "grid minor" : "grid"});
}

function axisText(text, x, y, anchor, name = "tick") {
  return svgElement("text", {x, y, "text-anchor": anchor, class: name}, text);
}

/** Vertical bands [{from, to, label}] behind everything. */
function drawBands(svg, spec, area, scaleX) {
  for (const band of spec.bands || []) {
    const left = Math.max(scaleX.at(band.from), area.left);
    const right = Math.min(scaleX.at(band.to), area.right);
    if (right <= left) continue;
    svg.append(svgElement("rect", {class: "band", x: round(left), y: area.top,
      width: round(right - left), height: area.bottom - area.top},
    svgElement("title", {}, band.label)));
  }
}

/** Horizontal reference lines [{y, label}]. */
function drawRules(svg, spec, area, scaleY) {
  for (const rule of spec.rules || []) {
    const y = round(scaleY.at(rule.y));
    if (!(y >= area.top && y <= area.bottom)) continue;
    svg.append(svgElement("line", {class: "rule", x1: area.left, x2: area.right, y1: y, y2: y}));
  }
}

/** Lines y = level x^slope from x to x with their slope beside them (log-log plots). */
function drawSlopes(svg, spec, area, scaleX, scaleY) {
  for (const {slope, level, from, to, label} of spec.slopes || []) {
    const at = (x) => [round(scaleX.at(x)), round(scaleY.at(level * x ** slope))];
    const [[x1, y1], [x2, y2]] = [at(from), at(to)];
    svg.append(svgElement("line", {class: "slope", x1, y1, x2, y2}),
      axisText(label, (x1 + x2) / 2 - 4, (y1 + y2) / 2 + 16, "end", "tick slope-label"));
  }
}

// Horizontal bars, side by side or stacked.

/**
 * `spec`: {name, title, note?, x: {label}, isStacked?, series: [{name, color}], rows: [{label,
 * values: one per series, text?}], csv?, unit?}. Its height follows from the rows.
 */
function createBarChart(host, spec) {
  const chart = createChartFrame(host, withBarSpec(spec), drawBarChart);
  const update = (newSpec) => updateChart(chart, withBarSpec(newSpec));
  update(spec);
  return {update, element: chart.figure};
}

function rowHeight(spec) {
  return spec.isStacked ? 24 : 12 * spec.series.length + 12;
}

/** Completes a spec by its height, its table and the look of its series. */
function withBarSpec(spec) {
  const series = spec.series.map((s, index) => ({...s, isBar: true, index}));
  const csv = spec.csv || {
    header: [spec.rowLabel || "row", ...series.map((s) => s.name)],
    rows: spec.rows.map((row) => [row.label, ...row.values]),
  };
  const describe = (point) => ({
    title: point.row.label,
    rows: series.map((s, i) => [s.name, exactText(point.row.values[i]), s]),
  });
  return {describe, ...spec, series, csv, height: spec.rows.length * rowHeight(spec) + 62};
}

function drawBarChart(chart) {
  const {spec} = chart;
  const series = visibleSeries(chart);
  const svg = emptyDrawing(chart, spec.height, `${spec.title}. Arrow keys walk through the bars.`);
  const longest = Math.max(...spec.rows.map((row) => row.label.length));
  const labelWidth = Math.min(longest * kCharWidth + 10, chart.width * 0.42);
  const area = {left: labelWidth, right: chart.width - 64, top: 22, bottom: spec.height - 40};
  const scale = createScale({from: 0, to: largestBar(spec, series) || 1, isLog: false,
    start: area.left, end: area.right});
  drawBarAxis(svg, spec, area, scale);
  chart.shown = spec.rows.flatMap((row, i) => drawBarRow(svg, chart, row, i, area, scale, series));
  addPointing(chart, svg, area, scale);
}

function largestBar(spec, series) {
  const shown = (row) => series.map((s) => row.values[s.index] || 0);
  const sum = (values) => values.reduce((a, b) => a + b, 0);
  const size = (values) => (spec.isStacked ? sum(values) : Math.max(...values, 0));
  return Math.max(...spec.rows.map((row) => size(shown(row))));
}

function drawBarAxis(svg, spec, area, scale) {
  const group = svgElement("g", {class: "axes"});
  for (const tick of scale.ticks) {
    const x = round(scale.at(tick.value));
    group.append(gridLine(tick, x, area.top - 6, x, area.bottom),
      axisText(tick.label, x, area.bottom + 16, "middle"));
  }
  group.append(axisText(spec.x.label, area.right, area.bottom + 34, "end", "axis-label"));
  svg.append(group);
}

/** A label cut to its room, whole in its title. */
function barLabel(label, y, width) {
  const room = Math.floor((width - 8) / kCharWidth);
  const text = label.length > room ? label.slice(0, Math.max(room - 1, 1)) + "…" : label;
  return svgElement("text", {x: width - 8, y, "text-anchor": "end", class: "tick row-label"}, text,
    svgElement("title", {}, label));
}

function drawBarRow(svg, chart, row, index, area, scale, series) {
  const {spec} = chart;
  const top = area.top + index * rowHeight(spec);
  svg.append(barLabel(row.label, top + rowHeight(spec) / 2, area.left));
  let reached = 0;
  const shown = series.map((s, i) => {
    const value = row.values[s.index];
    const y = spec.isStacked ? top : top + 12 * i;
    const place = drawBar(svg, s, scale, spec.isStacked ? reached : 0, value || 0, y,
      spec.isStacked ? 16 : 10);
    if (!spec.isStacked) svg.append(barValue(value, place));
    reached += value || 0;
    return {...place, point: {row, value}, series: s};
  });
  if (spec.isStacked) svg.append(barValue(reached, {right: scale.at(reached), sy: top + 8}));
  return shown;
}

function drawBar(svg, series, scale, from, value, y, thickness) {
  const [left, right] = [scale.at(from), scale.at(from + value)];
  svg.append(svgElement("rect", {class: "bar", style: `fill:${series.color}`, x: round(left), y,
    width: round(Math.max(right - left, 0)), height: thickness}));
  return {sx: (left + right) / 2, sy: y + thickness / 2, right};
}

function barValue(value, {right, sy}) {
  const digits = (v) => (v >= 100 ? v.toFixed(0) : String(Number(v.toPrecision(3))));
  const text = isNumber(value) ? digits(value) : kUnknown;
  return axisText(text, right + 5, sy + 4, "start", "tick bar-value");
}

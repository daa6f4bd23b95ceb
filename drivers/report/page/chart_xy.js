// Charts of lines and points over linear or logarithmic axes.

/**
 * `spec`: {name, title, note?, height, x, y, series, bands?, rules?, slopes?, legend?, csv?,
 * describe(point), onPick?, isByX?, canZoom?}; an axis: {label, isLog?, min?, max?}; a
 * series: {name, color, marker?, dash?, width?, hasLine?, isHollow?, isFaint?, points}; a point:
 * {x, y, ...}. `isByX`: the tooltip tells all series at one x. Returns {update(spec)}.
 */
function createXyChart(host, spec) {
  const chart = createChartFrame(host, spec, drawXyChart);
  chart.zoom = null;
  chart.wholeRange = smallButton("whole range", "Show all again", () => zoomTo(chart, null));
  chart.wholeRange.hidden = true;
  chart.tools.prepend(chart.wholeRange);
  const update = (newSpec) => {
    chart.zoom = newSpec.name === chart.spec.name && newSpec.x.isLog === chart.spec.x.isLog
      ? chart.zoom : null;
    chart.wholeRange.hidden = chart.zoom === null;
    updateChart(chart, newSpec);
  };
  update(spec);
  return {update, element: chart.figure};
}

function drawXyChart(chart) {
  const {spec} = chart;
  const series = visibleSeries(chart);
  const svg = emptyDrawing(chart, spec.height,
    `${spec.title}. Arrow keys walk through the points.`);
  const ranges = chartRanges(chart, series);
  if (!ranges) {
    svg.append(axisText("nothing to show", chart.width / 2, spec.height / 2, "middle"));
    return;
  }
  const area = plotArea(chart, ranges);
  const scaleX = createScale({from: ranges.x[0], to: ranges.x[1], isLog: spec.x.isLog,
    start: area.left, end: area.right});
  const scaleY = createScale({from: ranges.y[0], to: ranges.y[1], isLog: spec.y.isLog,
    start: area.bottom, end: area.top});
  drawBands(svg, spec, area, scaleX);
  drawAxes(svg, spec, area, scaleX, scaleY);
  const clipped = clippedGroup(svg, area);
  drawRules(clipped, spec, area, scaleY);
  drawSlopes(clipped, spec, area, scaleX, scaleY);
  chart.shown = series.flatMap((s) => drawSeries(clipped, s, scaleX, scaleY))
    .filter(({sx}) => sx >= area.left - 1 && sx <= area.right + 1);
  addPointing(chart, svg, area, scaleX);
}

function plotArea(chart, ranges) {
  const {height} = chart.spec;
  const margin = plotMargins(chart.spec, ranges.y, height);
  return {left: margin.left, right: chart.width - margin.right, top: margin.top,
    bottom: height - margin.bottom};
}

/** What the axes span: the spec's limits, else all that is shown; null without any point. */
function chartRanges(chart, series) {
  const {spec, zoom} = chart;
  const points = series.flatMap((s) => s.points);
  const x = zoom || axisRange(spec.x, points.map((p) => p.x));
  const inside = x ? points.filter((p) => p.x >= x[0] && p.x <= x[1]) : [];
  const ends = (spec.slopes || []).map(({level, to, slope}) => level * to ** slope);
  const y = axisRange(spec.y, [...inside.map((p) => p.y), ...ends]);
  return x && y ? {x, y} : null;
}

function axisRange(axis, values) {
  const range = valueRange(values, axis.isLog);
  return range && [axis.min ?? range[0], axis.max ?? range[1]];
}

let clipCount = 0;

function clippedGroup(svg, area) {
  const id = `clip-${++clipCount}`;
  const [width, height] = [area.right - area.left + 12, area.bottom - area.top + 12];
  const group = svgElement("g", {"clip-path": `url(#${id})`});
  svg.append(svgElement("clipPath", {id},
    svgElement("rect", {x: area.left - 6, y: area.top - 6, width, height})), group);
  return group;
}

/** Returns the drawn points: [{sx, sy, point, series}]. */
function drawSeries(svg, series, scaleX, scaleY) {
  const runs = shownRuns(series.points, scaleX, scaleY);
  const group = svgElement("g", {class: series.isFaint ? "series faint" : "series"});
  for (const run of runs) {
    if (series.hasLine !== false && run.length > 1) group.append(lineMark(series, linePath(run)));
  }
  const drawn = runs.flat();
  if (series.marker) {
    for (const {sx, sy} of drawn) group.append(pointMark(series, sx, sy, series.size || 3.6));
  }
  svg.append(group);
  return drawn.map((place) => ({...place, series}));
}

// Lines, markers and what they look like in legends.

/** Outline of a marker round (x, y); `r`: its size in pixels. */
function markerPath(kind, x, y, r) {
  const polygon = (points) =>
    "M" + points.map(([dx, dy]) => `${round(x + dx * r)} ${round(y + dy * r)}`).join("L") + "Z";
  if (kind === "square") return polygon([[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]]);
  if (kind === "triangle") return polygon([[0, -1.25], [1.1, 0.8], [-1.1, 0.8]]);
  if (kind === "triangle-down") return polygon([[0, 1.25], [1.1, -0.8], [-1.1, -0.8]]);
  if (kind === "diamond") return polygon([[0, -1.3], [1.3, 0], [0, 1.3], [-1.3, 0]]);
  const s = round(r);
  return `M${round(x - r)} ${round(y)}a${s} ${s} 0 1 0 ${2 * s} 0a${s} ${s} 0 1 0 ${-2 * s} 0Z`;
}

const kMarkers = ["circle", "square", "triangle", "diamond", "triangle-down"];

/** Colours are properties of the style sheet, so that they follow the theme. */
function seriesColor(index) {
  return `var(--series-${index % 8 + 1})`;
}

/** From pale to strong over the cycles; the initial mesh is grey. */
function cycleColor(index, count) {
  if (index === 0 && count > 1) return "var(--cycle-initial)";
  if (count <= 2) return "var(--cycle-8)";
  return `var(--cycle-${1 + Math.round((index - 1) / (count - 2) * 7)})`;
}

function round(value) {
  return Math.round(value * 100) / 100;
}

/** Runs of neighbouring points that can be shown: [[{sx, sy, point}]]. */
function shownRuns(points, scaleX, scaleY) {
  const runs = [[]];
  for (const point of points) {
    const isShown = isNumber(point.x) && isNumber(point.y) &&
      (!scaleX.isLog || point.x > 0) && (!scaleY.isLog || point.y > 0);
    if (isShown) runs.at(-1).push({sx: scaleX.at(point.x), sy: scaleY.at(point.y), point});
    else if (runs.at(-1).length > 0) runs.push([]);
  }
  return runs.filter((run) => run.length > 0);
}

function linePath(run) {
  return "M" + run.map(({sx, sy}) => `${round(sx)} ${round(sy)}`).join("L");
}

/** A line as a path element in the look of its series. */
function lineMark(series, d) {
  return svgElement("path", {
    d, class: "line", style: `stroke:${series.color}`,
    "stroke-width": series.width || 1.75, "stroke-dasharray": series.dash,
  });
}

function pointMark(series, x, y, r) {
  const fill = series.isHollow ? "var(--surface)" : series.color;
  return svgElement("path", {
    d: markerPath(series.marker, x, y, r), class: series.isHollow ? "marker hollow" : "marker",
    style: series.isHollow ? `fill:${fill};stroke:${series.color}` : `fill:${fill}`,
  });
}

/** The look of a series in 26 x 12 pixels. */
function swatch(series) {
  const parts = [];
  if (series.isBar) {
    parts.push(svgElement("rect",
      {x: 6, y: 1, width: 14, height: 10, class: "bar", style: `fill:${series.color}`}));
  } else {
    if (series.hasLine !== false) parts.push(lineMark(series, "M1 6L25 6"));
    if (series.marker) parts.push(pointMark(series, 13, 6, 3.6));
  }
  return svgElement("svg", {class: "swatch", width: 26, height: 12, "aria-hidden": "true"}, parts);
}

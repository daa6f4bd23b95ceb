// What all charts share: box, title, tools, legend, tooltip, width.

/**
 * A figure for a chart, empty so far. `spec`: {name (of downloads), title, note?, height}. The
 * drawing is done by `draw(chart)` whenever the width or the chart.spec changes.
 */
function createChartFrame(host, spec, draw) {
  const chart = {spec, hidden: new Set(), width: 0, draw, focus: null};
  chart.title = htmlElement("span", {class: "caption"});
  chart.note = htmlElement("span", {class: "note"});
  chart.tools = htmlElement("span", {class: "tools"},
    smallButton("CSV", "The numbers as CSV", () => downloadCsv(chart.spec.name, chartCsv(chart))),
    smallButton("SVG", "The drawing as SVG", () => downloadSvg(chart)));
  chart.plot = htmlElement("div", {class: "plot"});
  chart.legend = htmlElement("div", {class: "legend"});
  chart.tooltip = htmlElement("div", {class: "tooltip", role: "status", hidden: true});
  chart.figure = htmlElement("figure", {class: "chart", "data-name": spec.name},
    htmlElement("figcaption", {},
      htmlElement("span", {}, chart.title, " ", chart.note), chart.tools),
    htmlElement("div", {class: "chart-body"}, chart.plot, chart.legend), chart.tooltip);
  host.append(chart.figure);
  allCharts.push(chart);
  new ResizeObserver(() => resizeChart(chart)).observe(chart.plot);
  return chart;
}

/** Charts are as wide as their place; for print they are drawn anew for a page of A4. */
const kPrintWidths = {whole: 680, half: 325};
const allCharts = [];

function drawChartsForPrint() {
  for (const chart of allCharts) {
    const isHalf = chart.figure.closest(".even:not(.single)") !== null;
    chart.width = kPrintWidths[isHalf ? "half" : "whole"];
    redrawChart(chart);
  }
}

function drawChartsForScreen() {
  for (const chart of allCharts) resizeChart(chart);
}

function resizeChart(chart) {
  const width = Math.floor(chart.plot.clientWidth);
  if (width === 0 || width === chart.width) return;
  chart.width = width;
  redrawChart(chart);
}

function updateChart(chart, spec) {
  chart.spec = spec;
  chart.title.textContent = spec.title;
  chart.note.textContent = spec.note || "";
  chart.figure.dataset.name = spec.name;
  chart.plot.style.minHeight = `${spec.height}px`;
  drawChartLegend(chart);
  chart.width = Math.floor(chart.plot.clientWidth);
  redrawChart(chart);
}

function redrawChart(chart) {
  if (chart.width === 0 || !chart.spec.series) return;
  hideTooltip(chart);
  chart.draw(chart);
}

/** The entries of the legend: those of the spec, or one for each series. */
function legendGroups(spec) {
  const entry = (series) => ({label: series.name, look: series, series: [series]});
  return spec.legend || [{entries: spec.series.map(entry)}];
}

function drawChartLegend(chart) {
  const groups = legendGroups(chart.spec).filter((group) => group.entries.length > 0);
  chart.legend.replaceChildren(...groups.map((group) => htmlElement("div", {class: "legend-group"},
    group.title ? htmlElement("span", {class: "legend-title"}, group.title) : null,
    group.entries.map((entry) => legendEntry(chart, entry)))));
}

/** A button that shows and hides its series. Entries stay hidden by their label. */
function legendEntry(chart, entry) {
  if (entry.isFixed) {
    return htmlElement("span", {class: "legend-entry"}, swatch(entry.look), entry.label);
  }
  const button = htmlElement("button", {
    type: "button", class: "legend-entry", title: "Show or hide",
    "aria-pressed": String(!chart.hidden.has(entry.label)),
    onclick: () => {
      if (!chart.hidden.delete(entry.label)) chart.hidden.add(entry.label);
      button.setAttribute("aria-pressed", String(!chart.hidden.has(entry.label)));
      redrawChart(chart);
    },
  }, swatch(entry.look), htmlElement("span", {}, entry.label));
  return button;
}

function visibleSeries(chart) {
  const hidden = new Set();
  for (const group of legendGroups(chart.spec)) {
    for (const entry of group.entries) {
      if (chart.hidden.has(entry.label)) for (const series of entry.series) hidden.add(series);
    }
  }
  return chart.spec.series.filter((series) => !hidden.has(series));
}

/** The drawing area, empty. `label` is what screen readers say. */
function emptyDrawing(chart, height, label) {
  const svg = svgElement("svg", {
    width: chart.width, height, viewBox: `0 0 ${chart.width} ${height}`,
    tabindex: "0", role: "group", "aria-roledescription": "chart", "aria-label": label,
  });
  chart.plot.replaceChildren(svg);
  return svg;
}

/** Shows rows [[label, value]] near a place of the drawing (pixels). */
function showTooltip(chart, x, y, title, rows) {
  const {tooltip, plot, figure} = chart;
  tooltip.replaceChildren(htmlElement("strong", {}, title),
    htmlElement("table", {}, rows.map((row) => tooltipRow(row))));
  tooltip.hidden = false;
  const box = plot.getBoundingClientRect();
  const origin = figure.getBoundingClientRect();
  const scale = box.width / chart.width || 1;
  const left = box.left - origin.left + x * scale;
  const top = box.top - origin.top + y * scale;
  const fits = left + 14 + tooltip.offsetWidth <= origin.width;
  const shifted = fits ? left + 14 : Math.max(0, left - 14 - tooltip.offsetWidth);
  tooltip.style.left = `${shifted}px`;
  tooltip.style.top = `${Math.max(0, top - tooltip.offsetHeight / 2)}px`;
}

function tooltipRow([label, value, look]) {
  return htmlElement("tr", {},
    htmlElement("th", {scope: "row"}, look ? swatch(look) : null, label),
    htmlElement("td", {}, value));
}

function hideTooltip(chart) {
  chart.tooltip.hidden = true;
  chart.focus = null;
}

/** The spec's own table, or series, x, y of all points. */
function chartCsv(chart) {
  const {spec} = chart;
  if (spec.csv) return csvText(spec.csv.header, spec.csv.rows);
  return csvText(["series", spec.x.label, spec.y.label], spec.series.flatMap((series) =>
    series.points.map((point) => [series.name, point.x, point.y])));
}

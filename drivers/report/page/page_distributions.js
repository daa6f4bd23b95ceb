// How long the edges are in the metric and how good the elements, cycle by cycle (the paper's
// Figs. 16 and 17).

const kUnitBand = {from: Math.SQRT1_2, to: Math.SQRT2, label: "unit band [1/√2, √2]"};

function buildDistributions(host, report) {
  const {selection} = report;
  const state = {against: "exact"};
  const controls = htmlElement("div", {class: "controls"});
  const grid = htmlElement("div", {class: "side-by-side even"});
  const table = cycleTable(selection.model);
  host.append(controls, grid, table.element);
  const charts = [];
  const draw = () => {
    const variants = shownSideBySide(selection);
    showCharts(charts, grid, [...distributionSpecs(variants, "edge_length", state),
      ...distributionSpecs(variants, "quality", state)]);
    table.update(variants.flatMap((variant) => cycleRows(variant)));
  };
  if (selection.model.variants.some(hasExactMetric)) {
    controls.append(segmentedButtons("against", [{value: "exact", label: "exact metric"},
      {value: "background", label: "background metric"}], state.against, (value) => {
      state.against = value;
      draw();
    }));
  }
  onSelection(selection, draw);
}

/** The chosen variant and one beside it: the reader's choice, else its twin of other elements. */
function shownSideBySide(selection) {
  const {chosen, compared} = selection;
  const other = compared || elementTwin(selection.model, chosen);
  const variants = other && other !== chosen ? [chosen, other] : [chosen];
  return variants.filter((variant) => variant.last !== null);
}

/** The variant that differs only in its elements, or null. */
function elementTwin(model, variant) {
  const keys = model.facets.map((facet) => facet.key)
    .filter((key) => key !== "mesh.elements" && !key.startsWith("mesh.quad_"));
  return model.variants.find((other) => other !== variant && other.run === variant.run &&
    other.facets["mesh.elements"] !== variant.facets["mesh.elements"] &&
    keys.every((key) => other.facets[key] === variant.facets[key])) || null;
}

/** Statistics of a cycle against the exact metric where asked for and known. */
function statisticsOf(cycle, against) {
  return against === "exact" ? cycle : cycle.background;
}

function histogramOf(cycle, kind, against) {
  return (statisticsOf(cycle, against)[kind] || {}).histogram || null;
}

function distributionSpecs(variants, kind, state) {
  const known = variants.filter((v) => v.cycles.some((c) => histogramOf(c, kind, state.against)));
  const limits = {top: commonTop(known, kind, state), right: commonRight(known, kind, state)};
  return known.map((variant) => distributionSpec(variant, kind, state.against, limits));
}

/** One chart for each spec; charts of an earlier call serve again. */
function showCharts(charts, host, specs) {
  host.classList.toggle("single", specs.length < 2);
  charts.forEach((chart, i) => {
    chart.element.hidden = i >= specs.length;
  });
  specs.forEach((spec, i) => {
    if (charts[i]) charts[i].update(spec);
    else charts[i] = createXyChart(host, spec);
  });
}

/** Charts side by side have one scale: that of the highest bin after the initial mesh. */
function commonTop(variants, kind, state) {
  const counted = ({cycles}) => cycles.filter((c) => c.cycle > 0 || cycles.length < 2);
  const points = variants.flatMap(counted)
    .flatMap((cycle) => distributionPoints(cycle, kind, state.against));
  return niceTop(Math.max(...points.map((p) => p.y), 1));
}

/** Where the axis of charts side by side ends: beyond the last bin that is not empty. */
function commonRight(variants, kind, state) {
  if (kind === "quality") return 1;
  const points = variants.flatMap((v) => v.cycles)
    .flatMap((cycle) => distributionPoints(cycle, kind, state.against));
  const last = Math.max(...points.filter((p) => p.count > 0).map((p) => p.x));
  return Math.min(3.1, Math.max(2, last + 0.1));
}

function niceTop(value) {
  const step = niceStep(value, 5);
  return Math.ceil(value / step - 1e-9) * step;
}

/** Percent per bin at the middle of the bin; the last bin of the lengths is open. */
function distributionPoints(cycle, kind, against) {
  const histogram = histogramOf(cycle, kind, against);
  if (!histogram) return [];
  const {bounds, counts} = histogram;
  const total = counts.reduce((a, b) => a + b, 0) || 1;
  const width = bounds[1] - bounds[0];
  return counts.map((count, i) => {
    const to = bounds[i] ?? Infinity;
    const from = i === 0 ? bounds[0] - width : bounds[i - 1];
    return {x: from + width / 2, y: 100 * count / total, from, to, count};
  });
}

/** Without the empty bins at either end, but for the one next to the others. */
function withoutEmptyEnds(points) {
  const isFull = points.map((point) => point.count > 0);
  const first = isFull.indexOf(true);
  if (first < 0) return [];
  return points.slice(Math.max(first - 1, 0), isFull.lastIndexOf(true) + 2);
}

function distributionSpec(variant, kind, against, {top, right}) {
  const isLength = kind === "edge_length";
  const series = cycleSeries(variant, (cycle) =>
    withoutEmptyEnds(distributionPoints(cycle, kind, against)));
  const elements = variant.last.quads === 0 ? "triangles" : "quadrilaterals";
  return {
    name: `${isLength ? "edge-lengths" : "qualities"}-${variant.name}`,
    title: `${isLength ? "Edge lengths" : "Element quality"}, ${elements}`,
    note: variant.name, height: 330,
    x: {label: isLength ? "length in the metric" : "quality", min: 0, max: right},
    y: {label: isLength ? "edges, %" : "elements, %", min: 0, max: top},
    bands: isLength ? [kUnitBand] : [], series, isByX: true,
    describeX: (point) => (Number.isFinite(point.to)
      ? `${exactText(point.from)} to ${exactText(point.to)}, %`
      : `more than ${exactText(point.from)}, %`),
    csv: distributionCsv(series, isLength ? "edges" : "elements"),
  };
}

function distributionCsv(series, noun) {
  const bound = (value) => (Number.isFinite(value) ? exactNumber(value) : null);
  const rows = series.flatMap((s) => s.points.map((p) =>
    [s.cycle, bound(p.from), bound(p.to), p.count, p.y]));
  return {header: ["cycle", "from", "to", noun, "percent"], rows};
}

/** Bounds of bins without the dust of sums of tenths. */
function exactNumber(value) {
  return Number(value.toPrecision(6));
}

/** One series for each cycle, from pale to strong; `pointsOf(cycle)`. */
function cycleSeries(variant, pointsOf) {
  const {cycles} = variant;
  return cycles.map((cycle, i) => ({
    name: cycleName(cycle.cycle), cycle: cycle.cycle, points: pointsOf(cycle),
    color: cycleColor(i, cycles.length), marker: kMarkers[i % kMarkers.length],
    width: i === cycles.length - 1 ? 2.5 : 1.5, size: i === cycles.length - 1 ? 3.6 : 3,
    dash: i === 0 && cycles.length > 1 ? "4 3" : null,
  }));
}

function cycleRows(variant) {
  return variant.cycles.map((cycle) => ({
    variant: variant.name, cycle, statistics: cycle,
    attached: hasExactMetric(variant) ? [{cycle, statistics: cycle.background}] : [],
  }));
}

/** Every cycle with all that is known of its mesh. */
function cycleTable(model) {
  const own = (get) => (row) => (row.variant ? get(row.cycle) : null);
  const problem = [
    numberColumn("unknowns", own((c) => c.dofs)),
    numberColumn("estimate", own((c) => c.error.estimate), scientificText),
    numberColumn("true error", own((c) => c.error.relative_energy), scientificText),
  ];
  return createTable({
    name: "cycles", caption: "Cycle by cycle",
    columns: [
      textColumn("variant", (row) => row.variant ?? "against the background"),
      numberColumn("cycle", (row) => row.cycle.cycle),
      numberColumn("vertices", own((c) => c.vertices)),
      numberColumn("elements", own((c) => c.elements)),
      ...model.variants.some(hasProblem) ? problem : [],
      ...statisticsColumns(),
    ],
  });
}

/** What is known of a mesh against a metric. */
function statisticsColumns() {
  const three = (v) => fixedText(v, 3);
  const whole = (v) => fixedText(v, 0);
  const stat = (get) => (row) => get(row.statistics);
  return [
    numberColumn("quality", stat((s) => s.quality.mean), three),
    numberColumn("least", stat((s) => s.quality.min), three),
    numberColumn("unit band %", stat((s) => s.edge_length.in_unit_band), percentText),
    numberColumn("0.5–1.5 %", stat((s) => s.edge_length["in_0.5_1.5"]), (v) => percentText(v, 2)),
    numberColumn("shortest", stat((s) => s.edge_length.min), three),
    numberColumn("longest", stat((s) => s.edge_length.max), three),
    numberColumn("angles from", stat((s) => s.angle?.min), whole, "Degrees, in the metric"),
    numberColumn("to", stat((s) => s.angle?.max), whole, "Degrees, in the metric"),
    numberColumn("complexity", stat((s) => s.metric_complexity), whole,
      "Integral of the root of the metric's determinant"),
    numberColumn("stretch", stat((s) => s.stretch_max), (v) => fixedText(v, 1),
      "Largest ratio of the metric's two sizes"),
  ];
}

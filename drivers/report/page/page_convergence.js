// Error and effectivity against the size of the meshes.

const kErrors = {relative_energy: "true error", estimate: "estimate"};
const kSizes = {dofs: "unknowns", vertices: "vertices"};

function hasErrors(model) {
  return model.variants.some((variant) => variant.cycles.some((cycle) =>
    Object.keys(kErrors).some((key) => cycle.error[key] > 0)));
}

function buildConvergence(host, report) {
  const {model, selection} = report;
  const state = convergenceState(model);
  const controls = htmlElement("div", {class: "controls"});
  const charts = htmlElement("div");
  const slopes = slopeTable();
  host.append(controls, charts, slopes.element);
  let error = null;
  let effectivity = null;
  const draw = () => {
    const lines = convergenceLines(selection, state);
    const spec = errorSpec(selection, state, lines);
    if (error) error.update(spec);
    else error = createXyChart(charts, spec);
    slopes.update(slopeRows(lines, state));
    const second = effectivitySpec(selection, state, lines);
    if (effectivity) effectivity.update(second);
    else if (model.variants.some(hasEffectivity)) effectivity = createXyChart(charts, second);
  };
  controls.append(...convergenceControls(model, state, draw));
  onSelection(selection, draw);
}

function convergenceState(model) {
  const has = (key) => model.variants.some((v) => v.cycles.some((c) => c.error[key] > 0));
  return {
    points: model.families.some((family) => family.variants.length > 1) ? "last" : "all",
    size: "dofs", errors: has("relative_energy") ? "relative_energy" : "estimate",
    hasBoth: has("relative_energy") && has("estimate"), looks: defaultLooks(model),
  };
}

function convergenceControls(model, state, draw) {
  const segments = (label, name, choices) => segmentedButtons(label, choices, state[name],
    (value) => {
      state[name] = value;
      draw();
    });
  const controls = [];
  if (state.points === "last") {
    controls.push(segments("meshes", "points", [
      {value: "last", label: "last ones", title: "Last meshes of all sizes, joined by lines"},
      {value: "all", label: "all cycles", title: "The cycles of each variant, joined by lines"}]));
  }
  if (state.hasBoth) {
    controls.push(segments("error", "errors", [{value: "relative_energy", label: "true"},
      {value: "estimate", label: "estimated"}, {value: "both", label: "both"}]));
  }
  controls.push(segments("against", "size", Object.entries(kSizes)
    .map(([value, label]) => ({value, label}))));
  return [...controls, ...lookControls(model, state.looks, draw)];
}

/** What is joined by a line: [{label, meshes: [{variant, cycle}]}] of the variants not filtered. */
function convergenceLines(selection, state) {
  const {model, matching} = selection;
  const last = (variant) => ({variant, cycle: variant.last});
  if (state.points === "all") {
    return matching.map((variant) => ({label: variant.name,
      meshes: variant.cycles.map((cycle) => ({variant, cycle}))}));
  }
  return model.families.map((family) => ({
    label: family.label,
    meshes: family.variants.filter((v) => matching.includes(v) && v.last).map(last)
      .sort((a, b) => a.cycle[state.size] - b.cycle[state.size]),
  })).filter((line) => line.meshes.length > 0);
}

/** One series for each line; `valueOf(cycle)`. The chosen variant stands out. */
function lineSeries(selection, state, lines, valueOf, more = {}) {
  const {model, chosen} = selection;
  const isChosen = (line) => line.meshes.some(({variant}) => variant === chosen);
  const series = lines.filter((line) => line.meshes.length > 0).map((line) => ({
    name: line.label, variant: line.meshes[0].variant, isChosen: isChosen(line),
    isFaint: lines.length > 8 && !isChosen(line), width: isChosen(line) ? 2.75 : 1.5,
    points: line.meshes.map(({variant, cycle}) =>
      ({x: cycle[state.size], y: valueOf(cycle), variant, cycle})),
    ...variantLook(model, state.looks, line.meshes[0].variant), ...more,
  }));
  return series.sort((a, b) => a.isChosen - b.isChosen);
}

function shownErrors(state) {
  return state.errors === "both" ? Object.keys(kErrors) : [state.errors];
}

function errorSpec(selection, state, lines) {
  const series = shownErrors(state).flatMap((key) => lineSeries(selection, state, lines,
    (cycle) => cycle.error[key], key === "estimate" ? {isHollow: true, dash: "5 3"} : {}));
  const legend = lookLegend(selection.model, state.looks, series);
  if (state.errors === "both") legend.push(errorLegend());
  const title = state.errors === "both" ? "True and estimated error"
    : state.errors === "estimate" ? "Estimated error" : "True error";
  return {
    name: "error", title: `${title} against ${kSizes[state.size]}`, height: 430,
    x: {label: kSizes[state.size], isLog: true},
    y: {label: "relative error, energy norm", isLog: true},
    series, legend: legend.length > 0 ? legend : null, csv: convergenceCsv(lines),
    slopes: referenceSlopes(series), describe: describeMesh,
    onPick: (point) => chooseVariant(selection, point.variant),
  };
}

function errorLegend() {
  const look = (more) => ({color: "var(--muted)", marker: "circle", ...more});
  return {title: "error", entries: [
    {label: "true", isFixed: true, look: look({})},
    {label: "estimated", isFixed: true, look: look({isHollow: true, dash: "5 3"})}]};
}

function describeMesh({variant, cycle}) {
  return {
    title: `${variant.name}, ${cycleName(cycle.cycle)}`,
    rows: [["vertices", String(cycle.vertices)], ["unknowns", String(cycle.dofs)],
      ["true error", exactText(cycle.error.relative_energy)],
      ["estimate", exactText(cycle.error.estimate)],
      ["effectivity", exactText(cycle.error.effectivity)]],
  };
}

function convergenceCsv(lines) {
  return {
    header: ["line", "variant", "cycle", "vertices", "unknowns", "true error", "estimate",
      "effectivity"],
    rows: lines.flatMap((line) => line.meshes.map(({variant, cycle}) => [line.label, variant.name,
      cycle.cycle, cycle.vertices, cycle.dofs, cycle.error.relative_energy, cycle.error.estimate,
      cycle.error.effectivity])),
  };
}

function hasEffectivity(variant) {
  return variant.cycles.some((cycle) => cycle.error.effectivity > 0);
}

function effectivitySpec(selection, state, lines) {
  const series = lineSeries(selection, state, lines, (cycle) => cycle.error.effectivity);
  const values = series.flatMap((s) => s.points.map((p) => p.y)).filter((v) => v > 0);
  const isWide = Math.max(...values) / Math.min(...values) > 20;
  const legend = lookLegend(selection.model, state.looks, series);
  return {
    name: "effectivity", title: `Effectivity against ${kSizes[state.size]}`, height: 270,
    x: {label: kSizes[state.size], isLog: true},
    y: {label: "estimate / true error", isLog: isWide,
      min: isWide ? undefined : Math.min(0.5, ...values) - 0.05,
      max: isWide ? undefined : Math.max(1.5, ...values) + 0.05},
    rules: [{y: 1}], series, legend: legend.length > 0 ? legend : null, csv: convergenceCsv(lines),
    describe: describeMesh,
    onPick: (point) => chooseVariant(selection, point.variant),
  };
}

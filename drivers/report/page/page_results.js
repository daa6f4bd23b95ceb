// The last mesh of every variant in one row, beside the paper's where it has one.

function buildResults(host, report) {
  const {model, selection} = report;
  if (model.variants.length > 3) host.append(filterPanel(selection));
  addResultTable(host, selection, hasProblem, problemTable(selection));
  addResultTable(host, selection, (v) => !hasProblem(v), metricTable(selection));
  addValueTable(host, selection);
}

/** `rowsOf(variant)`: the variant with what its row shows. */
function addResultTable(host, selection, isShown, table) {
  if (!selection.model.variants.some(isShown)) return;
  host.append(table.element);
  onSelection(selection, () => table.update(selection.matching.filter(isShown).map(resultRow)));
}

function resultRow(variant) {
  const row = {variant, cycle: variant.last, statistics: variant.last, attached: []};
  if (!hasExactMetric(variant)) return row;
  row.attached.push({cycle: variant.last, statistics: variant.last.background});
  if (variant.data.paper) row.attached.push({paper: variant.data.paper});
  return row;
}

function pickable(selection) {
  return {
    isPicked: (row) => row.variant === selection.chosen,
    onPick: (row) => chooseVariant(selection, row.variant),
  };
}

function problemTable(selection) {
  const of = (get) => (row) => (row.cycle ? get(row.cycle) : null);
  return createTable({
    name: "results", caption: "Last mesh of every variant", ...pickable(selection),
    columns: [
      textColumn("variant", (row) => row.variant.name),
      numberColumn("cycle", of((c) => c.cycle)),
      numberColumn("vertices", of((c) => c.vertices)),
      numberColumn("unknowns", of((c) => c.dofs)),
      numberColumn("estimate", of((c) => c.error.estimate), scientificText,
        "Estimated relative error in the energy norm"),
      numberColumn("true error", of((c) => c.error.relative_energy), scientificText,
        "True relative error in the energy norm"),
      numberColumn("effectivity", of((c) => c.error.effectivity), (v) => fixedText(v, 3),
        "Estimate over true error"),
      numberColumn("unit band %", of((c) => c.edge_length.in_unit_band), percentText,
        "Edges with a metric length in [1/√2, √2]"),
      numberColumn("quality", of((c) => c.quality.mean), (v) => fixedText(v, 3),
        "Geometric mean of the element qualities in the metric"),
      numberColumn("least", of((c) => c.quality.min), (v) => fixedText(v, 3), "Least quality"),
      numberColumn("time s", (row) => totalSeconds(row.variant), secondsText,
        "Seconds of all stages and cycles"),
      textColumn("stopped", (row) => row.variant.data.stop_reason),
    ],
  });
}

/** Value of a row of ours, or of the paper's row below it. */
function either(ours, paperKey) {
  return (row) => {
    if (row.paper) return paperKey ? row.paper[paperKey] : null;
    return row.cycle ? ours(row) : null;
  };
}

/** Counts are those of the row above. */
function ofVariant(key) {
  return either((row) => (row.variant ? row.cycle[key] : null), key);
}

function rowName(row) {
  if (row.variant) return row.variant.name;
  return row.paper ? `paper, Fig. ${row.paper.name}` : "against the background";
}

function metricTable(selection) {
  return createTable({
    name: "meshes", caption: "Last mesh of every variant against its metric",
    ...pickable(selection),
    columns: [textColumn("variant", rowName), ...metricColumns(), ...reasonColumn(selection)],
  });
}

/** Why variants stopped, where that is not the same for all. */
function reasonColumn({model}) {
  const reasons = new Set(model.variants.map((variant) => variant.data.stop_reason));
  const reason = (row) => (row.variant ? row.variant.data.stop_reason : null);
  return reasons.size > 1 ? [textColumn("stopped", reason)] : [];
}

/** The columns of the paper's tables, then the share of the unit band. */
function metricColumns() {
  const three = (v) => fixedText(v, 3);
  const count = (label, key) => numberColumn(label, ofVariant(key));
  return [
    count("vertices", "vertices"), count("elements", "elements"), count("edges", "edges"),
    count("boundary", "boundary_edges"),
    numberColumn("quality", either((r) => r.statistics.quality.mean, "quality_mean"), three,
      "Geometric mean of the element qualities in the metric"),
    numberColumn("least", either((r) => r.statistics.quality.min, "quality_min"), three),
    numberColumn("0.5–1.5 %",
      either((r) => r.statistics.edge_length["in_0.5_1.5"], "percent_half"),
      (v) => percentText(v, 2), "Edges with a metric length from 0.5 to 1.5"),
    numberColumn("shortest", either((r) => r.statistics.edge_length.min, "length_min"), three,
      "Least metric length of an edge"),
    numberColumn("longest", either((r) => r.statistics.edge_length.max, "length_max"), three,
      "Largest metric length of an edge"),
    numberColumn("unit band %", either((r) => r.statistics.edge_length.in_unit_band), percentText,
      "Edges with a metric length in [1/√2, √2]"),
    numberColumn("time s", (row) => (row.variant ? totalSeconds(row.variant) : null), secondsText),
  ];
}

function valueNames(variants) {
  return [...new Set(variants.flatMap((v) => Object.keys(v.last ? v.last.values : {})))];
}

/** Goal and named values on the last meshes. */
function addValueTable(host, selection) {
  const variants = selection.model.variants.filter((variant) => variant.last);
  const names = valueNames(variants);
  const hasGoal = variants.some((variant) => variant.last.goal);
  if (names.length === 0 && !hasGoal) return;
  const goal = (key) => (variant) => variant.last.goal && variant.last.goal[key];
  const columns = [textColumn("variant", (variant) => variant.name)];
  if (hasGoal) {
    columns.push(numberColumn("goal", goal("value"), significantText, "Quantity of interest"),
      numberColumn("goal error", goal("error"), scientificText, "Estimated error of the goal"));
  }
  columns.push(...names.map((name) =>
    numberColumn(name, (variant) => variant.last.values[name], significantText)));
  const table = createTable({name: "values", caption: "Values on the last mesh", columns,
    isPicked: (variant) => variant === selection.chosen,
    onPick: (variant) => chooseVariant(selection, variant)});
  host.append(table.element);
  onSelection(selection, () => table.update(selection.matching.filter((v) => v.last)));
}

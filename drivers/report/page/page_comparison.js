// Isotropic against anisotropic meshes at equal error, and runs against each other.

/** Comparisons of all runs: [{label, error, against, isotropic, anisotropic, ratio}]. */
function modeComparisons(model) {
  return model.runs.flatMap((run) => run.comparison.map((comparison) => ({
    ...comparison, label: comparisonLabel(model, run, comparison),
  })));
}

/** The settings of a comparison that tell it from the others of the page. */
function comparisonLabel(model, run, comparison) {
  const facets = variantFacets(run, comparison.settings);
  const told = model.facets.filter(({key}) => facets[key] !== undefined);
  return told.map(({key}) => settingText(key, facets[key])).join(", ") || "all variants";
}

function buildModeComparison(host, report) {
  const rows = modeComparisons(report.model);
  host.append(htmlElement("p", {class: "finding"}, comparisonFinding(rows)));
  const comparable = rows.filter((row) => isNumber(row.ratio.vertices));
  const body = htmlElement("div", {class: "side-by-side"});
  host.append(body);
  if (comparable.length > 0) createBarChart(body, comparisonBars(comparable));
  const table = comparisonTable();
  table.update(rows);
  body.append(table.element);
}

/** "At equal error, anisotropic meshes take 12.6 % to 43.0 % of the vertices of isotropic ones." */
function comparisonFinding(rows) {
  const ratios = rows.map((row) => row.ratio.vertices).filter(isNumber).sort((a, b) => a - b);
  if (ratios.length === 0) return "The errors of the two kinds of meshes have no level in common.";
  const percent = (ratio) => `${(100 * ratio).toFixed(1)} %`;
  const range = ratios.length === 1 ? percent(ratios[0])
    : `${percent(ratios[0])} to ${percent(ratios.at(-1))}`;
  const middle = ratios[Math.floor(ratios.length / 2)];
  const median = ratios.length > 2 ? ` (median ${percent(middle)})` : "";
  return `At equal error, anisotropic meshes take ${range}${median} of the vertices ` +
    "of isotropic ones.";
}

function comparisonBars(rows) {
  return {
    name: "isotropic-anisotropic", title: "Vertices at equal error",
    x: {label: "vertices"}, rowLabel: "at equal error",
    series: [{name: "isotropic", color: "var(--accent-2)"},
      {name: "anisotropic", color: "var(--accent)"}],
    rows: rows.map((row) => ({
      label: row.label, values: [row.isotropic.vertices, row.anisotropic.vertices],
    })),
  };
}

function comparisonTable() {
  const whole = (v) => fixedText(v, 0);
  const ratio = (v) => fixedText(v, 3);
  return createTable({
    name: "comparison", caption: "Isotropic against anisotropic at equal error",
    columns: [
      textColumn("settings", (row) => row.label),
      numberColumn("error", (row) => row.error, scientificText,
        "The smallest error that both have reached"),
      textColumn("which", (row) => row.against, "True or estimated errors"),
      numberColumn("isotropic vertices", (row) => row.isotropic.vertices, whole),
      numberColumn("anisotropic vertices", (row) => row.anisotropic.vertices, whole),
      numberColumn("ratio", (row) => row.ratio.vertices, ratio),
      numberColumn("isotropic unknowns", (row) => row.isotropic.dofs, whole),
      numberColumn("anisotropic unknowns", (row) => row.anisotropic.dofs, whole),
      numberColumn("ratio of unknowns", (row) => row.ratio.dofs, ratio),
    ],
  });
}

// What several runs take to reach the same error.

/** Settings in which every run is all of one kind: they go with the run, not with the variant. */
function settingsOfRuns(model) {
  const keys = new Set(model.variants.flatMap((v) => Object.keys(v.data.settings)));
  const texts = (run, key) => run.variants.map((variant) =>
    (key in variant.settings ? valueText(variant.settings[key]) : undefined));
  return [...keys].filter((key) => model.runs.every((run) => !tellsApart(key, texts(run, key))));
}

/** Variants that correspond to each other, by run: [{label, byRun: Map}]. */
function correspondingVariants(model) {
  const ofRuns = settingsOfRuns(model);
  const groups = new Map();
  for (const variant of model.variants) {
    const told = Object.entries(variant.data.settings).filter(([key]) =>
      !ofRuns.includes(key) && !key.startsWith("adapt.target") && key !== "report.paper");
    const key = JSON.stringify(told);
    if (!groups.has(key)) {
      const label = told.map(([name, value]) => settingText(name, valueText(value))).join(", ");
      groups.set(key, {label: label || "all variants", byRun: new Map()});
    }
    const {byRun} = groups.get(key);
    byRun.set(variant.run, [...(byRun.get(variant.run) || []), variant]);
  }
  return [...groups.values()].filter((group) => group.byRun.size > 1);
}

/** Meshes that no other beats in size and error: [{size, error}], sizes up, errors down. */
function bestMeshes(variants, errorKey, sizeKey) {
  const meshes = variants.flatMap((v) => v.cycles)
    .filter((c) => c.cycle >= 1 && c.error[errorKey] > 0 && c[sizeKey] > 0)
    .map((c) => ({size: c[sizeKey], error: c.error[errorKey]}))
    .sort((a, b) => a.size - b.size || a.error - b.error);
  const best = [];
  for (const mesh of meshes) {
    if (best.length === 0 || mesh.error < best.at(-1).error) best.push(mesh);
  }
  return best;
}

/** Size at an error, log-log between neighbours; null outside of what was reached. */
function sizeAtError(meshes, level) {
  for (let i = 0; i < meshes.length; ++i) {
    const [before, mesh] = [meshes[i - 1], meshes[i]];
    if (mesh.error === level) return mesh.size;
    if (!before || before.error < level || mesh.error > level) continue;
    const part = Math.log(level / before.error) / Math.log(mesh.error / before.error);
    return before.size * (mesh.size / before.size) ** part;
  }
  return null;
}

/** {label, error, which, vertices: one per run} at the smallest error that all have reached. */
function runComparison(model, group) {
  const runs = model.runs.filter((run) => group.byRun.has(run));
  const which = ["relative_energy", "estimate"].find((key) =>
    runs.every((run) => bestMeshes(group.byRun.get(run), key, "vertices").length > 0));
  if (!which) return null;
  const meshes = (run) => bestMeshes(group.byRun.get(run) || [], which, "vertices");
  const error = Math.max(...runs.map((run) => meshes(run).at(-1).error));
  return {label: group.label, error, which: which === "estimate" ? "estimate" : "true",
    vertices: model.runs.map((run) => sizeAtError(meshes(run), error))};
}

function runComparisons(model) {
  return correspondingVariants(model).map((group) => runComparison(model, group))
    .filter((row) => row !== null);
}

function buildRunComparison(host, report) {
  const {model} = report;
  const rows = runComparisons(model);
  const body = htmlElement("div", {class: "side-by-side"});
  host.append(body);
  createBarChart(body, {
    name: "runs-at-equal-error", title: "Vertices at equal error", x: {label: "vertices"},
    rowLabel: "variants",
    series: model.runs.map((run, r) => ({name: run.name, color: seriesColor(r)})),
    rows: rows.map((row) => ({label: row.label, values: row.vertices})),
  });
  const table = runTable(model);
  table.update(rows);
  body.append(table.element);
}

function runTable(model) {
  const ratio = (row, r) => row.vertices[r] / row.vertices[0] || null;
  return createTable({
    name: "runs-at-equal-error", caption: "Runs at equal error",
    columns: [
      textColumn("variants", (row) => row.label),
      numberColumn("error", (row) => row.error, scientificText,
        "The smallest error that all have reached"),
      textColumn("which", (row) => row.which, "True or estimated errors"),
      ...model.runs.map((run, r) =>
        numberColumn(`vertices, ${run.name}`, (row) => row.vertices[r], (v) => fixedText(v, 0))),
      ...model.runs.slice(1).map((run, i) => numberColumn(`${run.name} : ${model.runs[0].name}`,
        (row) => ratio(row, i + 1), (v) => fixedText(v, 3))),
    ],
  });
}

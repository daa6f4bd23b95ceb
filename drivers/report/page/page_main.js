// The report from its first line to its last.

// The meshes, most of the page, follow the data: readers need not wait for them.
document.addEventListener("reportdata", startReport);

function startReport() {
  const model = readModel();
  const report = {model, selection: createSelection(model), sections: [],
    main: document.getElementById("report")};
  fillHeader(report);
  addSections(report);
  report.contentsHost.append(tableOfContents(report));
  buildSection(report.sections[0]);
  watchSections(report);
  buildWhenIdle(report, "meshes");
  performance.mark("report-started");
}

function addSections(report) {
  const {model} = report;
  const add = (id, title, build, more = {}) =>
    addSection(report, {id, title, build: (host) => build(host, report), ...more});
  add("results", "Results", buildResults);
  if (model.runs.some((run) => run.comparison.length > 0)) {
    add("comparison", "Isotropic against anisotropic", buildModeComparison);
  }
  if (model.isSeveral && runComparisons(model).length > 0) {
    add("runs", "Runs at equal error", buildRunComparison);
  }
  const host = htmlElement("div", {class: "by-variant"});
  report.main.append(host);
  if (model.variants.length > 1) addChooser(host, report.selection);
  addVariantSections(add, model, host);
}

/** What is about the chosen variant, below the bar that chooses it. */
function addVariantSections(add, model, host) {
  add("meshes", "Meshes", buildMeshes, {host, height: 640});
  add("distributions", "Edge lengths and quality", buildDistributions, {host, height: 900,
    lead: "Share of the edges over their length in the metric, one line for each cycle; 1 is " +
      "ideal, the band is [1/\u2060√2,\u00a0√2]. An element of quality 1 fits the metric."});
  if (hasErrors(model)) {
    add("convergence", "Error and unknowns", buildConvergence, {host, height: 900,
      lead: "All variants that pass the filters; the one shown above stands out. " +
        "A click on a point shows its variant."});
  }
  if (hasProfiles(model)) add("profiles", "Layer profiles", buildProfiles, {host, height: 450});
  add("timings", "Time and warnings", buildTimings, {host, height: 260});
  add("study", "Study", buildStudy, {host, height: 300});
}

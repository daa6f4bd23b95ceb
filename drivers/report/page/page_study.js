// The settings, the study as it was read, and the files that lie beside the page.

function buildStudy(host, report) {
  const {model, selection} = report;
  const figures = htmlElement("div", {},
    htmlElement("p", {class: "caption"}, "Figures for print, with data and script beside them"));
  host.append(settingsTable(selection), figures);
  addFigureLinks(figures, selection);
  for (const run of model.runs) {
    if (!run.study) continue;
    const title = model.isSeveral ? `Study file of ${run.name}, resolved` : "Study file, resolved";
    host.append(htmlElement("details", {}, htmlElement("summary", {}, title),
      htmlElement("pre", {tabindex: "0"}, htmlElement("code", {}, run.study))));
  }
}

/** Settings of the chosen variant; those that vary stand out. */
function settingsTable(selection) {
  const varying = new Set(selection.model.facets.map((facet) => facet.key));
  const table = createTable({
    name: "settings", caption: "Settings of the variant shown",
    columns: [
      textColumn("key", (row) => row.key),
      textColumn("value", (row) => row.value),
      textColumn("", (row) => (varying.has(row.key) ? "varies" : "")),
    ],
  });
  onSelection(selection, () => {
    const {settings} = selection.chosen.data;
    table.update(Object.entries(settings).map(([key, value]) => ({key, value: valueText(value)})));
  });
  return table.element;
}

/** Drawings for print of the variant shown and of all variants. */
function addFigureLinks(host, selection) {
  const list = htmlElement("ul", {class: "figure-links"});
  host.append(list);
  onSelection(selection, () => {
    const {run, data} = selection.chosen;
    const names = (run.figures || []).filter((name) => isFigureOf(name, data.name, run));
    list.replaceChildren(...[...figuresByStem(names)].map(([stem, formats]) =>
      htmlElement("li", {}, stem, " ", formats.map((format) =>
        [" ", htmlElement("a", {href: figureLink(run, `${stem}.${format}`)}, format)]))));
    host.hidden = names.length === 0;
  });
}

/** {"error": ["pdf", "png", "svg"], ...} */
function figuresByStem(names) {
  const stems = new Map();
  for (const name of names) {
    const end = name.lastIndexOf(".");
    const stem = name.slice(0, end);
    stems.set(stem, [...(stems.get(stem) || []), name.slice(end + 1)]);
  }
  return stems;
}

function figureLink(run, name) {
  const folder = run.folder === "." ? [] : run.folder.split("/");
  return [...folder, "figures", name].map(encodeURIComponent).join("/");
}

function isFigureOf(name, variant, run) {
  if (name.startsWith(`${variant}-`)) return true;
  return !run.variants.some((other) => name.startsWith(`${other.name}-`));
}

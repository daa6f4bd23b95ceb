// What was studied, when and with what.

const kProblemNames = {mindlin: "Mindlin-Reissner plate", poisson: "Scalar problem"};

function fillHeader(report) {
  const {model} = report;
  const header = document.getElementById("report-header");
  document.getElementById("masthead").append(
    htmlElement("span", {class: "program"}, `anisofront ${model.version || ""}`.trim()),
    themeControl());
  header.append(htmlElement("p", {class: "studied"}, studiedText(model)), ...factList(model));
  report.contentsHost = htmlElement("div");
  header.append(report.contentsHost);
}

function problemName(model) {
  const names = new Set(model.runs.map((run) => kProblemNames[run.problem] || "Prescribed metric"));
  return [...names].join(", ");
}

/** "Scalar problem: 8 variants, order (1, 2) × target vertices (400, ...); 48 meshes of ..." */
function studiedText(model) {
  const isVaried = ({key}) => key === "run" || model.runs.some((run) => key in (run.vary || {}));
  const facets = model.facets.filter((facet) => isVaried(facet) && facet.values.length <= 8)
    .map((facet) => `${facet.label} (${facet.values.join(", ")})`);
  const count = countText(model.variants.length, "variant");
  const of = facets.length > 0 ? `, ${facets.join(" × ")}` : "";
  const sizes = model.variants.flatMap((v) => v.cycles.map((cycle) => cycle.vertices));
  const meshes = sizes.length === 0 ? "no mesh"
    : `${countText(sizes.length, "mesh").replace(/meshs$/, "meshes")} of ` +
      `${Math.min(...sizes)} to ${Math.max(...sizes)} vertices`;
  return `${problemName(model)}: ${count}${of}; ${meshes}.`;
}

function factList(model) {
  const entry = ([label, content, name]) =>
    htmlElement("div", {class: name}, htmlElement("dt", {}, label), htmlElement("dd", {}, content));
  return model.runs.map((run) => htmlElement("dl", {class: "facts"},
    runFacts(run, model.isSeveral).map(entry)));
}

function runFacts(run, isSeveral) {
  const facts = [];
  if (isSeveral) facts.push(["Run", run.name]);
  if (run.command) facts.push(["Command", htmlElement("code", {}, run.command)]);
  if (run.date) facts.push(["Date", dateText(run.date)]);
  if (isNumber(run.seconds.wall)) facts.push(["Took", tookText(run.seconds)]);
  if (run.version) facts.push(["Version", run.version]);
  facts.push(["Stopped", stopText(run.variants)], ["Files", runFiles(run), "screen-only"]);
  return facts;
}

function dateText(iso) {
  const date = new Date(iso);
  if (Number.isNaN(date.getTime())) return iso;
  const text = iso.replace("T", " ").replace(/:\d\d(\.\d+)?Z$/, " UTC");
  return htmlElement("time", {datetime: iso}, text);
}

function tookText({wall, threads}) {
  return durationText(wall) + (threads > 1 ? ` with ${threads} variants side by side` : "");
}

/** "finished after 5 cycles (7), failed: no mesh (1)" */
function stopText(variants) {
  const counts = new Map();
  for (const {stop_reason: reason} of variants) counts.set(reason, (counts.get(reason) || 0) + 1);
  const reasons = [...counts].sort((a, b) => b[1] - a[1]);
  const shown = reasons.slice(0, 3).map(([reason, count]) =>
    (variants.length === 1 ? reason : `${reason} (${count})`));
  if (reasons.length > 3) shown.push(`${reasons.length - 3} other reasons`);
  return shown.join("; ");
}

function runFiles(run) {
  const stem = (name) => fileStem(`${run.name}-${name.replace(/\.[a-z]+$/, "")}`);
  const files = Object.entries(run.csv).map(([name, text]) => smallButton(name, `Save ${name}`,
    () => downloadCsv(name.replace(/\.csv$/, ""), text)));
  if (run.study) {
    files.push(smallButton("study.toml", "Save the resolved study file",
      () => downloadText(stem("study.toml") + ".toml", run.study, "text/plain;charset=utf-8")));
  }
  return htmlElement("span", {class: "files"}, files);
}

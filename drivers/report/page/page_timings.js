// Where the time went, and what the program warned of.

const kStages = ["metric", "front", "enhance", "quads", "solve", "estimate"];

function buildTimings(host, report) {
  const {model, selection} = report;
  const body = htmlElement("div", {class: "side-by-side even"});
  host.append(body);
  let chart = null;
  let second = null;
  onSelection(selection, () => {
    const variants = shownSideBySide(selection).slice(0, 2);
    if (variants.length === 0) return;
    if (chart) chart.update(timingSpec(variants[0]));
    else chart = createBarChart(body, timingSpec(variants[0]));
    if (variants[1] && second) second.update(timingSpec(variants[1]));
    if (variants[1] && !second) second = createBarChart(body, timingSpec(variants[1]));
    if (second) second.element.hidden = variants.length < 2;
    body.classList.toggle("single", variants.length < 2);
  });
  host.append(warningList(model));
}

function timingSpec(variant) {
  const stages = kStages.filter((stage) => variant.cycles.some((c) => c.seconds[stage] > 0));
  return {
    name: `seconds-${variant.name}`, title: "Seconds per stage", note: variant.name,
    x: {label: "seconds"}, isStacked: true, rowLabel: "cycle",
    series: stages.map((stage) =>
      ({name: stage, color: seriesColor(kStages.indexOf(stage))})),
    rows: variant.cycles.map((cycle) => ({
      label: cycleName(cycle.cycle), values: stages.map((stage) => cycle.seconds[stage] ?? null),
    })),
  };
}

/** All warnings, equal ones once with where they appeared. */
function collectedWarnings(model) {
  const places = new Map();
  for (const variant of model.variants) {
    for (const cycle of variant.cycles) {
      for (const warning of cycle.warnings || []) {
        const place = `${variant.name}, ${cycleName(cycle.cycle)}`;
        places.set(warning, [...(places.get(warning) || []), place]);
      }
    }
  }
  return [...places];
}

function warningList(model) {
  const warnings = collectedWarnings(model);
  if (warnings.length === 0) {
    return htmlElement("p", {class: "note"}, "The program warned of nothing.");
  }
  return htmlElement("details", {class: "warnings", open: warnings.length <= 5},
    htmlElement("summary", {}, countText(warnings.length, "warning")),
    htmlElement("ul", {}, warnings.map(([text, places]) => htmlElement("li", {}, text, " ",
      htmlElement("span", {class: "note"}, placesText(places))))));
}

function placesText(places) {
  const shown = places.slice(0, 4).join("; ");
  return places.length > 4 ? `${shown}; and ${places.length - 4} more` : shown;
}

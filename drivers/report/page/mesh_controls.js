// Buttons and lists around the stage.

const kMeshIcons = {
  in: "M8 3v10M3 8h10",
  out: "M3 8h10",
  fit: "M2.5 6v-3.5h3.5M10 2.5h3.5v3.5M13.5 10v3.5h-3.5M6 13.5h-3.5v-3.5M6 6h4v4h-4z",
  full: "M9.5 6.5L14 2M10 2h4v4M6.5 9.5L2 14M2 10v4h4",
  save: "M8 2v8M4.5 7L8 10.5L11.5 7M2.5 13.5h11",
  help: "M5.5 6a2.5 2.5 0 1 1 3.800 2.100c-.9.600-1.300 1-1.300 1.900M8 12.5v.6",
  play: "M5 3l8 5l-8 5z",
  pause: "M5.5 3v10M10.5 3v10",
};

function meshIcon(name) {
  return svgElement("svg", {viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": "true",
    class: `mesh-icon mesh-icon-${name}`}, svgElement("path", {d: kMeshIcons[name]}));
}

function iconButton(icon, label, onclick) {
  return htmlElement("button", {type: "button", "aria-label": label, title: label, onclick},
    meshIcon(icon));
}

function meshCheck(label, onchange) {
  const input = htmlElement("input", {type: "checkbox", onchange: () => onchange(input.checked)});
  return {input, element: htmlElement("label", {class: "mesh-check"}, input, label)};
}

const kEdgeChoices = [["hidden", "hidden", "No edges"], ["plain", "plain", "Thin edges"],
  ["length", "by length", "Coloured by length in the metric"]];

/** `act`: of meshActions(). Returns the elements that change. */
function createMeshControls(act) {
  const controls = {
    stepper: htmlElement("span", {class: "segments mesh-cycles", role: "group",
      "aria-label": "Cycle"}),
    play: iconButton("play", "Play the cycles", act.play),
    numbers: htmlElement("span", {class: "mesh-numbers"}),
    colour: htmlElement("select", {"aria-label": "Colour by",
      onchange: () => act.setColour(controls.colour.value)}),
    edges: htmlElement("span", {class: "segments", role: "group", "aria-label": "Edges"}),
    ellipses: meshCheck("ellipses", act.setEllipses),
    sameRange: meshCheck("same range in all cycles", act.setSameRange),
  };
  controls.sameRange.element.title = "Colours mean the same values in all cycles";
  controls.ellipses.element.title = "Unit circles of the metric the mesh was made for";
  for (const [value, label, title] of kEdgeChoices) {
    controls.edges.append(htmlElement("button", {type: "button", title, "data-value": value,
      onclick: () => act.setEdges(value)}, label));
  }
  const labelled = (label, element) => htmlElement("span", {class: "control"},
    htmlElement("span", {class: "control-label"}, label), element);
  controls.bar = htmlElement("div", {class: "mesh-bar"},
    labelled("cycle", controls.stepper), controls.play, controls.numbers);
  controls.options = htmlElement("div", {class: "mesh-bar mesh-options"},
    labelled("colour", controls.colour), controls.sameRange.element,
    labelled("edges", controls.edges), controls.ellipses.element);
  controls.buttons = htmlElement("div", {class: "mesh-buttons"},
    iconButton("in", "Zoom in (+)", act.in), iconButton("out", "Zoom out (−)", act.out),
    iconButton("fit", "Show all (0)", act.fit), iconButton("full", "Full screen", act.full),
    iconButton("save", "Save picture (PNG)", act.save), iconButton("help", "Keys", act.help));
  return controls;
}

/** Buttons for a few cycles, a slider for many. */
function fillStepper(stepper, entries, act) {
  const step = (label, title, by) => htmlElement("button", {type: "button", "aria-label": title,
    title, class: "mesh-step", onclick: () => act.step(by)}, label);
  const kMostButtons = 13;
  const choices = entries.length <= kMostButtons
    ? entries.map(({cycle, id}) => htmlElement("button", {type: "button", "data-cycle": cycle,
      class: id === null ? "mesh-absent" : "", onclick: () => act.goTo(cycle)}, cycle))
    : [htmlElement("input", {type: "range", min: 0, max: entries.length - 1, step: 1,
      "aria-label": "Cycle", oninput: (event) => act.goTo(entries[event.target.value].cycle)})];
  stepper.replaceChildren(step("‹", "Previous cycle ([)", -1), ...choices,
    step("›", "Next cycle (])", 1));
}

function markStepper(stepper, entries, cycle) {
  for (const button of stepper.querySelectorAll("[data-cycle]")) {
    button.setAttribute("aria-pressed", String(Number(button.dataset.cycle) === cycle));
  }
  const slider = stepper.querySelector("input");
  if (slider) slider.value = entries.findIndex((entry) => entry.cycle === cycle);
  const [back, forth] = stepper.querySelectorAll(".mesh-step");
  back.disabled = entries.length === 0 || cycle === entries[0].cycle;
  forth.disabled = entries.length === 0 || cycle === entries.at(-1).cycle;
}

function markEdges(segments, edges, hasLengths) {
  for (const button of segments.children) {
    button.setAttribute("aria-pressed", String(button.dataset.value === edges));
    if (button.dataset.value === "length") button.disabled = !hasLengths;
  }
}

const kGroupLabels = {solution: "solution", error: "error", mesh: "mesh"};

function fillColourList(select, quantities) {
  const groups = ["solution", "error", "mesh"].map((group) =>
    htmlElement("optgroup", {label: kGroupLabels[group]}, quantities
      .filter((quantity) => quantity.group === group && quantity.key !== "none")
      .map((quantity) => htmlElement("option", {value: quantity.key}, quantity.label))));
  select.replaceChildren(htmlElement("option", {value: "none"}, "nothing"),
    ...groups.filter((group) => group.children.length > 0));
}

function numbersText(mesh) {
  const band = percentInBand(mesh);
  const parts = [mesh.vertices === 1 ? "1 vertex" : `${mesh.vertices} vertices`,
    mesh.triangles > 0 ? countText(mesh.triangles, "triangle") : "",
    mesh.quads > 0 ? countText(mesh.quads, "quadrilateral") : "",
    countText(mesh.edges, "edge") +
      (band === null ? "" : `, ${percentText(band)}\u00a0% in the unit band`)];
  return parts.filter(Boolean).join(" · ");
}

// Values along lines across the layers, cycle by cycle, beside the reference.

const kPlaceColumns = ["s", "x", "y"];

function hasProfiles(model) {
  return model.variants.some((variant) => variant.profiles.length > 0);
}

function buildProfiles(host, report) {
  const {selection} = report;
  const state = {line: null, quantity: null, scale: "linear"};
  const controls = htmlElement("div", {class: "controls"});
  const body = htmlElement("div");
  host.append(controls, body);
  const lines = choiceList("line", [], "", (value) => choose("line", value));
  const quantities = choiceList("quantity", [], "", (value) => choose("quantity", value));
  const scale = segmentedButtons("distance", [
    {value: "linear", label: "linear"},
    {value: "start", label: "log from the start", title: "Opens the layer at the start"},
    {value: "end", label: "log from the end", title: "Opens the layer at the end"},
  ], state.scale, (value) => choose("scale", value));
  controls.append(lines, quantities, scale);
  let chart = null;
  const draw = () => {
    const spec = profileSpec(selection, state);
    setProfileChoices(selection.chosen, state, lines, quantities);
    if (chart) chart.update(spec);
    else chart = createXyChart(body, spec);
  };
  const choose = (name, value) => {
    state[name] = value;
    draw();
  };
  onSelection(selection, draw);
}

function setProfileChoices(variant, state, lines, quantities) {
  const choices = (names) => names.map((name) => ({value: name, label: name}));
  setChoices(lines.querySelector("select"), choices(variant.profiles.map((p) => p.name)),
    state.line);
  const profile = variant.profiles.find((p) => p.name === state.line);
  setChoices(quantities.querySelector("select"),
    choices(profile ? profileQuantities(profile) : []), state.quantity);
}

function profileQuantities(profile) {
  return profile.columns.filter((column) => !kPlaceColumns.includes(column));
}

/** The profile to show; line and quantity of the state become ones that it has. */
function shownProfile(variant, state) {
  const profile = variant.profiles.find((p) => p.name === state.line) || variant.profiles[0];
  if (!profile) return null;
  state.line = profile.name;
  const quantities = profileQuantities(profile);
  const known = profile.reference ? profile.reference.columns : [];
  if (!quantities.includes(state.quantity)) {
    state.quantity = quantities.find((name) => known.includes(name)) || quantities[0];
  }
  return profile;
}

/** Points of a table's column over the distance, from the start or from the end. */
function profilePoints(columns, rows, quantity, scale) {
  const [s, value] = [columns.indexOf("s"), columns.indexOf(quantity)];
  if (s < 0 || value < 0) return [];
  const end = Math.max(...rows.map((row) => row[s]));
  const distance = (row) => (scale === "end" ? end - row[s] : row[s]);
  const points = rows.map((row) => ({x: distance(row), y: row[value], s: row[s]}));
  return scale === "end" ? points.reverse() : points;
}

function profileSeries(variant, profile, state) {
  const {columns, cycles, reference} = profile;
  const count = cycles.length;
  const series = cycles.map(({cycle, rows}, i) => ({
    name: cycleName(cycle), cycle,
    points: profilePoints(columns, rows, state.quantity, state.scale),
    color: cycleColor(i, count), marker: null, width: i === count - 1 ? 2.25 : 1.4,
  }));
  const known = reference
    ? profilePoints(reference.columns, reference.rows, state.quantity, state.scale) : [];
  if (known.length > 0) {
    series.push({name: "reference", cycle: null, points: known, color: "var(--text)", dash: "2 3",
      marker: null, width: 1.75});
  }
  return series;
}

function profileSpec(selection, state) {
  const variant = selection.chosen;
  const profile = shownProfile(variant, state);
  const series = profile ? profileSeries(variant, profile, state) : [];
  const isLog = state.scale !== "linear";
  const from = {linear: "distance along the line", start: "distance from the start",
    end: "distance from the end"}[state.scale];
  return {
    name: profile ? `profile-${variant.name}-${state.line}-${state.quantity}` : "profile",
    title: profile ? `${state.quantity} along “${state.line}”` : "No line of this variant",
    note: `${variant.name}; drag across the chart to zoom`, height: 360, canZoom: true, isByX: true,
    x: {label: from, isLog, min: isLog ? undefined : 0, max: lastPlace(series)},
    y: {label: state.quantity || ""},
    series, csv: profileCsv(series, state),
  };
}

function lastPlace(series) {
  const places = series.flatMap((s) => s.points.map((p) => p.x)).filter(isNumber);
  return places.length > 0 ? Math.max(...places) : undefined;
}

function profileCsv(series, state) {
  return {header: ["series", "s", state.quantity || "value"],
    rows: series.flatMap((s) => s.points.map((p) => [s.name, p.s, p.y]))};
}

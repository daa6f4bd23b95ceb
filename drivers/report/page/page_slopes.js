// How fast errors fall with the size of the meshes.

/** Least mean squares of log y over log x; null when the sizes hardly differ. */
function measuredSlope(points) {
  const used = points.filter((p) => p.x > 0 && p.y > 0).slice(-3);
  const xs = used.map((p) => Math.log(p.x));
  const ys = used.map((p) => Math.log(p.y));
  if (used.length < 2 || Math.max(...xs) - Math.min(...xs) < Math.log(1.5)) return null;
  const mean = (values) => values.reduce((a, b) => a + b, 0) / values.length;
  const [mx, my] = [mean(xs), mean(ys)];
  const sxy = xs.reduce((sum, x, i) => sum + (x - mx) * (ys[i] - my), 0);
  const sxx = xs.reduce((sum, x) => sum + (x - mx) ** 2, 0);
  return {slope: sxy / sxx, count: used.length, from: used[0].x, to: used.at(-1).x};
}

/** -1/2, -1, -3/2, ... */
function slopeLabel(slope) {
  const halves = Math.round(-2 * slope);
  return `slope −${halves % 2 === 0 ? halves / 2 : `${halves}/2`}`;
}

/** The line of a slope just below a series: y = level x^slope. */
function slopeBelow(series, slope, {from, to}) {
  const used = series.points.filter((p) => p.x >= from && p.y > 0);
  const level = 0.7 * Math.min(...used.map((p) => p.y / p.x ** slope));
  return {slope, level, from, to, label: slopeLabel(slope)};
}

/** For each slope, rounded to halves, that many series have, a line below the lowest of them. */
function referenceSlopes(series) {
  const groups = new Map();
  let count = 0;
  for (const one of series) {
    const measured = measuredSlope(one.points);
    const slope = measured && Math.round(2 * measured.slope) / 2;
    if (!measured || slope >= 0 || slope < -4) continue;
    groups.set(slope, [...(groups.get(slope) || []), slopeBelow(one, slope, measured)]);
    ++count;
  }
  const lowest = (lines) => lines.reduce((a, b) => (b.level < a.level ? b : a));
  return [...groups.values()].filter((lines) => lines.length >= count / 4).map(lowest)
    .sort((a, b) => b.slope - a.slope);
}

/** One row for each line with at least two sizes. */
function slopeRows(lines, state) {
  return lines.map((line) => {
    const points = (key) => line.meshes.map(({cycle}) =>
      ({x: cycle[state.size], y: cycle.error[key]}));
    return {label: line.label, trueError: measuredSlope(points("relative_energy")),
      estimate: measuredSlope(points("estimate"))};
  }).filter((row) => row.trueError || row.estimate);
}

function slopeTable() {
  const any = (row) => row.trueError || row.estimate;
  const two = (v) => fixedText(v, 2);
  const table = createTable({
    name: "slopes", caption: "Slopes measured over the last meshes",
    columns: [
      textColumn("variants", (row) => row.label),
      numberColumn("meshes", (row) => any(row).count),
      numberColumn("from", (row) => any(row).from, (v) => fixedText(v, 0), "Least size"),
      numberColumn("to", (row) => any(row).to, (v) => fixedText(v, 0), "Largest size"),
      numberColumn("true error", (row) => row.trueError && row.trueError.slope, two),
      numberColumn("estimate", (row) => row.estimate && row.estimate.slope, two),
    ],
  });
  const update = (rows) => {
    table.element.hidden = rows.length === 0;
    table.update(rows);
  };
  return {element: table.element, update};
}

// Numbers as readers see them. What is unknown is a dash.

const kUnknown = "–";

function isNumber(value) {
  return typeof value === "number" && Number.isFinite(value);
}

function fixedText(value, digits) {
  return isNumber(value) ? value.toFixed(digits) : kUnknown;
}

/** 1.12e-3 */
function scientificText(value) {
  return isNumber(value) ? value.toExponential(2) : kUnknown;
}

/** Six significant digits without useless zeros. */
function exactText(value) {
  return isNumber(value) ? String(Number(value.toPrecision(6))) : kUnknown;
}

/** Six significant digits, aligned in columns. */
function significantText(value) {
  return isNumber(value) ? value.toPrecision(6) : kUnknown;
}

/** Percentages are cut, not rounded: 100.0 means all. */
function percentText(value, digits = 1) {
  const scale = 10 ** digits;
  return isNumber(value) ? (Math.floor(value * scale + 1e-6) / scale).toFixed(digits) : kUnknown;
}

function secondsText(value) {
  if (!isNumber(value)) return kUnknown;
  if (value < 0.1) return value.toFixed(3);
  return value < 10 ? value.toFixed(2) : value.toFixed(1);
}

/** "1 h 2 min", "3 min 5 s", "4.2 s" */
function durationText(seconds) {
  if (!isNumber(seconds)) return kUnknown;
  if (seconds < 60) return `${secondsText(seconds)} s`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return `${minutes} min ${Math.round(seconds % 60)} s`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** "1 cycle", "5 cycles" */
function countText(count, noun) {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

/** 10⁻³ */
function powerOfTenText(exponent) {
  const raised = (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]);
  return "10" + [...String(exponent)].map(raised).join("");
}

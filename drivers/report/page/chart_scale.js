// Axes: from values to pixels, with good ticks.

/** Maps [from, to] (decades when `isLog`) to the pixels [start, end]. */
function createScale({from, to, isLog, start, end}) {
  const [a, b] = isLog ? [Math.log10(from), Math.log10(to)] : [from, to];
  const at = (value) => start + ((isLog ? Math.log10(value) : value) - a) / (b - a) * (end - start);
  const invert = (pixel) => {
    const value = a + (pixel - start) / (end - start) * (b - a);
    return isLog ? 10 ** value : value;
  };
  const ticks = axisTicks(from, to, isLog, Math.abs(end - start));
  return {at, invert, from, to, isLog, ticks};
}

/** [{value, label}]; labels are empty for minor ticks. `length` in pixels. */
function axisTicks(from, to, isLog, length) {
  if (!isLog) return linearTicks(from, to, Math.max(2, length / 70));
  const decades = Math.log10(to / from);
  return decades < 0.8 ? linearTicks(from, to, Math.max(2, length / 90))
    : logTicks(from, to, decades, length);
}

/** Steps of 1, 2 or 5 times a power of ten, about `count` of them. */
function niceStep(range, count) {
  const rough = range / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= rough * 0.999);
}

function linearTicks(from, to, count) {
  const step = niceStep(to - from, count);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const isWide = Math.max(Math.abs(from), Math.abs(to)) >= 1e6 || digits > 5;
  const ticks = [];
  for (let i = Math.ceil(from / step - 1e-9); i <= to / step + 1e-9; ++i) {
    const value = i * step;
    ticks.push({value, label: isWide ? exponentText(value) : value.toFixed(digits)});
  }
  return ticks;
}

function exponentText(value) {
  return value === 0 ? "0" : String(Number(value.toPrecision(3)).toExponential());
}

/** Powers of ten, with 2 and 5 between them where there is room. */
function logTicks(from, to, decades, length) {
  const room = length / decades;
  const every = Math.max(1, Math.ceil(32 / room));
  const ticks = [];
  for (let e = Math.floor(Math.log10(from)); e <= Math.ceil(Math.log10(to)); ++e) {
    for (let factor = 1; factor <= 9; ++factor) {
      const value = factor * 10 ** e;
      if (value < from * 0.999 || value > to * 1.001 || (factor > 1 && room < 30)) continue;
      const isLabelled = factor === 1 ? e % every === 0
        : room > 150 && (factor === 2 || factor === 5);
      ticks.push({value, label: isLabelled ? logLabel(factor, e) : "", isMinor: factor !== 1});
    }
  }
  return ticks;
}

function logLabel(factor, exponent) {
  if (exponent >= -1 && exponent <= 4) return String(Number((factor * 10 ** exponent).toFixed(1)));
  return (factor === 1 ? "" : `${factor}·`) + powerOfTenText(exponent);
}

/** [least, largest] of the values an axis can show, with some room; null without any. */
function valueRange(values, isLog) {
  const shown = values.filter((v) => isNumber(v) && (!isLog || v > 0));
  if (shown.length === 0) return null;
  const [low, high] = [Math.min(...shown), Math.max(...shown)];
  if (isLog) {
    const room = Math.max((high / low) ** 0.06, 1.12);
    return [low / room, high * room];
  }
  const room = (high - low || Math.abs(high) || 1) * 0.05;
  return [low - room, high + room];
}

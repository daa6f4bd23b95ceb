// What the colours mean: one canvas below the picture, painted into saved pictures too.

const kLegendRow = 46;
const kLegendMost = 340;

/**
 * Items: {title, palette, ticks: [{at: 0..1, label}], band: [from, to] or null} or
 * {title, entries: [{rgb, label, isRing}]}.
 */
function legendItems(view) {
  const {quantity, range, look, mesh, edges, hasEllipses} = view;
  const items = [];
  if (quantity.names && quantity.key === "region") {
    const colours = regionColours(quantity, look);
    items.push({title: "region", entries: quantity.names.map((label, i) =>
      ({label, rgb: colours[i]}))});
  } else if (!quantity.names) {
    const {ticks, factor} = rangeTicks(openRange(range, quantity.isLog), quantity.isLog);
    items.push({title: quantity.label + factor, palette: rampPalette(kRampStops), ticks});
  }
  if (edges === "length" && mesh.edgeLengths) {
    items.push({title: "edge length in the metric", palette: rampPalette(kLengthStops),
      ticks: lengthTicks(), band: [1 / 3, 2 / 3]});
  }
  if (hasEllipses && mesh.metric) {
    items.push({title: "metric", entries: [{label: "unit circle, to scale", isRing: true,
      rgb: look.accent2}]});
  }
  return items;
}

/** {ticks, factor: what the labels are to be multiplied by, as text}. */
function rangeTicks([from, to], isLog) {
  const at = isLog ? (value) => Math.log(value / from) / Math.log(to / from)
    : (value) => (value - from) / (to - from);
  const place = (values, label) => values.map((value) => ({at: at(value), label: label(value)}))
    .filter((tick) => tick.at > -1e-6 && tick.at < 1 + 1e-6);
  if (isLog && to / from > 1e3) {
    return {factor: "", ticks: place(powersBetween(from, to), (value) =>
      powerOfTenText(Math.round(Math.log10(value))))};
  }
  const exponent = Math.floor(Math.log10(Math.max(Math.abs(from), Math.abs(to))) + 1e-9);
  const power = exponent < -2 || exponent > 4 ? exponent : 0;
  return {factor: power === 0 ? "" : ` × ${powerOfTenText(power)}`,
    ticks: place(isLog && to / from > 5 ? seriesBetween(from, to) : stepsBetween(from, to),
      (value) => signText(String(Number((value / 10 ** power).toPrecision(6)))))};
}

/** Powers of ten, every second or third one where they are many. */
function powersBetween(from, to) {
  const [first, last] = [Math.ceil(Math.log10(from) - 1e-9), Math.floor(Math.log10(to) + 1e-9)];
  const every = Math.ceil((last - first + 1) / 7);
  return Array.from({length: Math.floor((last - first) / every) + 1}, (_, i) =>
    10 ** (first + i * every));
}

/** 1, 2, 5, 10, 20, 50 ..., and 3 between them where they are few. */
function seriesBetween(from, to) {
  const first = Math.floor(Math.log10(from));
  const digits = to / from < 30 ? [1, 2, 3, 5] : [1, 2, 5];
  return Array.from({length: 5}, (_, i) => digits.map((digit) => digit * 10 ** (first + i))).flat();
}

function stepsBetween(from, to) {
  const step = niceStep(to - from, 5);
  const first = Math.ceil(from / step - 1e-9);
  return Array.from({length: Math.floor(to / step + 1e-9) - first + 1}, (_, i) =>
    (first + i) * step);
}

function lengthTicks() {
  return [0.5, 1, 2].map((length) => ({at: (Math.log2(length) / kLengthRange + 1) / 2,
    label: String(length)}));
}

/** Paints the items beside each other, or below each other where there is no room. */
function paintLegend(context, items, width, look) {
  const wide = Math.min(kLegendMost, width - 20);
  const columns = Math.max(1, Math.floor(width / (wide + 40)));
  items.forEach((item, i) => {
    context.save();
    context.translate((i % columns) * (wide + 40), Math.floor(i / columns) * kLegendRow);
    paintLegendItem(context, item, wide, look);
    context.restore();
  });
}

function legendHeight(items, width) {
  const columns = Math.max(1, Math.floor(width / (Math.min(kLegendMost, width - 20) + 40)));
  return Math.ceil(items.length / columns) * kLegendRow;
}

function paintLegendItem(context, item, width, look) {
  context.font = `12px ${look.font}`;
  context.textBaseline = "alphabetic";
  context.textAlign = "left";
  context.fillStyle = rgbText(look.muted);
  context.fillText(item.title, 8, 11, width);
  if (item.entries) paintSwatches(context, item.entries, width, look);
  else paintRamp(context, item, 8, width - 16, look);
}

function paintSwatches(context, entries, width, look) {
  let x = 8;
  for (const {rgb, label, isRing} of entries) {
    context.fillStyle = context.strokeStyle = rgbText(rgb);
    context.lineWidth = 1.25;
    context.beginPath();
    if (isRing) context.ellipse(x + 9, 23, 9, 4.5, 0, 0, 2 * Math.PI);
    else context.rect(x, 18, 14, 10);
    if (isRing) context.stroke();
    else context.fill();
    context.fillStyle = rgbText(look.text);
    context.fillText(label, x + 23, 27);
    x += 38 + context.measureText(label).width;
    if (x > width) return;
  }
}

function paintRamp(context, {palette, ticks, band}, left, width, look) {
  const [top, height] = [17, 9];
  const gradient = context.createLinearGradient(left, 0, left + width, 0);
  for (let i = 0; i <= 32; ++i) {
    gradient.addColorStop(i / 32, rgbText(paletteRgb(palette, i / 32)));
  }
  context.fillStyle = gradient;
  context.fillRect(left, top, width, height);
  context.strokeStyle = rgbText(look.text);
  context.lineWidth = 1;
  if (band) {
    context.strokeRect(left + band[0] * width, top - 1.5, (band[1] - band[0]) * width, height + 3);
  }
  context.fillStyle = rgbText(look.text);
  context.font = `11.5px ${look.font}`;
  for (const {at, label} of ticks) {
    const x = Math.round(left + at * (width - 1)) + 0.5;
    context.beginPath();
    context.moveTo(x, top + height);
    context.lineTo(x, top + height + (label ? 4 : 2));
    context.stroke();
    const half = context.measureText(label).width / 2;
    context.textAlign = "center";
    const centre = Math.min(Math.max(x, half), left + width + 8 - half);
    context.fillText(label, centre, top + height + 15);
  }
}

function legendText(items) {
  return items.map((item) => item.entries
    ? `${item.title}: ${item.entries.map(({label}) => label).join(", ")}`
    : `${item.title} from ${item.ticks[0].label} to ${item.ticks.at(-1).label}`).join("; ");
}

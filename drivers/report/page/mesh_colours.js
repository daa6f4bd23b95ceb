// Colours of fills and edges.

// From dark violet by blue and green to yellow: lightness L* grows evenly from 24 to 92, and
// neighbouring stops differ equally (OKLab).
const kRampStops = ["#3f2a7b", "#393b89", "#304b93", "#245b9a", "#1a6a9d", "#18799e", "#1d879f",
  "#2296a0", "#27a5a1", "#33b39e", "#4abf98", "#68ca8f", "#87d385", "#a6db7a", "#c5e270",
  "#e5e668", "#feea70"];

// Lengths from 2^-1.5 to 2^1.5: blue is short, grey fits, red is long.
const kLengthStops = ["#264ac9", "#3769ca", "#6d8fb9", "#9e9e9e", "#c38e66", "#d56326", "#cc2c05"];
const kLengthRange = 1.5;  // log2

const kNoValueColour = [0x8a, 0x8a, 0x8a];
const kPaletteSize = 256;

function hexRgb(text) {
  return [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16));
}

function mixRgb(a, b, share) {
  return a.map((value, i) => Math.round(value + share * (b[i] - value)));
}

function rgbText(rgb, alpha = 1) {
  return `rgba(${rgb[0]}, ${rgb[1]}, ${rgb[2]}, ${alpha})`;
}

/** kPaletteSize colours in rows of red, green, blue, alpha. */
function rampPalette(stops) {
  const colours = stops.map(hexRgb);
  return paletteOf((t) => {
    const at = Math.min(t * (colours.length - 1), colours.length - 1 - 1e-9);
    return mixRgb(colours[Math.floor(at)], colours[Math.floor(at) + 1], at % 1);
  });
}

/** The colours one after the other, none mixed. */
function blockPalette(colours) {
  return paletteOf((t) => colours[Math.min(Math.floor(t * colours.length), colours.length - 1)]);
}

function paletteOf(colourAt) {
  const palette = new Uint8Array(4 * kPaletteSize);
  for (let i = 0; i < kPaletteSize; ++i) {
    palette.set([...colourAt(i / (kPaletteSize - 1)), 255], 4 * i);
  }
  return palette;
}

/** The colour at t in [0, 1]; below 0 there is no value. */
function paletteRgb(palette, t) {
  if (!(t >= 0)) return kNoValueColour;
  const i = 4 * Math.round(Math.min(t, 1) * (kPaletteSize - 1));
  return [palette[i], palette[i + 1], palette[i + 2]];
}

/** Colours of the page as red, green, blue: {surface, text, muted, line, accent, series…}. */
function readLook(element) {
  const style = getComputedStyle(element);
  const probe = document.createElement("canvas").getContext("2d");
  const colour = (name, fallback) => {
    probe.fillStyle = fallback;
    probe.fillStyle = style.getPropertyValue(name).trim() || fallback;
    return hexRgb(probe.fillStyle);
  };
  const look = {surface: colour("--surface", "#ffffff"), text: colour("--text", "#1c2024"),
    muted: colour("--muted", "#5d666f"), line: colour("--line", "#d8dbd9"),
    accent: colour("--accent", "#0b62a8"), accent2: colour("--accent-2", "#c85200"),
    warn: colour("--warn", "#9a5b00"), font: style.fontFamily || "sans-serif"};
  const spare = ["#0b62a8", "#c85200", "#00805f", "#a3437f", "#a67c00", "#3c8fc4"];
  look.series = spare.map((fallback, i) => colour(`--series-${i + 1}`, fallback));
  look.isDark = look.surface[1] < 128;
  return look;
}

// Charts as drawings that stand on their own.

const kLooks = ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "opacity",
  "font-family", "font-size", "font-weight", "text-anchor"];

/** A copy in which colours and fonts of the style sheet have become attributes. */
function standaloneCopy(node) {
  const copy = node.cloneNode(false);
  for (const name of ["class", "style", "tabindex", "role"]) copy.removeAttribute(name);
  if (node instanceof SVGElement && !(node instanceof SVGSVGElement)) {
    const look = getComputedStyle(node);
    for (const name of kLooks) {
      const value = look.getPropertyValue(name);
      if (value && value !== "none" || name === "fill") copy.setAttribute(name, value);
    }
  }
  for (const child of node.childNodes) {
    const isShown = !(child instanceof Element) || !child.classList.contains("overlay");
    if (isShown) copy.append(child instanceof Element ? standaloneCopy(child) : child.cloneNode());
  }
  return copy;
}

function exportText(host, text, x, y, weight) {
  const node = svgElement("text", {x, y, class: "axis-label", "font-weight": weight}, text);
  host.append(node);
  return node;
}

/** Rows of the legend below the plot; returns the height they take. */
function exportLegend(chart, host, top) {
  let [x, y] = [12, top + 14];
  for (const entry of legendGroups(chart.spec).flatMap((group) => group.entries)) {
    if (chart.hidden.has(entry.label)) continue;
    const width = 44 + 6.6 * entry.label.length;
    if (x > 12 && x + width > chart.width) [x, y] = [12, y + 18];
    host.append(svgElement("g", {transform: `translate(${x} ${y - 10})`},
      [...swatch(entry.look).childNodes]));
    exportText(host, entry.label, x + 32, y);
    x += width;
  }
  return y + 12 - top;
}

/** Drawn once more, hidden in the page, so that the style sheet applies. */
function downloadSvg(chart) {
  const drawing = chart.plot.querySelector("svg");
  const height = drawing.viewBox.baseVal.height;
  const sheet = svgElement("svg", {width: chart.width, height: 0, class: "export-sheet"});
  exportText(sheet, chart.spec.title, 12, 18, 600);
  const body = svgElement("g", {transform: "translate(0 28)"});
  for (const child of drawing.childNodes) body.append(child.cloneNode(true));
  sheet.append(body);
  const total = height + 28 + exportLegend(chart, sheet, height + 30);
  chart.plot.append(sheet);
  const copy = standaloneCopy(sheet);
  sheet.remove();
  setAttributes(copy, {xmlns: "http://www.w3.org/2000/svg", height: total,
    viewBox: `0 0 ${chart.width} ${total}`});
  const background = getComputedStyle(document.documentElement).getPropertyValue("--surface");
  copy.prepend(svgElement("rect", {width: "100%", height: "100%", fill: background.trim()}));
  downloadText(fileStem(chart.spec.name) + ".svg", new XMLSerializer().serializeToString(copy),
    "image/svg+xml");
}

// The settings in which variants differ: what filters, colours and labels go by.

const kSettingLabels = {
  "run": "run", "adapt.mode": "mode", "mesh.elements": "elements", "mesh.preset": "preset",
  "adapt.target.nodes": "target vertices", "adapt.target.error": "target error",
};
/** Told apart even where a named alternative of [vary] sets them. */
const kChiefSettings = ["run", "adapt.mode", "mesh.elements"];

function settingLabel(key) {
  return kSettingLabels[key] || key.slice(key.lastIndexOf(".") + 1).replaceAll("_", " ");
}

/** "t = 0.1"; words such as "anisotropic" speak for themselves. */
function settingText(key, value) {
  const isWord = Number.isNaN(Number(value)) && value !== "true" && value !== "false";
  return isWord ? value : `${settingLabel(key)} = ${value}`;
}

function valueText(value) {
  return typeof value === "string" ? value : JSON.stringify(value);
}

/** [["problem.boundary.left", "free"], ...] of nested tables. */
function flatSettings(value, key) {
  if (value === null || typeof value !== "object" || Array.isArray(value)) return [[key, value]];
  return Object.entries(value).flatMap(([name, part]) =>
    flatSettings(part, key ? `${key}.${name}` : name));
}

/** An entry of [vary] as [{label, settings}]: a list of values or a table of alternatives. */
function alternativesOf(key, entry) {
  if (Array.isArray(entry)) {
    return entry.map((value) => ({label: valueText(value), settings: flatSettings(value, key)}));
  }
  return Object.entries(entry).map(([label, table]) =>
    ({label, settings: flatSettings(table, "")}));
}

/** The alternative of an entry of [vary] that a variant has, or null. */
function chosenAlternative(alternatives, settings) {
  const has = ([key, value]) => key in settings && valueText(settings[key]) === valueText(value);
  return alternatives.find((alternative) => alternative.settings.every(has)) || null;
}

/** {key: text} of one variant: its entries of [vary], then its other settings. */
function variantFacets(run, settings) {
  const facets = {run: run.name};
  const isCovered = new Set();
  for (const [key, entry] of Object.entries(run.vary || {})) {
    const alternative = chosenAlternative(alternativesOf(key, entry), settings);
    if (!alternative) continue;
    facets[key] = alternative.label;
    for (const [covered] of alternative.settings) isCovered.add(covered);
  }
  for (const [key, value] of Object.entries(settings)) {
    const isTold = !isCovered.has(key) || kChiefSettings.includes(key) ||
      key.startsWith("adapt.target.");
    if (isTold && key !== "report.paper") facets[key] ??= valueText(value);
  }
  return facets;
}

/** Numbers up, words in the order in which they first appear. */
function orderedValues(texts) {
  const values = [...new Set(texts)];
  const areNumbers = values.every((value) => value !== "" && !Number.isNaN(Number(value)));
  return areNumbers ? values.sort((a, b) => Number(a) - Number(b)) : values;
}

/** Settings of quadrilaterals alone, which triangles just lack, tell nothing. */
function tellsApart(key, texts) {
  const known = texts.filter((text) => text !== undefined);
  const count = new Set(key.startsWith("mesh.quad_") ? known : texts).size;
  return count > 1;
}

/** Whether a setting, where there is one, follows from another one. */
function followsFrom(variants, key, other) {
  const values = new Map();
  for (const {facets} of variants.filter((variant) => variant.facets[key] !== undefined)) {
    if (!values.has(facets[other])) values.set(facets[other], facets[key]);
    if (values.get(facets[other]) !== facets[key]) return false;
  }
  return true;
}

/** Settings that [vary] does not name are told only where they follow from nothing that it does. */
function isTold(variants, key) {
  const varied = new Set(["run", ...variants.flatMap((v) => Object.keys(v.run.vary || {}))]);
  if (kChiefSettings.includes(key) || varied.has(key)) return true;
  return ![...varied].some((other) => followsFrom(variants, key, other));
}

/** [{key, label, values}] of all settings in which the variants differ, the chief ones first. */
function varyingFacets(variants) {
  const keys = [...new Set([...kChiefSettings, ...variants.flatMap((v) => Object.keys(v.facets))])];
  const texts = (key) => variants.map((variant) => variant.facets[key]);
  const isFacet = (key) => tellsApart(key, texts(key)) && isTold(variants, key);
  return keys.filter(isFacet).map((key) => ({
    key,
    label: settingLabel(key),
    values: orderedValues(texts(key).filter((text) => text !== undefined)),
  }));
}

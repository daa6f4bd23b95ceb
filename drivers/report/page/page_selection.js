// What the reader looks at: the variants that pass the filters, the chosen one and the one beside.

function createSelection(model) {
  const selection = {
    model,
    filters: new Map(),  // key of a facet: Set of the values kept
    search: "",
    chosen: firstFinished(model.variants),
    compared: null,
    matching: model.variants,
    listeners: [],
  };
  return selection;
}

function firstFinished(variants) {
  return variants.find((variant) => variant.last !== null) || variants[0];
}

/** Calls back now and after every change. */
function onSelection(selection, callback) {
  selection.listeners.push(callback);
  callback(selection);
}

function notifySelection(selection) {
  for (const callback of selection.listeners) callback(selection);
}

function passesFilters(selection, variant) {
  for (const [key, values] of selection.filters) {
    if (values.size > 0 && !values.has(variant.facets[key])) return false;
  }
  const words = selection.search.toLowerCase().split(/\s+/).filter(Boolean);
  const text = [variant.name, ...Object.values(variant.facets)].join(" ").toLowerCase();
  return words.every((word) => text.includes(word));
}

/** To be called when filters or search text have changed. */
function refilter(selection) {
  selection.matching = selection.model.variants.filter((v) => passesFilters(selection, v));
  const {matching, chosen} = selection;
  if (matching.length > 0 && !matching.includes(chosen)) selection.chosen = firstFinished(matching);
  notifySelection(selection);
}

function toggleFilter(selection, key, value) {
  const values = selection.filters.get(key) || new Set();
  if (!values.delete(value)) values.add(value);
  selection.filters.set(key, values);
  refilter(selection);
}

function clearFilters(selection) {
  selection.filters.clear();
  selection.search = "";
  refilter(selection);
}

function chooseVariant(selection, variant) {
  if (selection.chosen === variant) return;
  selection.chosen = variant;
  notifySelection(selection);
}

function compareWith(selection, variant) {
  selection.compared = variant;
  notifySelection(selection);
}

/** The next (1) or previous (-1) variant that passes the filters, round and round. */
function stepVariant(selection, step) {
  const {matching, chosen} = selection;
  if (matching.length === 0) return;
  const index = matching.indexOf(chosen) + step;
  chooseVariant(selection, matching[(index + matching.length) % matching.length]);
}

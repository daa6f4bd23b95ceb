// Which variants are shown: by each setting that varies, and by words.

function filterPanel(selection) {
  const {model} = selection;
  const count = htmlElement("output", {class: "filter-count"});
  const search = htmlElement("input", {type: "search", id: "variant-search",
    placeholder: "name or setting",
    oninput: () => {
      selection.search = search.value;
      refilter(selection);
    }});
  const clear = smallButton("show all", "Clear all filters", () => {
    search.value = "";
    clearFilters(selection);
  });
  const panel = htmlElement("div", {class: "filters", role: "group", "aria-label": "Filters"},
    model.facets.filter(isFilter).map((facet) => facetButtons(selection, facet)),
    htmlElement("div", {class: "control"},
      htmlElement("label", {class: "control-label", for: "variant-search"}, "search"), search,
      clear, count));
  onSelection(selection, () => {
    const isAll = selection.matching.length === model.variants.length;
    count.textContent = isAll ? `${model.variants.length} variants`
      : `${selection.matching.length} of ${model.variants.length} variants`;
    clear.hidden = isAll;
  });
  return panel;
}

/** Settings with a value for each variant are better searched for. */
function isFilter(facet, index, facets) {
  return facet.values.length <= 12 || facets.length === 1;
}

/** Any number of values can be pressed; none means all. */
function facetButtons(selection, facet) {
  const isKept = (value) => Boolean(selection.filters.get(facet.key)?.has(value));
  const buttons = facet.values.map((value) => htmlElement("button",
    {type: "button", "aria-pressed": "false",
      onclick: () => toggleFilter(selection, facet.key, value)}, value));
  onSelection(selection, () => {
    buttons.forEach((b, i) => b.setAttribute("aria-pressed", String(isKept(facet.values[i]))));
  });
  return htmlElement("div", {class: "control", role: "group", "aria-label": facet.label},
    htmlElement("span", {class: "control-label"}, facet.label),
    htmlElement("span", {class: "segments"}, buttons));
}

// The bar that stays in view and says whose meshes and charts are shown.

function addChooser(host, selection) {
  const {variants} = selection.model;
  const byId = (id) => variants.find((variant) => variant.id === id) || null;
  const chosen = htmlElement("select", {"aria-label": "Variant",
    onchange: () => chooseVariant(selection, byId(chosen.value))});
  const compared = htmlElement("select", {"aria-label": "Variant beside it",
    onchange: () => compareWith(selection, byId(compared.value))});
  const position = htmlElement("output", {class: "position"});
  const step = (label, title, by) => htmlElement("button",
    {type: "button", class: "step", title, "aria-label": title,
      onclick: () => stepVariant(selection, by)}, label);
  host.append(htmlElement("div", {class: "chooser", role: "group", "aria-label": "Variant shown"},
    htmlElement("span", {class: "control-label"}, "variant"),
    step("‹", "Previous variant", -1), chosen, step("›", "Next variant", 1), position,
    htmlElement("label", {class: "control"},
      htmlElement("span", {class: "control-label"}, "beside it"), compared)));
  onSelection(selection, () => {
    setChoices(chosen, variantChoices(selection.matching), selection.chosen.id);
    setChoices(compared, [{value: "", label: "nothing"}, ...variantChoices(variants)],
      selection.compared ? selection.compared.id : "");
    const index = selection.matching.indexOf(selection.chosen) + 1;
    position.textContent = `${index} of ${selection.matching.length}`;
  });
}

function variantChoices(variants) {
  return variants.map((variant) => ({value: variant.id, label: variant.name}));
}

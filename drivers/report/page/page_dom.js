// Elements. Text from studies reaches the page only as text nodes.

/** Sets attributes; functions named on… become listeners, null and false are left out. */
function setAttributes(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) {
      node.setAttribute(name, value);
    }
  }
  return node;
}

/** Appends nodes, and texts as text nodes; null is left out. */
function appendAll(node, children) {
  node.append(...children.flat(Infinity).filter((c) => c !== null && c !== undefined));
  return node;
}

function htmlElement(tag, attributes = {}, ...children) {
  return appendAll(setAttributes(document.createElement(tag), attributes), children);
}

function svgElement(tag, attributes = {}, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  return appendAll(setAttributes(node, attributes), children);
}

function smallButton(label, title, onclick) {
  return htmlElement("button", {type: "button", class: "small", title, onclick}, label);
}

/** Buttons of which one is pressed; `choices`: [{value, label, title?}]. */
function segmentedButtons(label, choices, value, onchange) {
  const buttons = choices.map((choice) =>
    htmlElement("button", {
      type: "button",
      title: choice.title,
      "aria-pressed": String(choice.value === value),
      onclick: () => {
        buttons.forEach((b, i) => b.setAttribute("aria-pressed", choices[i] === choice));
        onchange(choice.value);
      },
    }, choice.label));
  return htmlElement("div", {class: "control", role: "group", "aria-label": label},
    htmlElement("span", {class: "control-label"}, label),
    htmlElement("span", {class: "segments"}, buttons));
}

/** A labelled list to choose from; `choices`: [{value, label}], values are texts. */
function choiceList(label, choices, value, onchange) {
  const select = htmlElement("select", {onchange: () => onchange(select.value)});
  setChoices(select, choices, value);
  return htmlElement("label", {class: "control"},
    htmlElement("span", {class: "control-label"}, label), select);
}

function setChoices(select, choices, value) {
  select.replaceChildren(...choices.map((choice) => {
    const option = htmlElement("option", {value: choice.value}, choice.label);
    option.selected = choice.value === value;
    return option;
  }));
}

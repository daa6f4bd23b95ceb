// The keyboard on the stage.

const kMeshKeys = [
  ["arrow keys", "move",
    {ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down"}],
  ["+ −", "zoom", {"+": "in", "=": "in", "-": "out"}],
  ["0 or f", "show all", {0: "fit", f: "fit"}],
  ["[ ] or , .", "previous and next cycle", {"[": "previous", ",": "previous", "]": "next",
    ".": "next"}],
  ["c", "next colours", {c: "colour"}],
  ["e", "edges", {e: "edges"}],
  ["m", "ellipses of the metric", {m: "ellipses"}],
  ["Enter", "inspect the element in the middle", {Enter: "inspect"}],
  ["Esc", "close", {Escape: "close"}],
];
const kMeshActions = Object.assign({}, ...kMeshKeys.map(([, , actions]) => actions));

/** `act`: functions by the names of the actions. */
function watchKeys(stage, act) {
  stage.addEventListener("keydown", (event) => {
    if (event.target !== stage || event.ctrlKey || event.metaKey || event.altKey) return;
    const action = kMeshActions[event.key];
    if (!action || act[action]() === false) return;
    event.preventDefault();
  });
}

function fillKeyHelp(panel, close) {
  const rows = [["wheel, pinch", "zoom"], ["drag", "move"], ["Shift and drag", "zoom to a box"],
    ["click", "inspect an element"], ...kMeshKeys];
  panel.replaceChildren(
    htmlElement("div", {class: "mesh-panel-head"}, htmlElement("strong", {}, "Mouse and keys"),
      htmlElement("button", {type: "button", class: "mesh-close", "aria-label": "Close",
        title: "Close (Esc)", onclick: close}, "×")),
    htmlElement("dl", {}, rows.map(([keys, meaning]) =>
      htmlElement("div", {}, htmlElement("dt", {}, keys), htmlElement("dd", {}, meaning)))));
}

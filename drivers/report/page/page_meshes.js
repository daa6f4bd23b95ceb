// The meshes of the chosen variant, and of another beside it.

function buildMeshes(host, report) {
  const {selection} = report;
  const pair = htmlElement("div", {class: "mesh-pair"});
  host.append(pair);
  const main = meshHost(pair);
  const beside = meshHost(pair);
  let isLinking = false;
  /** What is done in one view is done in the other. */
  const link = (from, to) => from.view.onChange(() => {
    if (isLinking || !selection.compared || !to.view) return;
    isLinking = true;
    to.view.setState(from.view.state());
    isLinking = false;
  });
  showMeshes(main, selection.chosen);
  onSelection(selection, () => {
    showMeshes(main, selection.chosen);
    beside.element.hidden = selection.compared === null;
    pair.classList.toggle("single", selection.compared === null);
    if (selection.compared === null) return;
    const isFirst = !beside.view;
    showMeshes(beside, selection.compared);
    if (!isFirst) return;
    link(main, beside);
    link(beside, main);
  });
}

function meshHost(pair) {
  const caption = htmlElement("p", {class: "caption"});
  const element = htmlElement("div", {class: "mesh-host"}, caption);
  pair.append(element);
  return {element, caption, view: null, shown: null};
}

/** The last meshes may not have come in yet. */
async function loadParsedMesh(id) {
  if (document.readyState === "loading") {
    await new Promise((done) => document.addEventListener("DOMContentLoaded", done));
  }
  return loadMesh(id);
}

function showMeshes(host, variant) {
  if (host.shown === variant) return;
  host.shown = variant;
  host.caption.textContent = variant.name;
  host.view ??= createMeshView(host.element, {loadMesh: loadParsedMesh, title: "Mesh"});
  host.view.show({name: variant.name, meshes: variant.meshes});
}

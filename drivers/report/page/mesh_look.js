// Colours and edges of a view as the reader has chosen them.

/** Colours as chosen, or none where the mesh lacks what they mean. */
function colourMesh(view) {
  const {mesh, controls} = view;
  if (!mesh) return;
  view.look ??= readLook(view.element);
  view.quantity = view.quantities.find(({key}) => key === view.colour) || view.quantities[0];
  view.range = shownRange(view);
  view.renderer.setFill(quantityFill(view.quantity, view.range, view.look));
  view.renderer.setEdges(edgeLook(view));
  controls.colour.value = view.quantity.key;
  markEdges(controls.edges, view.edges, mesh.edgeLengths !== null);
  controls.ellipses.input.checked = view.hasEllipses;
  controls.ellipses.input.disabled = mesh.metric === null;
  controls.sameRange.input.checked = view.isSameRange;
  controls.sameRange.element.hidden = Boolean(view.quantity.names || view.quantity.bounds);
}

function shownRange({quantity, sharedRange, isSameRange, name}) {
  if (quantity.names) return null;
  return isSameRange && sharedRange?.key === quantity.key && sharedRange.name === name
    ? sharedRange.range : quantityRange(quantity);
}

function edgeLook({mesh, edges, quantity, look}) {
  const isLength = edges === "length" && mesh.edgeLengths !== null;
  return {isShown: edges !== "hidden",
    positions: isLength ? lengthPositions(mesh.edgeLengths) : null,
    palette: isLength ? rampPalette(kLengthStops) : null,
    colour: quantity.names ? look.text : [16, 20, 26],
    width: isLength ? 1.6 : 1, alpha: isLength ? 1 : quantity.names ? 0.55 : 0.4,
    fadeBelow: isLength ? 3 : 5, leastFade: isLength ? 0.3 : 0.04};
}

/** The range of the shown quantity over all cycles, which are loaded for it. */
async function uniteRanges(view, request = view.request) {
  const {key} = view.quantity || {};
  const meshes = await Promise.all(view.entries.filter(({id}) => id !== null)
    .map(({id}) => view.options.loadMesh(id)));
  if (request !== view.request || !view.isSameRange || view.quantity?.key !== key) return;
  const ranges = meshes.map((mesh) => meshQuantities(mesh).find((q) => q.key === key))
    .filter(Boolean).map(quantityRange);
  view.sharedRange = {key, name: view.name, range: unitedRange(ranges)};
  colourMesh(view);
  drawMeshView(view);
}

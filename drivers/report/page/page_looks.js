// Colours and markers that tell variants apart by their settings.

const kModeColors = {isotropic: "var(--accent-2)", anisotropic: "var(--accent)"};

function canTell(facet, most) {
  return facet.values.length <= most && !facet.key.startsWith("adapt.target");
}

/** Whether all variants that a line may join have one value. */
function isOfFamilies(model, {key}) {
  return model.families.every(({variants}) =>
    variants.every((variant) => variant.facets[key] === variants[0].facets[key]));
}

/** {color, marker}: keys of the settings that colours and markers stand for, "" for none. */
function defaultLooks(model) {
  const facets = model.facets.filter((facet) => isOfFamilies(model, facet));
  const color = facets.find((facet) => canTell(facet, 8))?.key || "";
  const marker = facets.find((facet) => facet.key !== color && canTell(facet, kMarkers.length));
  return {color, marker: marker?.key || ""};
}

function facetOf(model, key) {
  return model.facets.find((facet) => facet.key === key) || null;
}

function valueColor(facet, value) {
  if (!facet) return "var(--accent)";
  return kModeColors[value] || seriesColor(Math.max(facet.values.indexOf(value), 0));
}

function valueMarker(facet, value) {
  return kMarkers[facet ? Math.max(facet.values.indexOf(value), 0) % kMarkers.length : 0];
}

function variantLook(model, looks, variant) {
  const [color, marker] = [facetOf(model, looks.color), facetOf(model, looks.marker)];
  return {
    color: valueColor(color, variant.facets[looks.color]),
    marker: valueMarker(marker, variant.facets[looks.marker]),
  };
}

/** Legend entries by setting; each shows and hides the series of its value. */
function lookLegend(model, looks, series) {
  const [color, marker] = [facetOf(model, looks.color), facetOf(model, looks.marker)];
  const entries = (facet, lookOf) => facet.values.map((value) => ({
    label: settingText(facet.key, value), look: lookOf(value),
    series: series.filter((s) => s.variant.facets[facet.key] === value),
  })).filter((entry) => entry.series.length > 0);
  const groups = [];
  if (color) {
    groups.push({title: color.label, entries: entries(color, (value) =>
      ({color: valueColor(color, value), marker: marker ? null : "circle"}))});
  }
  if (marker) {
    groups.push({title: marker.label, entries: entries(marker, (value) =>
      ({color: "var(--muted)", marker: valueMarker(marker, value), hasLine: false}))});
  }
  return groups;
}

/** Lists to choose what colours and markers stand for. */
function lookControls(model, looks, redraw) {
  if (model.facets.length < 2) return [];
  const choices = (most) => [{value: "", label: "nothing"}, ...model.facets
    .filter((facet) => facet.values.length <= most)
    .map((facet) => ({value: facet.key, label: facet.label}))];
  const list = (label, name, most) => choiceList(label, choices(most), looks[name], (value) => {
    looks[name] = value;
    redraw();
  });
  return [list("colour", "color", 8), list("marker", "marker", kMarkers.length)];
}

// What a mesh can be coloured by.

/**
 * [{key, group, label, on: "vertex" | "element", values, isLog, bounds: fixed range or null,
 * names: of the classes, else null}]
 */
function meshQuantities(mesh) {
  const list = [{key: "none", group: "mesh", label: "nothing", on: "element",
    ...regionClasses(mesh)}];
  if (mesh.regions.tags) {
    list.push({key: "region", group: "mesh", label: "region", on: "element",
      ...regionClasses(mesh)});
  }
  for (const on of ["vertex", "element"]) {
    for (const field of mesh.fields.filter((f) => f.on === on)) {
      list.push({key: `${on}:${field.name}`, group: on === "vertex" ? "solution" : "error",
        label: fieldLabel(field), on, values: field.values, isLog: field.isLog});
    }
  }
  if (mesh.quality) {
    list.push({key: "quality", group: "mesh", label: "quality in the metric", on: "element",
      values: mesh.quality, bounds: [0, 1]});
  }
  list.push({key: "size", group: "mesh", label: "element size", on: "element", isLog: true,
    values: meshGeometry(mesh).sizes});
  return list;
}

function fieldLabel({name, on}) {
  return on === "element" && name === "indicator" ? "error indicator" : name;
}

/** Regions as numbers 0, 1, ... */
function regionClasses(mesh) {
  const {tags, names} = mesh.regions;
  const keys = Object.keys(names);
  const order = new Map(keys.map((key, i) => [Number(key), i]));
  return {values: tags ? tags.map((tag) => order.get(tag)) : new Float64Array(mesh.elements),
    names: keys.length > 0 ? keys.map((key) => names[key] || `region ${key}`) : ["region"]};
}

/** [least, most] of what can be shown, or null when there is nothing. */
function quantityRange({values, isLog, bounds}) {
  if (bounds) return bounds;
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    if (!Number.isFinite(value) || (isLog && value <= 0)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  if (least > most) return null;
  return isLog ? [Math.max(least, most * 1e-9), most] : [least, most];
}

function unitedRange(ranges) {
  const known = ranges.filter(Boolean);
  if (known.length === 0) return null;
  return [Math.min(...known.map((r) => r[0])), Math.max(...known.map((r) => r[1]))];
}

/** A range with some extent. */
function openRange(range, isLog) {
  if (!range) return isLog ? [0.1, 1] : [0, 1];
  const [least, most] = range;
  if (isLog) return most > least * 1.0001 ? range : [least / 1.5, most * 1.5];
  const room = Math.max(Math.abs(least), Math.abs(most)) * 1e-9;
  return most - least > room ? range : [least - (Math.abs(least) || 1) / 2,
    most + (Math.abs(most) || 1) / 2];
}

/** Where values lie in a range, 0 to 1; -1 without a value. */
function rangePositions(values, range, isLog) {
  const scale = isLog ? Math.log : (value) => value;
  const [a, b] = openRange(range, isLog).map(scale);
  return Float32Array.from(values, (value) => {
    if (!Number.isFinite(value)) return -1;
    const t = value <= 0 && isLog ? 0 : (scale(value) - a) / (b - a);
    return Math.min(Math.max(t, 0), 1);
  });
}

/** {on, positions, palette}: the colours of all elements or vertices. */
function quantityFill(quantity, range, look) {
  if (quantity.names) {
    const count = quantity.names.length;
    return {on: "element", palette: blockPalette(regionColours(quantity, look)),
      positions: Float32Array.from(quantity.values, (i) => (i + 0.5) / count)};
  }
  return {on: quantity.on, palette: rampPalette(kRampStops),
    positions: rangePositions(quantity.values, range, quantity.isLog)};
}

function regionColours(quantity, look) {
  const share = quantity.key === "region" ? 0.5 : look.isDark ? 0.16 : 0.1;
  return quantity.names.map((_, i) =>
    mixRgb(look.surface, look.series[i % look.series.length], share));
}

/** Metric lengths of edges on the ramp from short to long. */
function lengthPositions(lengths) {
  return Float32Array.from(lengths, (length) => Number.isFinite(length)
    ? Math.min(Math.max((Math.log2(length) / kLengthRange + 1) / 2, 0), 1) : -1);
}

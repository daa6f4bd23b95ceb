// The data of the page, with the variants of all runs in one list.

/** Runs as in the report data; variants with name, run, settings by which they differ, cycles. */
function readModel() {
  const data = JSON.parse(document.getElementById("report-data").textContent);
  const variants = data.runs.flatMap((run, r) =>
    run.variants.map((variant, v) => modelVariant(run, variant, `${r}-${v}`)));
  const isSeveral = data.runs.length > 1;
  for (const variant of variants) variant.name = variantName(variant, isSeveral);
  const facets = varyingFacets(variants).filter((facet) => isSeveral || facet.key !== "run");
  const model = {version: data.version, runs: data.runs, isSeveral, variants, facets};
  model.families = familiesOf(model);
  return model;
}

function modelVariant(run, data, id) {
  return {
    id, run, data,
    cycles: data.cycles,
    last: data.cycles.at(-1) || null,
    facets: variantFacets(run, data.settings),
    profiles: data.profiles || [],
    meshes: data.meshes || [],
  };
}

function variantName(variant, isSeveral) {
  if (!isSeveral) return variant.data.name;
  const isOnly = variant.run.variants.length === 1;
  return isOnly ? variant.run.name : `${variant.run.name}: ${variant.data.name}`;
}

/**
 * Variants that differ only in the size asked for ("adapt.target..."), with what tells the family
 * from others: [{label, variants}].
 */
function familiesOf(model) {
  const families = new Map();
  for (const variant of model.variants) {
    const settings = Object.entries(variant.data.settings)
      .filter(([key]) => !key.startsWith("adapt.target") && key !== "report.paper");
    const key = JSON.stringify([variant.run.name, settings]);
    if (!families.has(key)) families.set(key, {variants: []});
    families.get(key).variants.push(variant);
  }
  for (const family of families.values()) family.label = familyLabel(model, family);
  return [...families.values()];
}

function familyLabel(model, family) {
  if (family.variants.length === 1) return family.variants[0].name;
  const [first] = family.variants;
  const isShared = ({key}) => family.variants.every((v) => v.facets[key] === first.facets[key]);
  const isKnown = ({key}) => first.facets[key] !== undefined;
  const texts = model.facets.filter(isShared).filter(isKnown)
    .map(({key}) => settingText(key, first.facets[key]));
  return texts.join(", ") || "all variants";
}

function cycleName(cycle) {
  return cycle === 0 ? "initial mesh" : `cycle ${cycle}`;
}

/** Whether the statistics of a variant are also known against the formula of its metric. */
function hasExactMetric(variant) {
  return variant.last !== null && variant.last.quality.against === "exact";
}

/** Prescribed metrics are meshed, nothing is solved. */
function hasProblem(variant) {
  return variant.last === null ? Boolean(variant.run.problem) : variant.last.dofs !== 0;
}

function totalSeconds(variant) {
  return variant.cycles.reduce((sum, cycle) => sum + cycleSeconds(cycle), 0);
}

function cycleSeconds(cycle) {
  return Object.values(cycle.seconds).reduce((sum, value) => sum + (value || 0), 0);
}

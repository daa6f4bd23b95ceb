// The charts of the report page in a real browser: exact values by mouse, keyboard and as files.
//
//   node charts.mjs RESULTS

import assert from "node:assert/strict";
import {test} from "node:test";
import {parseCsv} from "./csv.mjs";
import {chosenName, countOf, historyOf, pageOf, pressButton, resultText, saveButton, scrollThrough,
  textsOf, withPage} from "./report_page.mjs";

const problemPage = pageOf("problem");
const {variants} = historyOf("problem");

/** Rows of numbers and texts of a chart or a table as its reader saves them. */
async function savedRows(page, name) {
  const {text} = await page.download(() => page.click(saveButton(name, "CSV")));
  return parseCsv(text);
}

/** {title, rows: {label: value}} of a shown tooltip, else null. */
const tooltipOf = (name) => `(() => {
  const box = document.querySelector('[data-name="${name}"] .tooltip');
  if (box.hidden) return null;
  const cells = [...box.querySelectorAll("tr")].map((row) => [...row.cells]);
  return {title: box.querySelector("strong").textContent,
    rows: Object.fromEntries(cells.map((row) => row.map((cell) => cell.textContent)))};
})()`;

test("every chart and table gives its numbers as CSV", async () => {
  const checked = new Set();
  const checkSome = async (page) => {
    await scrollThrough(page);
    const names = await page.evaluate(`[...document.querySelectorAll("figure[data-name]")]
      .filter((figure) => !figure.hidden).map((figure) => figure.dataset.name)`);
    assert.ok(names.length >= 11, names.join());
    // Chromium asks before it saves more than ten files from one page.
    for (const name of names.filter((n) => !checked.has(n)).slice(0, 10)) {
      const rows = await savedRows(page, name);
      assert.ok(rows.length > 1, name);
      for (const row of rows) assert.equal(row.length, rows[0].length, name);
      checked.add(name);
    }
    return checked.size === names.length;
  };
  let isDone = false;
  while (!isDone) {
    await withPage(problemPage, {}, async (page) => {
      isDone = await checkSome(page);
    });
  }
});

test("the numbers of the error chart are those of history.json", async () => {
  await withPage(problemPage, {}, async (page) => {
    await scrollThrough(page);
    await pressButton(page, "meshes", "all cycles");
    const [header, ...rows] = await savedRows(page, "error");
    const columns = ["variant", "cycle", "unknowns", "true error"].map((c) => header.indexOf(c));
    const wanted = variants.flatMap(({name, cycles}) => cycles.map((cycle) =>
      [name, cycle.cycle, cycle.dofs, cycle.error.relative_energy].map(String)));
    assert.deepEqual(rows.map((row) => columns.map((c) => row[c])), wanted);
  });
});

/** Whether a tooltip of the error chart tells what history.json says. */
function checkErrorTooltip({title, rows}) {
  const [name, cycle] = title.split(", cycle ");
  const {dofs, error} = variants.find((v) => v.name === name).cycles[Number(cycle)];
  assert.equal(rows.unknowns, String(dofs));
  assert.equal(Number(rows["true error"]), Number(error.relative_energy.toPrecision(6)));
  assert.equal(Number(rows.effectivity), Number(error.effectivity.toPrecision(6)));
}

test("tooltips tell exact values by mouse and by keyboard", async () => {
  await withPage(problemPage, {width: 1400, height: 1000}, async (page) => {
    await scrollThrough(page);
    await page.hover(await page.middle('[data-name="error"] .series:last-of-type .marker'));
    const first = await page.evaluate(tooltipOf("error"));
    checkErrorTooltip(first);
    await page.evaluate(`document.querySelector('[data-name="error"] .plot svg').focus()`);
    await page.key("ArrowUp");
    const second = await page.evaluate(tooltipOf("error"));
    checkErrorTooltip(second);
    assert.notEqual(second.title, first.title);
    await page.key("Enter");
    assert.equal(await chosenName(page), second.title.split(", ")[0]);
    await page.key("Escape");
    assert.equal(await page.evaluate(tooltipOf("error")), null);
  });
});

test("legends show and hide series and cover no data", async () => {
  await withPage(problemPage, {}, async (page) => {
    await scrollThrough(page);
    const chart = '[data-name="error"]';
    const all = await page.evaluate(countOf(`${chart} .series`));
    await page.evaluate(`[...document.querySelectorAll('${chart} .legend-entry')]
      .find((entry) => entry.textContent === "isotropic").click()`);
    assert.equal(await page.evaluate(countOf(`${chart} .series`)), all / 2);
    const isBeside = await page.evaluate(`(() => {
      const [plot, legend] = [".plot", ".legend"].map((part) =>
        document.querySelector('${chart} ' + part).getBoundingClientRect());
      return legend.left >= plot.right || legend.top >= plot.bottom;
    })()`);
    assert.ok(isBeside);
  });
});

test("a chart can be saved as a drawing that needs nothing else", async () => {
  await withPage(problemPage, {}, async (page) => {
    await scrollThrough(page);
    const {name, text} = await page.download(() => page.click(saveButton("error", "SVG")));
    assert.equal(name, "error.svg");
    assert.match(text, /^<svg [^>]*xmlns="http:/);
    assert.ok(!text.includes("var(") && !text.includes("class="), "looks are attributes");
    assert.ok(text.includes("anisotropic"), "the legend is in it");
    const errors = await page.evaluate(`new DOMParser()
      .parseFromString(${JSON.stringify(text)}, "image/svg+xml")
      .querySelectorAll("parsererror").length`);
    assert.equal(errors, 0);
  });
});

test("distributions are those of history.json and lie over the unit band", async () => {
  await withPage(problemPage, {}, async (page) => {
    await scrollThrough(page);
    const {name, cycles} = variants[0];
    const rows = await savedRows(page, `edge-lengths-${name}`);
    for (const {cycle, edges, edge_length: {histogram: {bounds, counts}}} of cycles) {
      const shown = rows.filter((row) => row[0] === String(cycle));
      assert.equal(shown.reduce((sum, row) => sum + Number(row[3]), 0), edges);
      for (const [, from, to, count, percent] of shown) {
        const bin = to === "" ? counts.length - 1 : bounds.indexOf(Number(to));
        assert.equal(Number(count), counts[bin], `from ${from} to ${to}`);
        assert.ok(Math.abs(Number(percent) - 100 * counts[bin] / edges) < 1e-9);
      }
    }
    // Triangles and quadrilaterals, side by side.
    assert.deepEqual((await page.evaluate(textsOf("#distributions .chart .caption"))).slice(0, 2),
      ["Edge lengths, triangles", "Edge lengths, quadrilaterals"]);
    assert.ok(await page.evaluate(countOf("#distributions .band")) >= 2);
  });
});

test("distributions against the formula and the background differ", async () => {
  await withPage(pageOf("metric"), {}, async (page) => {
    await scrollThrough(page);
    const path = () => page.evaluate(
      `document.querySelector('#distributions .series:nth-of-type(2) path').getAttribute("d")`);
    const exact = await path();
    await pressButton(page, "against", "background metric");
    assert.notEqual(await path(), exact);
  });
});

test("profiles show the values of the files and open the layer", async () => {
  await withPage(problemPage, {width: 1400, height: 1000}, async (page) => {
    await scrollThrough(page);
    const {name, cycles} = variants[0];
    const chart = await page.evaluate(
      `document.querySelector('#profiles figure').dataset.name`);
    const quantity = chart.slice(chart.lastIndexOf("-") + 1);
    const last = cycles.at(-1).cycle;
    const [header, ...lines] = parseCsv(resultText("problem", name, "lines",
      `cycle-${last}-across.csv`));
    const rows = (await savedRows(page, chart)).filter((row) => row[0] === `cycle ${last}`);
    assert.equal(rows.length, lines.length);
    rows.forEach((row, i) => {
      const wanted = Number(lines[i][header.indexOf(quantity)]);
      assert.ok(Math.abs(Number(row[2]) - wanted) <= 1e-6 * Math.abs(wanted), row.join());
    });
    await zoomByDrag(page, "#profiles");
    await pressButton(page, "distance", "log from the start");
    assert.match((await page.evaluate(textsOf("#profiles .axis-label"))).join(), /from the start/);
  });
});

/** Drags over the left half of a chart and shows all again. */
async function zoomByDrag(page, section) {
  const ticks = () => page.evaluate(textsOf(`${section} .tick`));
  const before = await ticks();
  const {x, y} = await page.middle(`${section} .plot svg`);
  await page.drag({x: x - 300, y}, {x: x - 100, y});
  assert.notDeepEqual(await ticks(), before);
  await page.click(`${section} button[title="Show all again"]`);
  assert.deepEqual(await ticks(), before);
}

// The report page in a real browser: what stands on it, how it is read, saved and printed.
//
//   node page.mjs RESULTS

import assert from "node:assert/strict";
import {test} from "node:test";
import {chosenName, countOf, enter, historyOf, pageOf, pressButton, resultPath, resultText, rowsOf,
  scrollThrough, textsOf, withPage} from "./report_page.mjs";

const problemPage = pageOf("problem");
const history = historyOf("problem");
const names = history.variants.map((variant) => variant.name);

test("no two scripts of the page give one name to two things", () => {
  const [, script] = /<script>\n([^]*?)<\/script>/.exec(resultText("problem", "report.html"));
  const given = [...script.matchAll(/^(?:async )?(?:function\*?|const|let|class) (\w+)/gm)]
    .map((match) => match[1]);
  assert.ok(given.length > 200);
  assert.deepEqual(given.filter((name, i) => given.indexOf(name) !== i), []);
});

test("every section is there and the results are those of history.json", async () => {
  await withPage(problemPage, {}, async (page) => {
    const ids = await scrollThrough(page);
    assert.deepEqual(ids.filter((id) => id !== "profiles"), ["results", "comparison", "meshes",
      "distributions", "convergence", "timings", "study"]);
    const rows = await page.evaluate(rowsOf("results"));
    assert.deepEqual(rows.map((row) => row.slice(0, 6)), history.variants.map(({name, cycles}) => {
      const {cycle, vertices, dofs, error} = cycles.at(-1);
      return [name, String(cycle), String(vertices), String(dofs),
        error.estimate.toExponential(2), error.relative_energy.toExponential(2)];
    }));
    const [studied] = await page.evaluate(textsOf(".studied"));
    assert.match(studied, /^Scalar problem: 8 variants, .*target vertices \(60, 150\)/);
    const compared = await page.evaluate(rowsOf("comparison"));
    assert.deepEqual(compared.map((row) => row[5]),
      history.comparison.map(({ratio}) => ratio.vertices.toFixed(3)));
  });
});

test("the results are on the page at its first view", async () => {
  await withPage(problemPage, {width: 1400, height: 1000}, async (page) => {
    await page.waitFor('performance.getEntriesByName("first-contentful-paint").length > 0');
    const [paint, started] = await page.evaluate(`[
      performance.getEntriesByName("first-contentful-paint")[0].startTime,
      performance.getEntriesByName("report-started")[0].startTime]`);
    console.log(`first paint after ${Math.round(paint)} ms, results after ${Math.round(started)}`);
    assert.ok(paint > 0 && started > 0);
  });
});

test("no page scrolls sideways whatever its width", async () => {
  for (const width of [360, 400, 768, 1400]) {
    await withPage(problemPage, {width, height: 800}, async (page) => {
      await scrollThrough(page);
      assert.equal(await page.evaluate("document.documentElement.scrollWidth"), width);
    });
  }
});

test("the theme follows the system and the reader", async () => {
  await withPage(problemPage, {dark: true}, async (page) => {
    const theme = () => page.evaluate("document.documentElement.dataset.theme");
    const colour = () => page.evaluate("getComputedStyle(document.body).backgroundColor");
    assert.equal(await theme(), "dark");
    const dark = await colour();
    await page.evaluate(
      'document.addEventListener("themechange", () => { window.hasChanged = true; })');
    await pressButton(page, "Theme", "light");
    assert.equal(await theme(), "light");
    assert.notEqual(await colour(), dark);
    assert.equal(await page.evaluate("window.hasChanged"), true);
    await pressButton(page, "Theme", "auto");
    assert.equal(await theme(), "dark");
  });
});

test("filters and search leave the variants that fit", async () => {
  await withPage(problemPage, {}, async (page) => {
    const shown = async () => (await page.evaluate(rowsOf("results"))).map((row) => row[0]);
    await pressButton(page, "mode", "anisotropic");
    await pressButton(page, "elements", "triangle");
    assert.deepEqual(await shown(), ["anisotropic-triangle-60", "anisotropic-triangle-150"]);
    assert.deepEqual(await page.evaluate(textsOf(".filter-count")), ["2 of 8 variants"]);
    assert.equal(await chosenName(page), "anisotropic-triangle-60");
    await enter(page, "#variant-search", "150");
    assert.deepEqual(await shown(), ["anisotropic-triangle-150"]);
    await enter(page, "#variant-search", "no such thing");
    assert.deepEqual(await shown(), []);
    await page.click(".filters button.small");
    assert.deepEqual(await shown(), names);
  });
});

test("tables sort by numbers up and down", async () => {
  await withPage(problemPage, {}, async (page) => {
    const column = async () =>
      (await page.evaluate(rowsOf("results"))).map((row) => Number(row[5]));
    const head = '[data-name="results"] thead th:nth-child(6)';
    await page.click(`${head} button`);
    const up = await column();
    assert.deepEqual(up, [...up].sort((a, b) => a - b));
    await page.click(`${head} button`);
    assert.deepEqual(await column(), [...up].reverse());
    assert.equal(await page.evaluate(countOf(`${head}[aria-sort="descending"]`)), 1);
  });
});

test("a row and the arrows and the list choose the variant", async () => {
  await withPage(problemPage, {}, async (page) => {
    await scrollThrough(page);
    await page.click('[data-name="results"] tbody tr:nth-child(3) .pick');
    assert.equal(await chosenName(page), names[2]);
    await page.click('.chooser [aria-label="Next variant"]');
    assert.equal(await chosenName(page), names[3]);
    await enter(page, ".chooser select", "0-5");
    const notes = await page.evaluate(textsOf("#distributions .note"));
    assert.ok(notes.includes(names[5]), notes.join());
    assert.deepEqual(await page.evaluate(textsOf('[data-name="results"] [aria-current] .pick')),
      [names[5]]);
  });
});

test("the page gives the CSV files of the run byte for byte", async () => {
  await withPage(problemPage, {}, async (page) => {
    for (const name of ["history.csv", "comparison.csv"]) {
      const saved = await page.download(() => page.click(`button[title="Save ${name}"]`));
      assert.equal(saved.name, name);
      assert.equal(saved.text, resultText("problem", name));
    }
  });
});

test("a prescribed metric has the row of the paper below ours", async () => {
  await withPage(pageOf("metric"), {}, async (page) => {
    const ids = await scrollThrough(page);
    assert.ok(!ids.includes("convergence"));
    const rows = await page.evaluate(rowsOf("meshes"));
    assert.deepEqual(rows.map((row) => row[0]), ["triangle", "against the background",
      "paper, Fig. 13d", "quadrilateral", "against the background", "paper, Fig. 13e"]);
    assert.deepEqual(rows[2].slice(1, 7), ["508", "916", "1423", "98", "0.954", "0.536"]);
    // Sorting keeps them together.
    await page.click('[data-name="meshes"] thead th:nth-child(2) button');
    assert.equal((await page.evaluate(rowsOf("meshes")))[2][0], "paper, Fig. 13e");
  });
});

test("a variant that failed says why", async () => {
  await withPage(pageOf("failing"), {}, async (page) => {
    await scrollThrough(page);
    const rows = await page.evaluate(rowsOf("meshes"));
    assert.match(rows.find((row) => row[0] === "10").at(-1), /more than the limit of 10/);
    await enter(page, ".chooser select", "0-1");
  });
});

/** The smallest error that both runs reach with the variants i and i + 1. */
function commonError(i) {
  const least = (run) => Math.min(...historyOf(run).variants.slice(i, i + 2)
    .flatMap(({cycles}) => cycles.slice(1).map((cycle) => cycle.error.relative_energy)));
  return Math.max(least("problem"), least("problem-paper")).toExponential(2);
}

test("several runs stand on one page and are compared at equal error", async () => {
  await withPage(resultPath("several.html"), {}, async (page) => {
    await scrollThrough(page);
    const shown = async () => (await page.evaluate(rowsOf("results"))).map((row) => row[0]);
    const of = (run) => names.map((name) => `${run}: ${name}`);
    assert.deepEqual(await shown(), [...of("problem"), ...of("problem-paper")]);
    const compared = await page.evaluate(rowsOf("runs-at-equal-error"));
    assert.deepEqual(compared.map((row) => row[0]), ["isotropic, triangle",
      "isotropic, quadrilateral", "anisotropic, triangle", "anisotropic, quadrilateral"]);
    assert.deepEqual(compared.map((row) => row[1]), [0, 2, 4, 6].map(commonError));
    await pressButton(page, "run", "problem-paper");
    assert.deepEqual(await shown(), of("problem-paper"));
  });
});

test("names that look like markup or script stay text", async () => {
  await withPage(pageOf("hostile"), {}, async (page) => {
    await scrollThrough(page);
    const {title} = historyOf("hostile");
    assert.match(title, /<script>/);
    assert.deepEqual(await page.evaluate("[document.title]"), [title]);
    assert.deepEqual(await page.evaluate(textsOf("h1")), [title]);
    assert.equal(await page.evaluate(countOf("h1 *, main img, main script, main b, main i")), 0);
    assert.deepEqual(await page.evaluate(textsOf("#study pre")),
      [resultText("hostile", "study.toml")]);
    const heads = await page.evaluate(textsOf('[data-name="values"] thead th'));
    assert.ok(heads.includes("<i>alert(4)</i>"), heads.join());
  });
});

test("on paper every section is there in light colours without buttons", async () => {
  await withPage(problemPage, {dark: true}, async (page) => {
    const pages = (await page.pdf()).toString("latin1").match(/\/Type\s*\/Page\b/g) || [];
    assert.ok(pages.length >= 3 && pages.length < 30, `${pages.length} pages`);
    assert.equal(await page.evaluate(countOf(".section-content:empty")), 0);
    assert.equal(await page.evaluate("document.documentElement.dataset.theme"), "dark");
    await page.send("Emulation.setEmulatedMedia", {media: "print"});
    assert.equal(await page.evaluate("getComputedStyle(document.body).backgroundColor"),
      "rgb(255, 255, 255)");
    const seen = await page.evaluate(`[...document.querySelectorAll(".tools, .chooser, .filters")]
      .filter((node) => getComputedStyle(node).display !== "none").length`);
    assert.equal(seen, 0);
  });
});

test("readers without scripts get the results", async () => {
  await withPage(problemPage, {scripts: false}, async (page) => {
    const {root} = await page.send("DOM.getDocument", {depth: -1});
    const {nodeIds} = await page.send("DOM.querySelectorAll",
      {nodeId: root.nodeId, selector: "noscript table"});
    assert.ok(nodeIds.length >= 2);
  });
});

test("the keyboard comes to the results first and shows where it is", async () => {
  await withPage(problemPage, {}, async (page) => {
    await page.key("Tab");
    assert.equal(await page.evaluate("document.activeElement.getAttribute('href')"), "#results");
    await page.key("Tab");
    const outline = await page.evaluate("getComputedStyle(document.activeElement).outlineStyle");
    assert.notEqual(outline, "none");
  });
});

// What tests of the report page share: its results, and what a reader does.

import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {after, before} from "node:test";
import {startBrowser} from "./chromium.mjs";

/** Folder with the results of make_results.cmake, the first argument of a test. */
const results = process.argv[2];

export const resultPath = (...parts) => join(results, ...parts);
export const resultText = (...parts) => readFileSync(resultPath(...parts), "utf8");
export const pageOf = (run) => resultPath(run, "report.html");
export const historyOf = (run) => JSON.parse(resultText(run, "history.json"));

let browser;
before(async () => {
  browser = await startBrowser();
});
after(() => browser.close());

/** Runs `look(page)` on a page; errors of the page fail the test. */
export async function withPage(file, options, look) {
  const page = await browser.open(file, options);
  await page.settle();
  await look(page);
  assert.deepEqual(page.errors, []);
  await page.close();
}

/** Expressions for page.evaluate(). */
export const textsOf = (selector) =>
  `[...document.querySelectorAll(${JSON.stringify(selector)})].map((node) => node.textContent)`;
export const countOf = (selector) =>
  `document.querySelectorAll(${JSON.stringify(selector)}).length`;
export const rowsOf = (name) => `[...document.querySelectorAll('[data-name="${name}"] tbody tr')]
  .map((row) => [...row.cells].map((cell) => cell.textContent))`;

/** The button that saves a chart or a table as CSV or SVG. */
export const saveButton = (name, format) =>
  `[data-name="${name}"] .tools button[title$="as ${format}"]`;

/** Scrolls through the page, so that all sections are built. */
export async function scrollThrough(page) {
  const ids = await page.evaluate(
    "[...document.querySelectorAll('section')].map((section) => section.id)");
  for (const id of ids) {
    await page.evaluate(`document.getElementById("${id}").scrollIntoView()`);
    await page.settle();
  }
  return ids;
}

/** Presses a button of a labelled group. */
export async function pressButton(page, group, label) {
  await page.evaluate(`[...document.querySelectorAll('[aria-label="${group}"] button')]
    .find((button) => button.textContent === ${JSON.stringify(label)}).click()`);
  await page.settle();
}

/** Sets a list or a text field as a reader does. */
export async function enter(page, selector, value) {
  await page.evaluate(`(() => {
    const field = document.querySelector(${JSON.stringify(selector)});
    field.value = ${JSON.stringify(value)};
    for (const type of ["input", "change"]) field.dispatchEvent(new Event(type));
  })()`);
  await page.settle();
}

/** Name of the variant that the page shows. */
export const chosenName = (page) =>
  page.evaluate("document.querySelector('.chooser select').selectedOptions[0].label");

// What the tests of the viewer share: its page alone, in browsers with and without WebGL.

import assert from "node:assert/strict";
import {mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join} from "node:path";
import {after, before} from "node:test";
import {fileURLToPath} from "node:url";
import {startBrowser} from "./chromium.mjs";
import {readMeshFile} from "./mesh_file.mjs";

const results = process.argv[2];
const pageFolder = join(dirname(fileURLToPath(import.meta.url)), "../../../drivers/report/page");
const folder = mkdtempSync(join(tmpdir(), "anisofront-viewer-"));

const browsers = {};
before(async () => {
  browsers.webgl = await startBrowser(["--enable-unsafe-swiftshader"]);
  browsers.canvas = await startBrowser(["--disable-software-rasterizer"]);
});
after(async () => {
  await Promise.all(Object.values(browsers).map((browser) => browser.close()));
  rmSync(folder, {recursive: true});
});

/** The meshes of report.html in a page that holds the viewer alone and shows its functions. */
function viewerPage(run, renderer) {
  const report = readFileSync(join(results, run, "report.html"), "utf8");
  const files = (kind) => readdirSync(pageFolder).filter((name) => name.endsWith(kind)).sort()
    .filter((name) => name !== "page_main.js")
    .map((name) => readFileSync(join(pageFolder, name), "utf8")).join("\n");
  const [data] = report.match(/<script type="application\/json" id="report-data">[^]*?<\/script>/);
  const meshes = report.match(/<script type="application\/octet-stream"[^]*?<\/script>/g);
  const page = join(folder, `${run}-${renderer}.html`);
  writeFileSync(page, `<!DOCTYPE html><html lang="en" data-theme="light"><meta charset="utf-8">
<style>${files(".css")}</style><div id="host"></div>${data}${meshes.join("\n")}
<script>(() => {"use strict";
const {getContext} = HTMLCanvasElement.prototype;
window.cards = [];
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  const context = getContext.call(this, kind, ...more);
  if (kind === "webgl2" && context) cards.push(context);
  return context;
};
${files(".js")}
const {variants} = JSON.parse(document.getElementById("report-data").textContent).runs[0];
const view = createMeshView(document.getElementById("host"),
  {loadMesh, title: "Mesh", renderer: ${JSON.stringify(renderer)}});
Object.assign(window, {view, variants, loadMesh, createMeshView, meshSides, meshGeometry,
  ready: view.show(variants[0])});
})();</script>`);
  const variants = JSON.parse(data.replace(/<.*?>/, "").replace("</script>", "")).runs[0].variants;
  return {page, variants};
}

export const problem = viewerPage("problem");
const pages = {canvas: problem.page, webgl: viewerPage("problem", "webgl").page};
export const fileOf = ({name}, cycle) =>
  readMeshFile(join(results, "problem", name, `cycle-${cycle}.msh`));
export const variant = problem.variants.find(({name}) => /anisotropic-triangle/.test(name));
export const quads = problem.variants.find(({name}) => /anisotropic-quad/.test(name));
export const lastCycle = variant.cycles.at(-1).cycle;

/** Opens the viewer; `kind` of browser "webgl" or "canvas". */
export async function withViewer(kind, look, options = {}) {
  const page = await browsers[kind].open(pages[kind], {width: 1000, height: 800, ...options});
  await page.evaluate("ready");
  await page.evaluate(`view.show(variants[${problem.variants.indexOf(variant)}])`);
  await look(page);
  assert.deepEqual(page.errors, []);
  await page.close();
}

export const state = (page) => page.evaluate("view.state()");
export const setState = (page, part) => page.evaluate(`view.setState(${JSON.stringify(part)})`);

/** A number that changes with the picture. */
export const pictureOf = (page) => page.evaluate(`(() => {
  let hash = 0;
  for (const canvas of document.querySelectorAll(".mesh-area canvas")) {
    for (const c of canvas.toDataURL()) hash = (31 * hash + c.charCodeAt(0)) | 0;
  }
  return hash;
})()`);

/** [red, green, blue] of the drawn mesh at points of the plane. */
export const coloursAt = (page, points) => page.evaluate(`(() => {
  const base = document.querySelector(".mesh-base");
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [base.width, base.height];
  const context = copy.getContext("2d", {willReadFrequently: true});
  context.drawImage(base, 0, 0);
  const {centre, scale} = view.state().view;
  return ${JSON.stringify(points)}.map(([x, y]) => [...context.getImageData(
    Math.floor(copy.width / 2 + (x - centre[0]) * scale),
    Math.floor(copy.height / 2 - (y - centre[1]) * scale), 1, 1).data].slice(0, 3));
})()`);

/** Where a point of the plane is on the screen. */
export async function placeOf(page, [x, y]) {
  const {view: {centre, scale}} = await state(page);
  const middle = await page.middle(".mesh-area");
  return {x: middle.x + (x - centre[0]) * scale, y: middle.y - (y - centre[1]) * scale};
}

export const largest = (values) =>
  values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

/**
 * The inner edge between the most different indicators, from the decoded mesh: {ends, normal (to
 * the left), centres: of the elements on the left and on the right}.
 */
export const steepestEdge = (id) => `loadMesh("${id}").then((mesh) => {
  const {edges, edgeElements} = meshGeometry(mesh);
  const {values} = mesh.fields.find(({name}) => name === "indicator");
  let [best, most] = [-1, 0];
  for (let i = 0; i < mesh.edges; ++i) {
    const [e, f] = [edgeElements[2 * i], edgeElements[2 * i + 1]];
    const ratio = f < 0 ? 0 : Math.abs(Math.log(values[e] / values[f]));
    if (ratio > most) [best, most] = [i, ratio];
  }
  const point = (v) => [mesh.x[v] + mesh.centre[0], mesh.y[v] + mesh.centre[1]];
  const mean = (points) => [0, 1].map((k) =>
    points.reduce((sum, p) => sum + p[k], 0) / points.length);
  const [a, b] = [0, 1].map((k) => point(edges[2 * best + k]));
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const centreOf = (e) => mean([0, 1, 2].map((k) => point(mesh.corners[3 * e + k])));
  return {ends: [a, b], normal: [(a[1] - b[1]) / length, (b[0] - a[0]) / length],
    centres: [0, 1].map((k) => centreOf(edgeElements[2 * best + k]))};
})`;

/** A square of 2 n^2 triangles, as a decoded mesh. */
export const bigSquare = (n) => `(() => {
  const n = ${n}, vertices = (n + 1) ** 2, triangles = 2 * n * n, edges = 3 * n * n + 2 * n;
  const corners = new Int32Array(3 * triangles);
  for (let i = 0; i < n * n; ++i) {
    const a = Math.floor(i / n) * (n + 1) + i % n, d = a + n + 1;
    corners.set([a, a + 1, d + 1, a, d + 1, d], 6 * i);
  }
  const numbers = (f) => Float64Array.from({length: vertices}, (_, v) =>
    f(v % (n + 1) / n, Math.floor(v / (n + 1)) / n));
  const x = numbers((x) => x - 0.5), y = numbers((x, y) => y - 0.5);
  const u = numbers((x, y) => Math.sin(9 * x) * Math.cos(7 * y));
  const none = new Float64Array(0);
  return {vertices, triangles, quads: 0, elements: triangles, edges, corners,
    sides: meshSides(corners, triangles, vertices), centre: [0, 0], x, y, note: "", metric: null,
    quality: null, edgeLengths: new Float64Array(edges).fill(1),
    curves: {vertices: none, tags: none, names: {}}, regions: {tags: null, names: {}},
    fields: [{name: "u", on: "vertex", values: u, isLog: false}]};
})()`;

/** Milliseconds to draw another part of the big mesh, until the last pixel is there. */
export const frameTime = (page) => page.evaluate(`(async () => {
  const start = performance.now();
  await big.setState({view: {centre: [0.03 * Math.random(), 0], scale: 600}});
  const copy = document.createElement("canvas").getContext("2d");
  copy.drawImage(big.element.querySelector(".mesh-base"), 0, 0);
  copy.getImageData(0, 0, 1, 1);
  return performance.now() - start;
})()`);

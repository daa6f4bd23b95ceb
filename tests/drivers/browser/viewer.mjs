// The viewer of meshes in a real browser, with and without WebGL: what it decodes, measures, draws
// and says, against history.json and the .msh files.
//
//   node viewer.mjs RESULTS

import assert from "node:assert/strict";
import {test} from "node:test";
import {middleOf, shortestEdges} from "./mesh_file.mjs";
import {bigSquare, coloursAt, fileOf, frameTime, largest, lastCycle, pictureOf, placeOf, problem,
  quads, setState, state, steepestEdge, variant, withViewer} from "./viewer_page.mjs";

test("each browser draws in its own way", async () => {
  for (const kind of ["webgl", "canvas"]) {
    await withViewer(kind, async (page) => {
      assert.equal((await state(page)).renderer, kind);
      // Without a card a plain canvas is the faster way.
      assert.equal(await page.evaluate(
        'createMeshView(document.body, {loadMesh, title: "Other"}).state().renderer'), "canvas");
    });
  }
});

test("decoded meshes are those of the files", async () => {
  await withViewer("canvas", async (page) => {
    for (const [chosen, cycle] of [[variant, 0], [variant, lastCycle], [quads, lastCycle]]) {
      const file = fileOf(chosen, cycle);
      const mesh = await page.evaluate(`loadMesh(${JSON.stringify(
        chosen.meshes.find((entry) => entry.cycle === cycle).id)}).then((mesh) => ({
        corners: [...mesh.corners], x: [...mesh.x], y: [...mesh.y], centre: mesh.centre,
        fields: mesh.fields.map(({name, on, values}) => ({name, on, values: [...values]}))}))`);
      assert.deepEqual(mesh.corners, file.elements.flat());
      const shortest = shortestEdges(file);
      file.points.forEach(([x, y], v) => {
        const error = Math.hypot(mesh.x[v] + mesh.centre[0] - x, mesh.y[v] + mesh.centre[1] - y);
        assert.ok(error < 1e-3 * shortest[v], `vertex ${v}: ${error}`);
      });
      for (const name of ["u", "indicator"]) {
        const {on, values} = file.fields[name];
        const field = mesh.fields.find((entry) => entry.name === name && entry.on === on);
        const most = largest(values.map(([value]) => value));
        values.forEach(([value], i) => assert.ok(Math.abs(field.values[i] - value) < 1e-3 * most));
      }
    }
  });
});

test("counts, quality and unit band are those of history.json", async () => {
  await withViewer("canvas", async (page) => {
    for (const {name, cycles, meshes} of problem.variants) {
      for (const {cycle, vertices, elements, edges, background} of cycles) {
        const mesh = await page.evaluate(`loadMesh(${JSON.stringify(meshes[cycle].id)})
          .then(({vertices, elements, edges, quality, edgeLengths}) => ({vertices, elements, edges,
            least: Math.min(...quality),
            mean: Math.exp(quality.reduce((sum, q) => sum + Math.log(q), 0) / elements),
            inBand: edgeLengths.filter((l) => l >= Math.SQRT1_2 && l <= Math.SQRT2).length}))`);
        const where = `${name}, cycle ${cycle}`;
        assert.deepEqual([mesh.vertices, mesh.elements, mesh.edges], [vertices, elements, edges],
          where);
        assert.ok(Math.abs(mesh.least - background.quality.min) < 1e-3, where);
        assert.ok(Math.abs(mesh.mean - background.quality.mean) < 1e-3, where);
        assert.ok(Math.abs(100 * mesh.inBand / edges -
          background.edge_length.in_unit_band) < 1e-9, where);
      }
    }
  });
});

test("the last cycle comes first and the numbers are shown", async () => {
  await withViewer("webgl", async (page) => {
    const {cycle, counts} = await state(page);
    assert.equal(cycle, lastCycle);
    const {vertices, edges, background} = variant.cycles.at(-1);
    assert.equal(counts.vertices, vertices);
    const text = await page.evaluate("document.querySelector('.mesh-numbers').textContent");
    assert.ok(text.startsWith(`${vertices} vertices`), text);
    assert.ok(text.includes(`${edges} edges`), text);
    const percent = Math.floor(10 * background.edge_length.in_unit_band + 1e-6) / 10;
    assert.ok(text.includes(`${percent.toFixed(1)}\u00a0% in the unit band`), text);
  });
});

for (const kind of ["webgl", "canvas"]) {
  test(`colours, edges, ellipses and cycles change the picture (${kind})`, async () => {
    await withViewer(kind, async (page) => {
      const pictures = new Map();
      const add = async (what) => {
        const picture = await pictureOf(page);
        assert.ok(!pictures.has(picture), `${what} looks like ${pictures.get(picture)}`);
        pictures.set(picture, what);
      };
      const colours = await page.evaluate(
        "[...document.querySelectorAll('.mesh-options option')].map((option) => option.value)");
      for (const wanted of ["none", "vertex:u", "element:indicator", "quality", "size"]) {
        assert.ok(colours.includes(wanted), `${wanted} in ${colours}`);
      }
      for (const colour of colours) {
        await setState(page, {colour});
        assert.equal((await state(page)).colour, colour);
        await add(colour);
      }
      for (const edges of ["hidden", "length"]) {
        await setState(page, {edges});
        await add(edges);
      }
      await setState(page, {ellipses: true});
      await add("ellipses");
      for (let cycle = 0; cycle < lastCycle; ++cycle) {
        await page.click(`[data-cycle="${cycle}"]`);
        await page.waitFor(`view.state().cycle === ${cycle} && view.state().counts.vertices === ${
          variant.cycles[cycle].vertices}`);
        await add(`cycle ${cycle}`);
      }
    });
  });

  test(`least and largest values have the ends of the colour ramp (${kind})`, async () => {
    const file = fileOf(variant, lastCycle);
    const values = file.fields.indicator.values.map(([value]) => value);
    await withViewer(kind, async (page) => {
      await setState(page, {colour: "element:indicator", edges: "hidden"});
      for (const [value, wanted] of [[Math.min(...values), [0x3f, 0x2a, 0x7b]],
        [Math.max(...values), [0xfe, 0xea, 0x70]]]) {
        const at = middleOf(file, values.indexOf(value));
        await setState(page, {view: {centre: at, scale: 20000}});
        const [colour] = await coloursAt(page, [at]);
        colour.forEach((c, i) => assert.ok(Math.abs(c - wanted[i]) < 8, `${colour}, ${wanted}`));
      }
    });
  });

  test(`the picture is exact at any zoom (${kind})`, async () => {
    await withViewer(kind, async (page) => {
      const {id} = variant.meshes[lastCycle];
      const {ends: [a, b], normal, centres} = await page.evaluate(steepestEdge(id));
      await setState(page, {edges: "hidden", colour: "element:indicator"});
      const wanted = [];
      for (const centre of centres) {
        await setState(page, {view: {centre, scale: 5000}});
        wanted.push(...await coloursAt(page, [centre]));
      }
      assert.ok(largest(wanted[0].map((c, i) => c - wanted[1][i])) > 20);
      for (const scale of [1e4, 1e6, 6e8]) {  // pixels per side of the square
        for (const t of [0.31, 0.37, 0.43, 0.51, 0.57, 0.63, 0.69]) {  // points no float holds
          const centre = a.map((x, i) => x + t * (b[i] - x));
          await setState(page, {view: {centre, scale}});
          const colours = await coloursAt(page, [1, -1].map((side) =>
            centre.map((x, i) => x + 4 * side * normal[i] / scale)));
          colours.forEach((colour, i) => colour.forEach((c, k) =>
            assert.ok(Math.abs(c - wanted[i][k]) < 8, `scale ${scale}: ${colours}, ${wanted}`)));
        }
      }
    });
  });
}

test("WebGL and canvas give the same colours", async () => {
  const file = fileOf(variant, lastCycle);
  const points = file.elements.map((_, e) => middleOf(file, e));
  for (const colour of ["vertex:u", "element:indicator", "quality", "none"]) {
    const colours = {};
    for (const kind of ["webgl", "canvas"]) {
      await withViewer(kind, async (page) => {
        await setState(page, {colour, edges: "hidden"});
        colours[kind] = await coloursAt(page, points);
      });
    }
    const differences = colours.webgl.map((rgb, i) =>
      largest(rgb.map((c, k) => c - colours.canvas[i][k])) / 255);
    differences.sort((a, b) => a - b);
    const mean = differences.reduce((sum, d) => sum + d, 0) / differences.length;
    assert.ok(mean < 0.02, `${colour}: mean difference ${mean}`);
    const most = differences[Math.floor(0.97 * differences.length)];  // thin elements: rims
    assert.ok(most < 0.06, `${colour}: ${most}`);
  }
});

test("the tooltip tells of the element under the pointer", async () => {
  const file = fileOf(variant, lastCycle);
  const element = 20;
  await withViewer("canvas", async (page) => {
    const at = middleOf(file, element);
    await setState(page, {colour: "vertex:u", view: {centre: [at[0] + 1e-3, at[1]], scale: 5000}});
    await page.hover(await placeOf(page, at));
    const lines = await page.evaluate(
      "[...document.querySelectorAll('.mesh-hover > *')].map((line) => line.textContent)");
    assert.equal(lines[0], `Triangle ${element + 1}`);
    const u = file.elements[element].reduce((sum, v) => sum + file.fields.u.values[v][0], 0) / 3;
    const shown = Number(lines[1].replace("u ", "").replace("−", "-"));
    assert.ok(Math.abs(shown - u) < 1e-3, `${shown}, ${u}`);
    await page.hover({x: 3, y: 3});
    assert.ok(await page.evaluate("document.querySelector('.mesh-hover').hidden"));
  });
});

test("a click and the Enter key inspect an element", async () => {
  const file = fileOf(variant, lastCycle);
  const element = file.elements.length - 1;
  const at = middleOf(file, element);
  const rows = () => `Object.fromEntries([...document.querySelectorAll('.mesh-panel dl div')]
    .map((row) => [...row.children].map((cell) => cell.textContent)))`;
  await withViewer("webgl", async (page) => {
    await setState(page, {view: {centre: at, scale: 4000}});
    await page.press(await placeOf(page, at));
    await page.settle();
    const {inspected} = await state(page);
    assert.equal(inspected.element, element);
    assert.deepEqual(inspected.vertices, file.elements[element]);
    const panel = await page.evaluate(rows());
    assert.equal(panel.vertices, file.elements[element].map((v) => v + 1).join(", "));
    assert.equal(panel.region, "square");
    const indicator = file.fields.indicator.values[element][0];
    const entry = inspected.values.find(({label}) => label === "error indicator");
    assert.ok(Math.abs(entry.value - indicator) < 1e-3 * indicator);
    assert.equal(panel["edge lengths"].split(", ").length, 3);
    await page.evaluate("document.querySelector('.mesh-area').focus()");
    await page.key("Escape");
    assert.equal((await state(page)).inspected, null);
    await page.key("Enter");
    assert.equal((await state(page)).inspected.element, element);
    assert.match(await page.evaluate("document.querySelector('.mesh-live').textContent"),
      new RegExp(`^Triangle ${element + 1}: point .*vertices`));
  });
});

test("lengths, sizes and direction of the metric belong to the element", async () => {
  const file = fileOf(variant, lastCycle);
  await withViewer("canvas", async (page) => {
    for (const element of [3, 33]) {
      const [x, y] = middleOf(file, element);
      await setState(page, {inspected: {x, y}});
      const {inspected: {edges, metric, vertices}} = await state(page);
      const [c, s] = [Math.cos(metric.angle), Math.sin(metric.angle)];
      edges.forEach((length, k) => {
        const [p, q] = [vertices[k], vertices[(k + 1) % 3]].map((v) => file.points[v]);
        const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
        const here = Math.hypot((c * dx + s * dy) / metric.h2, (c * dy - s * dx) / metric.h1);
        assert.ok(length > 0.6 * here && length < 1.6 * here, `${length}, ${here}`);
      });
    }
  });
});

test("wheel, drag, double click and box move the view", async () => {
  await withViewer("webgl", async (page) => {
    const start = await state(page);
    const at = await placeOf(page, [0.3, 0.6]);
    await page.mouse("mouseWheel", at, {deltaX: 0, deltaY: -300});
    await page.settle();
    const zoomed = await state(page);
    assert.ok(zoomed.view.scale > 1.3 * start.view.scale);
    const after = await placeOf(page, [0.3, 0.6]);
    assert.ok(Math.hypot(after.x - at.x, after.y - at.y) < 0.5);
    await page.drag(at, {x: at.x + 60, y: at.y - 30});
    const moved = await placeOf(page, [0.3, 0.6]);
    assert.ok(Math.hypot(moved.x - at.x - 60, moved.y - at.y + 30) < 0.5);
    assert.equal((await state(page)).inspected, null);
    for (const clickCount of [1, 2]) {
      const button = {button: "left", clickCount};
      await page.mouse("mousePressed", moved, {...button, buttons: 1});
      await page.mouse("mouseReleased", moved, {...button, buttons: 0});
    }
    await page.settle();
    const doubled = await state(page);
    assert.ok(Math.abs(doubled.view.scale / zoomed.view.scale - 2) < 1e-9);
    assert.equal(doubled.inspected, null);
    await page.click('[aria-label^="Show all"]');
    assert.deepEqual((await state(page)).view, start.view);
    const [from, to] = [await placeOf(page, [0.2, 0.2]), await placeOf(page, [0.4, 0.3])];
    const held = {button: "left", buttons: 1, modifiers: 8};  // Shift
    await page.mouse("mousePressed", from, {...held, clickCount: 1});
    await page.mouse("mouseMoved", to, held);
    await page.mouse("mouseReleased", to, {...held, buttons: 0});
    await page.settle();
    const {centre, scale} = (await state(page)).view;
    assert.ok(Math.hypot(centre[0] - 0.3, centre[1] - 0.25) < 0.01, String(centre));
    assert.ok(scale > 3 * start.view.scale);
  });
});

test("the pointer names the curve it is on", async () => {
  await withViewer("canvas", async (page) => {
    for (const [name, at] of [["bottom", [0.4, 0]], ["right", [1, 0.6]]]) {
      await page.hover(await placeOf(page, at));
      assert.equal(
        await page.evaluate("document.querySelector('.mesh-hover strong').textContent"), name);
    }
  });
});

test("the cycles are played", async () => {
  await withViewer("canvas", async (page) => {
    const seen = [];
    await page.click('[aria-label="Play the cycles"]');
    for (const {cycle} of variant.cycles) {
      await page.waitFor(`view.state().cycle === ${cycle}`, 5000);
      seen.push(cycle);
    }
    assert.equal(seen.length, variant.cycles.length);
    await page.waitFor("document.querySelector('[aria-label=\"Play the cycles\"]') !== null");
    assert.equal((await state(page)).cycle, lastCycle);
  });
});

test("two fingers zoom and one moves", async () => {
  await withViewer("canvas", async (page) => {
    const {view} = await state(page);
    const {x, y} = await page.middle(".mesh-area");
    const touch = (type, ...points) => page.send("Input.dispatchTouchEvent",
      {type, touchPoints: points.map(([dx, dy], id) => ({x: x + dx, y: y + dy, id}))});
    await touch("touchStart", [-50, 0], [50, 0]);
    await touch("touchMove", [-75, 0], [75, 0]);
    await touch("touchMove", [-100, 0], [100, 0]);
    await touch("touchEnd");
    await page.settle();
    const zoomed = await state(page);
    assert.ok(Math.abs(zoomed.view.scale / view.scale - 2) < 0.05, `${zoomed.view.scale}`);
    await touch("touchStart", [0, 0]);
    await touch("touchMove", [20, 10]);
    await touch("touchMove", [40, 20]);
    await touch("touchEnd");
    await page.settle();
    const {centre, scale} = (await state(page)).view;
    assert.ok(Math.abs((zoomed.view.centre[0] - centre[0]) * scale - 40) < 4);
  });
});

test("the keyboard reaches everything", async () => {
  await withViewer("canvas", async (page) => {
    await page.evaluate("document.querySelector('.mesh-area').focus()");
    const {view} = await state(page);
    await page.key("+");
    assert.ok((await state(page)).view.scale > view.scale);
    await page.key("ArrowRight");
    assert.ok((await state(page)).view.centre[0] > view.centre[0]);
    await page.key("0");
    assert.deepEqual((await state(page)).view, view);
    await page.key("[");
    await page.waitFor(`view.state().cycle === ${lastCycle - 1}`);
    await page.key(".");
    await page.waitFor(`view.state().cycle === ${lastCycle}`);
    await page.key("e");
    assert.equal((await state(page)).edges, "length");
    await page.key("m");
    assert.equal((await state(page)).ellipses, true);
    const {colour} = await state(page);
    await page.key("c");
    assert.notEqual((await state(page)).colour, colour);
  });
});

test("the view stays while cycles are stepped through", async () => {
  await withViewer("webgl", async (page) => {
    const view = {centre: [0.4, 0.3], scale: 3000};
    await setState(page, {view, colour: "vertex:u"});
    for (const {cycle} of variant.cycles) {
      await setState(page, {cycle});
      const now = await state(page);
      assert.deepEqual([now.view, now.colour, now.cycle], [view, "vertex:u", cycle]);
    }
  });
});

test("one range serves all cycles when asked for", async () => {
  await withViewer("canvas", async (page) => {
    const ranges = [];
    for (const {cycle} of variant.cycles) {
      await setState(page, {cycle, colour: "element:indicator", sameRange: false});
      ranges.push((await state(page)).range);
    }
    assert.notDeepEqual(ranges[0], ranges.at(-1));
    for (const {cycle} of variant.cycles) {
      await setState(page, {cycle, sameRange: true});
      assert.deepEqual((await state(page)).range, [Math.min(...ranges.map(([least]) => least)),
        Math.max(...ranges.map(([, most]) => most))]);
    }
  });
});

test("a state can be put back and changes by the reader are told", async () => {
  await withViewer("canvas", async (page) => {
    await setState(page, {cycle: 1, colour: "quality", edges: "length", ellipses: true,
      view: {centre: [0.2, 0.7], scale: 900}, inspected: {x: 0.21, y: 0.71}});
    const before = await state(page);
    assert.ok(before.inspected);
    await setState(page, {cycle: 0, colour: "none", edges: "plain", ellipses: false,
      view: {centre: [0.5, 0.5], scale: 400}, inspected: null});
    await page.evaluate("window.told = 0, view.onChange(() => ++told)");
    await setState(page, before);
    assert.deepEqual(await state(page), before);
    assert.equal(await page.evaluate("told"), 0);
    await page.click('[data-value="hidden"]');
    assert.equal(await page.evaluate("told"), 1);
  });
});

test("a missing or damaged mesh leaves a note", async () => {
  await withViewer("webgl", async (page) => {
    const note = "document.querySelector('.mesh-note').textContent";
    await page.evaluate(
      `view.show({name: "gone", meshes: [{cycle: 0, id: null, note: "not there"}]})`);
    assert.equal(await page.evaluate(note), "not there");
    assert.equal((await state(page)).counts, null);
    await page.evaluate(`(() => {
      const damaged = document.createElement("script");
      damaged.type = "application/octet-stream";
      damaged.id = "damaged";
      damaged.textContent = btoa("no mesh");
      document.body.append(damaged);
      return view.show({name: "bad", meshes: [{cycle: 0, id: "damaged"}]});
    })()`);
    assert.match(await page.evaluate(note), /cannot be read/);
    await page.evaluate("view.show(variants[0])");
    assert.equal(await page.evaluate(note), "");
  });
});

test("the picture follows the theme, the window and the loss of the card", async () => {
  await withViewer("webgl", async (page) => {
    const corner = [[-0.02, -0.02]];
    assert.deepEqual(await coloursAt(page, corner), [[255, 255, 255]]);
    await page.evaluate(`document.documentElement.dataset.theme = "dark",
      document.dispatchEvent(new Event("themechange")), 0`);
    const [dark] = await coloursAt(page, corner);
    assert.ok(largest(dark) < 80, String(dark));
    await page.resize(500, 700);
    const width = "document.querySelector('.mesh-base').width";
    await page.waitFor(`${width} < 500 && ${width} > 300`);
    await page.evaluate("cards.at(-1).getExtension('WEBGL_lose_context').loseContext()");
    await page.waitFor("view.state().renderer === 'canvas'");
    const [middle] = await coloursAt(page, [[0.513, 0.487]]);
    assert.notDeepEqual(middle, dark);
  });
});

test("the picture is saved as a PNG file", async () => {
  await withViewer("canvas", async (page) => {
    const {name, text} = await page.download(() => page.click('[aria-label^="Save picture"]'));
    assert.equal(name, `${variant.name}-cycle-${lastCycle}.png`);
    assert.equal(text.slice(1, 4), "PNG");
    assert.ok(text.length > 5000);
  });
});

test("every control has a name", async () => {
  await withViewer("canvas", async (page) => {
    const nameless = await page.evaluate(`[...document.querySelectorAll(
      ".mesh-view button, .mesh-view select, .mesh-view input")].filter((control) =>
        !control.textContent.trim() && !control.getAttribute("aria-label") &&
        !control.closest("label")).length`);
    assert.equal(nameless, 0);
  });
});

test("a hundred thousand elements are shown", async () => {
  for (const kind of ["webgl", "canvas"]) {
    await withViewer(kind, async (page) => {
      const first = await page.evaluate(`(async () => {
        const mesh = ${bigSquare(224)};
        const start = performance.now();
        window.big = createMeshView(document.body,
          {loadMesh: async () => mesh, title: "Big", renderer: "${kind}"});
        await big.show({name: "big", meshes: [{cycle: 0, id: "big"}]});
        return performance.now() - start;
      })()`);
      assert.equal(await page.evaluate("big.state().counts.elements"), 100352);
      const frames = [];
      for (const [colour, edges] of [["vertex:u", "plain"], ["none", "length"]]) {
        await page.evaluate(`big.setState(${JSON.stringify({colour, edges})})`);
        frames.push(`${colour} and edges ${edges} ${Math.round(await frameTime(page))} ms`);
      }
      console.log(`${kind} by the processor, 100352 triangles: first view ` +
        `${Math.round(first)} ms; frame with ${frames.join(", ")}`);
    });
  }
});

// A headless Chromium that tests look into, by the DevTools protocol over a pipe. For Node 18.
//
//   const browser = await startBrowser();
//   const page = await browser.open("report.html", {width: 1200, height: 900});
//   await page.click("button.small");
//   await browser.close();

import {spawn} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";

const kTimeout = 30000;

/** The program: $CHROMIUM, or what Debian calls it. */
const kProgram = process.env.CHROMIUM || "chromium";

export async function startBrowser(more = []) {
  const folder = mkdtempSync(join(tmpdir(), "anisofront-browser-"));
  const process_ = spawn(kProgram, ["--headless=new", "--no-sandbox", "--disable-gpu",
    "--hide-scrollbars", "--remote-debugging-pipe", "--no-first-run", "--disable-extensions",
    "--disable-background-networking", "--disable-dev-shm-usage", `--user-data-dir=${folder}`, ...more,
    "about:blank"],
  {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
  const connection = connect(process_);
  const close = async () => {
    connection.isClosing = true;
    const gone = new Promise((done) => process_.once("exit", done));
    connection.send("Browser.close").catch(() => process_.kill("SIGKILL"));
    const timer = setTimeout(() => process_.kill("SIGKILL"), 5000);
    await gone;
    clearTimeout(timer);
    rmSync(folder, {recursive: true, force: true, maxRetries: 5, retryDelay: 200});
  };
  const open = (file, options) => openPage(connection, folder, file, options);
  return {open, close};
}

/** Messages are JSON texts that end in a NUL: ours to descriptor 3, the browser's from 4. */
function connect(process_) {
  const connection = {count: 0, pending: new Map(), listeners: [], isClosing: false};
  const [toBrowser, fromBrowser] = [process_.stdio[3], process_.stdio[4]];
  connection.send = (method, params = {}, sessionId) => new Promise((done, fail) => {
    const id = ++connection.count;
    const timer = setTimeout(() => {
      connection.pending.delete(id);
      fail(new Error(`${method}: no answer within ${kTimeout / 1000} s`));
    }, kTimeout);
    connection.pending.set(id, {done, fail, timer});
    toBrowser.write(JSON.stringify({id, method, params, sessionId}) + "\0");
  });
  let chunks = [];
  fromBrowser.on("data", (chunk) => {
    chunks.push(chunk);
    if (!chunk.includes(0)) return;
    const messages = Buffer.concat(chunks).toString().split("\0");
    chunks = [Buffer.from(messages.pop())];
    for (const message of messages) receive(connection, JSON.parse(message));
  });
  const fail = (reason) => {
    for (const {fail: reject, timer} of connection.pending.values()) {
      clearTimeout(timer);
      reject(new Error(reason));
    }
    connection.pending.clear();
  };
  toBrowser.on("error", () => {});
  process_.on("error", (error) => fail(`${kProgram} does not start: ${error.message}`));
  process_.on("exit", (code) => fail(`${kProgram} ended with ${code}`));
  return connection;
}

function receive(connection, message) {
  if (message.id === undefined) {
    for (const listener of connection.listeners) listener(message);
    return;
  }
  const call = connection.pending.get(message.id);
  if (!call) return;
  connection.pending.delete(message.id);
  clearTimeout(call.timer);
  if (message.error) call.fail(new Error(message.error.message));
  else call.done(message.result);
}

/** Opens a file and waits until it has loaded and settled. */
async function openPage(connection, folder, file, options = {}) {
  const {width = 1280, height = 900, dark = false, scripts = true} = options;
  const {targetId} = await connection.send("Target.createTarget", {url: "about:blank"});
  const {sessionId} = await connection.send("Target.attachToTarget", {targetId, flatten: true});
  const send = (method, params) => connection.send(method, params, sessionId);
  const page = {send, scripts, errors: [], downloads: join(folder, `downloads-${targetId}`)};
  const waiting = collectEvents(connection, sessionId, page);
  for (const domain of ["Page", "Runtime", "Log", "Network"]) await send(`${domain}.enable`);
  await send("Emulation.setDeviceMetricsOverride",
    {width, height, deviceScaleFactor: 1, mobile: false});
  await send("Emulation.setEmulatedMedia", {features: [
    {name: "prefers-color-scheme", value: dark ? "dark" : "light"},
    {name: "prefers-reduced-motion", value: "reduce"}]});
  if (!scripts) await send("Emulation.setScriptExecutionDisabled", {value: true});
  await connection.send("Browser.setDownloadBehavior",
    {behavior: "allow", downloadPath: page.downloads, eventsEnabled: true});
  const loaded = waiting("Page.loadEventFired");
  await send("Page.navigate", {url: pathToFileURL(resolve(file)).href});
  await loaded;
  return Object.assign(page, pageActions(connection, send, page, waiting, targetId));
}

/**
 * Errors of the page go to page.errors; returns waiting(method, accepts?), the next event of that
 * kind.
 */
function collectEvents(connection, sessionId, page) {
  const waiters = [];
  const place = (entry) => `${entry.url || ""}:${(entry.lineNumber ?? -1) + 1}`;
  connection.listeners.push(({method, params, sessionId: from}) => {
    for (const waiter of waiters.filter((w) => w.method === method && w.accepts(params))) {
      waiters.splice(waiters.indexOf(waiter), 1);
      waiter.done(params);
    }
    if (from !== sessionId) return;
    if (method === "Runtime.exceptionThrown") {
      const {exceptionDetails: details} = params;
      page.errors.push(`${details.exception?.description || details.text} (${place(details)})`);
    }
    if (method === "Runtime.consoleAPICalled" && ["error", "assert"].includes(params.type)) {
      page.errors.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
    }
    if (method === "Log.entryAdded" && params.entry.level === "error") {
      page.errors.push(`${params.entry.text} (${place(params.entry)})`);
    }
    if (method === "Network.requestWillBeSent" && /^(https?|wss?|ftp):/.test(params.request.url)) {
      page.errors.push(`the page asks the network for ${params.request.url}`);
    }
  });
  return (method, accepts = () => true) => new Promise((done, fail) => {
    const timer = setTimeout(() => fail(new Error(`no ${method} within ${kTimeout / 1000} s`)),
      kTimeout);
    waiters.push({method, accepts, done: (params) => {
      clearTimeout(timer);
      done(params);
    }});
  });
}

/** What tests do with a page. */
function pageActions(connection, send, page, waiting, targetId) {
  const looks = lookActions(send, page);
  return {
    ...looks, ...handActions(send, looks), ...fileActions(send, page, waiting),
    resize: async (width, height) => {
      await send("Emulation.setDeviceMetricsOverride",
        {width, height, deviceScaleFactor: 1, mobile: false});
      await looks.settle();
    },
    close: () => connection.send("Target.closeTarget", {targetId}),
  };
}

/** Looking: evaluate(expression), waitFor(expression), settle(), middle(selector). */
function lookActions(send, page) {
  const evaluate = async (expression) => {
    const answer = await send("Runtime.evaluate",
      {expression, awaitPromise: true, returnByValue: true, userGesture: true});
    if (!answer.exceptionDetails) return answer.result.value;
    const {exception, text} = answer.exceptionDetails;
    throw new Error(`${exception?.description || text}\nin ${expression}`);
  };
  /** Two frames: layout and observers have run. */
  const settle = () => page.scripts && evaluate(
    "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))");
  const waitFor = async (expression, milliseconds = 15000) => {
    for (const end = Date.now() + milliseconds; Date.now() < end;) {
      const value = await evaluate(expression);
      if (value) return value;
      await new Promise((done) => setTimeout(done, 30));
    }
    throw new Error(`never true: ${expression}`);
  };
  /** Scrolls an element into view; returns the place of its middle. */
  const middle = async (selector) => {
    const place = await evaluate(`(() => {
      const node = document.querySelector(${JSON.stringify(selector)});
      if (!node) return null;
      node.scrollIntoView({block: "center", behavior: "instant"});
      const box = node.getBoundingClientRect();
      return {x: box.x + box.width / 2, y: box.y + box.height / 2};
    })()`);
    if (!place) throw new Error(`no element ${selector}`);
    return place;
  };
  return {evaluate, settle, waitFor, middle};
}

/** Mouse and keys: click(selector), press, drag, hover(place), mouse(type, place), key(name). */
function handActions(send, {settle, middle}) {
  const mouse = (type, {x, y}, more = {}) =>
    send("Input.dispatchMouseEvent", {type, x, y, ...more});
  const down = {button: "left", buttons: 1, clickCount: 1};
  const up = {...down, buttons: 0};
  const press = async (place) => {
    await mouse("mousePressed", place, down);
    await mouse("mouseReleased", place, up);
    await settle();
  };
  const click = async (selector) => press(await middle(selector));
  const drag = async (from, to) => {
    await mouse("mousePressed", from, down);
    for (const part of [0.3, 0.6, 1]) {
      const at = {x: from.x + part * (to.x - from.x), y: from.y + part * (to.y - from.y)};
      await mouse("mouseMoved", at, {button: "left", buttons: 1});
    }
    await mouse("mouseReleased", to, up);
    await settle();
  };
  const hover = async (place) => {
    await mouse("mouseMoved", place);
    await settle();
  };
  const key = async (name, more = {}) => {
    const event = {key: name, code: name, windowsVirtualKeyCode: kKeyCodes[name] || 0,
      text: name === "Enter" ? "\r" : undefined, ...more};
    await send("Input.dispatchKeyEvent", {type: "keyDown", ...event});
    await send("Input.dispatchKeyEvent", {type: "keyUp", ...event});
    await settle();
  };
  return {mouse, press, click, drag, hover, key};
}

/** Files: screenshot(file, {whole}), download(action), pdf(). */
function fileActions(send, page, waiting) {
  const screenshot = async (file, {whole = false} = {}) => {
    const {cssContentSize} = await send("Page.getLayoutMetrics");
    const clip = whole ? {...cssContentSize, scale: 1} : undefined;
    const {data} = await send("Page.captureScreenshot",
      {format: "png", clip, captureBeyondViewport: whole});
    writeFileSync(file, Buffer.from(data, "base64"));
  };
  /** Name and text of the file that `action` downloads. */
  const download = async (action) => {
    const begun = waiting("Browser.downloadWillBegin");
    const ended = waiting("Browser.downloadProgress", ({state}) => state !== "inProgress");
    await action();
    const {suggestedFilename: name} = await begun;
    await ended;
    const file = join(page.downloads, name);
    const text = readFileSync(file, "utf8");
    rmSync(file);
    return {name, text};
  };
  const pdf = async () => Buffer.from((await send("Page.printToPDF",
    {printBackground: true, preferCSSPageSize: true})).data, "base64");
  return {screenshot, download, pdf};
}

const kKeyCodes = {Tab: 9, Enter: 13, Escape: 27, " ": 32, ArrowLeft: 37, ArrowUp: 38,
  ArrowRight: 39, ArrowDown: 40};

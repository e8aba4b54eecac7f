// SPDX-License-Identifier: Apache-2.0
// A newcomer's way through the Studio in Debian's chromium: gallery, run, other friction, overlay, sweep, fit, exports,
// dark and phone-wide pictures. Console errors, failing requests and overlapping labels are failures.
//
// Usage: node browser.mjs PROGRAM PACKAGES PICTURES
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";

const [program, packages, pictures] = process.argv.slice(2).map((one) => path.resolve(one));
const puppeteer = createRequire(path.join(packages, "package.json"))("puppeteer-core");
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "ionskin-studio-"));
const workspace = path.join(folder, "work <b>space");
const downloads = path.join(folder, "downloads");
fs.mkdirSync(workspace);
fs.mkdirSync(downloads);
fs.mkdirSync(pictures, { recursive: true });
// A record that came with the folder.
const brought = path.join(workspace, ".studio", "jobs", "1");
fs.mkdirSync(brought, { recursive: true });
fs.writeFileSync(path.join(brought, "job.json"), JSON.stringify({ words: ["run", "<i>brought.toml", "-o", "brought", "--no-report"], state: "queued" }));
const times = {};

// Starts the server with a browser that only says which page it was given.
async function start_server() {
  const browser = path.join(folder, "browser");
  const word = path.join(folder, "word");
  fs.rmSync(word, { force: true });
  fs.writeFileSync(browser, `#!/bin/sh\nprintf '%s' "$1" > '${word}.part' && mv '${word}.part' '${word}'\n`, { mode: 0o700 });
  const begun = performance.now();
  const server = spawn(program, ["studio", workspace], { env: { ...process.env, BROWSER: browser, XDG_STATE_HOME: path.join(folder, "state") } });
  await new Promise((resolve, reject) => {
    server.stdout.once("data", resolve);
    server.once("exit", () => reject(new Error("the server ended")));
  });
  times["start of the server"] = performance.now() - begun;
  while (!fs.existsSync(word)) await new Promise((resolve) => setTimeout(resolve, 20));
  return [server, `file://${fs.readFileSync(word, "utf8")}`];
}

const problems = [];
function listen(page) {
  page.on("console", (message) => { if (["error", "warn"].includes(message.type()) && !/GPU stall|GL Driver Message/.test(message.text())) problems.push(`console: ${message.text()}`); });
  page.on("pageerror", (error) => problems.push(`page: ${error.message}`));
  page.on("requestfailed", (request) => { if (!request.url().endsWith("/api/events")) problems.push(`request: ${request.url()} ${request.failure()?.errorText}`); });
  page.on("response", (response) => { if (response.status() >= 400) problems.push(`request: ${response.status()} ${response.url()}`); });
}

// Runs in the page: texts that lie over one another, and what is wider than the window.
function layout_problems() {
  const found = [];
  const seen = [...document.querySelectorAll("label, button, h1, h2, summary, a, .hint, output, .u-legend th")].filter((one) => {
    const box = one.getBoundingClientRect();
    return box.width > 1 && box.height > 1 && !one.closest(".skip, .time-bar, header, #status, .results, .editor") && one.checkVisibility();
  });
  const boxes = seen.map((one) => [one, one.getBoundingClientRect()]);
  for (let i = 0; i < boxes.length; ++i) {
    for (let j = i + 1; j < boxes.length; ++j) {
      const [a, p] = boxes[i], [b, q] = boxes[j];
      if (a.contains(b) || b.contains(a)) continue;
      if (Math.min(p.right, q.right) - Math.max(p.left, q.left) > 2 && Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) > 2) {
        found.push(`overlap: "${a.textContent.slice(0, 40)}" and "${b.textContent.slice(0, 40)}"`);
      }
    }
  }
  if (document.documentElement.scrollWidth > window.innerWidth + 1) found.push(`the page is ${document.documentElement.scrollWidth} wide in a window of ${window.innerWidth}`);
  for (const control of document.querySelectorAll("input, select, textarea, button, progress")) {
    const named = control.textContent.trim() || control.ariaLabel || control.labels?.[0]?.textContent.trim();
    if (!named && control.checkVisibility()) found.push(`no label: ${control.outerHTML.slice(0, 80)}`);
  }
  return found;
}

const main = async (page, link) => {
  const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
  // A call that the browser never answers, as when the page is drawn anew beneath it, is asked again.
  const wait = async (what, ...rest) => {
    let last = null;
    for (const end = Date.now() + 240000; Date.now() < end; await pause(50)) {
      const asked = (async () => {
        const handle = await page.evaluateHandle(what, ...rest);
        return (await handle.evaluate((value) => Boolean(value))) ? handle : null;
      })();
      const handle = await Promise.race([asked.catch((error) => { last = error; return null; }), pause(20000)]);
      if (handle) return handle;
    }
    throw last ?? new Error(`never came true: ${what}`);
  };
  const click = async (text, within = "body") => {
    for (let left = 5; left > 0; --left) {
      const handle = await wait((wanted, scope) => [...document.querySelectorAll(`${scope} button, ${scope} a, ${scope} summary`)].find((one) => one.textContent.trim() === wanted && one.checkVisibility() && !one.disabled), text, within);
      try {
        return await handle.click();
      } catch (error) { // the page was drawn anew between finding and clicking
        if (left === 1 || !/detached/.test(error.message)) throw error;
      }
    }
  };
  const picture = async (name) => {
    for (const width of [1300, 390]) {
      await page.setViewport({ width, height: width === 1300 ? 900 : 844 });
      await page.evaluate(() => window.scrollTo(0, 0));
      await new Promise((resolve) => setTimeout(resolve, 400));
      // A busy machine takes longer to lay the page out anew.
      const problems_here = () => page.evaluate(layout_problems);
      for (let tries = 0; tries < 20 && (await problems_here()).length > 0; ++tries) await new Promise((resolve) => setTimeout(resolve, 500));
      problems.push(...(await problems_here()).map((one) => `${name} ${width}: ${one}`));
      await page.screenshot({ path: path.join(pictures, `${name}-${width}.png`), fullPage: true });
    }
    await page.setViewport({ width: 1300, height: 900 });
  };
  const fill = async (label, value) => {
    const control = await wait((wanted) => [...document.querySelectorAll("label")].find((one) => one.textContent === wanted && one.checkVisibility())?.control, label);
    await control.evaluate((one, text) => { one.value = text; one.dispatchEvent(new Event("input", { bubbles: true })); one.dispatchEvent(new Event("change", { bubbles: true })); }, value);
  };
  const field = (key, value) => page.$eval(`[data-key="${key}"]`, (one, text) => { one.value = text; one.dispatchEvent(new Event("change", { bubbles: true })); }, value);
  const shown = (paths) => wait((list) => list.every((one) => document.querySelector(".plot .u-legend, .plot")?.textContent.includes(one)), paths);

  // Start page.
  let begun = performance.now();
  await page.goto(link);
  await wait(() => document.querySelectorAll(".card .picture").length === document.querySelectorAll(".card").length && document.querySelector(".card"));
  times["link to gallery"] = performance.now() - begun;
  await picture("start");

  // The first case; a mistake, at the line and at the field.
  await click("Open", ".card");
  await wait(() => document.querySelector(".verdict.good"));
  // Keys of other friction laws have no field.
  assert.equal(await page.$('[data-key="contact.kinetic_friction"]'), null);
  assert.ok(await page.$('[data-key="slider.youngs_modulus"]'));
  begun = performance.now();
  await field("contact.friction", "9");
  await wait(() => document.querySelector('[data-key="contact.friction"][aria-invalid="true"]') && document.querySelector(".gutter .bad"));
  times["case edit to verdict"] = performance.now() - begun;
  assert.match(await page.$eval(".problems", (one) => one.textContent), /out of range/);
  await picture("mistake");
  await field("contact.friction", "0.3");
  // Names are checked as they are typed.
  await fill("Name of the results", "../up");
  assert.match(await page.$eval(".actions .field-problem", (one) => one.textContent), /letters, digits/);
  assert.ok(await page.$eval("#run-button", (one) => one.disabled));
  await fill("Name of the results", "first");
  // Another shape offers the keys that it needs, and takes away those of the one before.
  await wait(() => document.querySelector(".verdict.good"));
  await field("slider.shape", "sphere");
  await wait(() => document.querySelector('[data-key="slider.radius"]'));
  await field("slider.radius", "2 mm");
  await wait(() => document.querySelector(".verdict.good") && document.querySelector(".sketch circle"));
  await field("slider.shape", "flat");
  await wait(() => !document.querySelector('[data-key="slider.radius"]') && document.querySelector(".verdict.good"));
  const edited = await page.$eval("textarea", (one) => one.value);
  assert.doesNotMatch(edited, /^radius/m);
  assert.match(edited, /^edge_radius = "0.2 mm"/m); // which the sphere had taken away
  // A path begins as the motion before; its points are dragged on a plan; the motion comes back.
  await field("motion.kind", "waypoints");
  await wait(() => document.querySelectorAll(".waypoints tbody tr").length === 4 && document.querySelector(".verdict.good"));
  assert.equal(await page.$('[data-key="motion.stroke"]'), null);
  await page.$eval(".plan", (one) => one.scrollIntoView({ block: "center" }));
  const point = await (await page.$$(".p-point"))[3].boundingBox();
  const [x, y] = [point.x + point.width / 2, point.y + point.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y, { steps: 4 });
  await page.mouse.up();
  await wait(() => [2, 3].every((i) => /^\[[5-9](\.\d+)? mm, [\d.]+ mm\]$/.test(document.querySelector(`[data-key="motion.waypoints[${i}].position"]`)?.value)) && document.querySelector(".verdict.good"));
  await picture("waypoints");
  await click("Add a waypoint");
  await wait(() => document.querySelectorAll(".waypoints tbody tr").length === 5 && document.querySelector(".verdict.good"));
  await field("motion.kind", "touch-slide-lift");
  await wait(() => document.querySelector('[data-key="motion.stroke"]')?.value === "6 mm" && document.querySelector(".verdict.good"));
  // Layers and taxels are rows; a mistake is shown at its cell, and rows stand beside it.
  const good = () => wait(() => document.querySelector(".verdict.good"));
  const rows = (list) => page.$$eval(`[data-key^="${list}["][data-key$="].name"]`, (all) => all.length);
  const name_of = (i) => page.$eval(`[data-key="skin.layers[${i}].name"]`, (one) => one.value);
  const press = (label) => page.$eval(`button[aria-label="${label}"]`, (one) => one.click());
  await click("Skin", ".form");
  assert.equal(await rows("skin.layers"), 3);
  const thickness = await page.$eval('[data-key="skin.layers[0].thickness"]', (one) => one.value);
  await field("skin.layers[0].thickness", "3 kg");
  await wait(() => document.querySelector('[data-key="skin.layers[0].thickness"][aria-invalid="true"]')?.closest("td").textContent.includes("kg"));
  await field("skin.layers[0].thickness", thickness);
  await good();
  await click("Add a layer");
  await wait(() => document.querySelector('[data-key="skin.layers[3].name"]') && document.querySelector(".verdict.good"));
  assert.equal(await name_of(3), "layer 4");
  await press("Move layer 4 down by one");
  await wait(() => document.querySelector('[data-key="skin.layers[2].name"]')?.value === "layer 4" && document.querySelector(".verdict.good"));
  await press("Remove layer 2"); // the core
  await wait(() => document.querySelector(".verdict.bad") && !document.querySelector('[data-key="skin.layers[3].name"]'));
  assert.equal(await rows("skin.layers"), 3);
  await field("skin.layers[1].role", "core");
  await field("skin.layers[1].material", "nafion");
  await field("skin.layers[1].thickness", "180 um");
  await good();
  await click("Readout", ".form");
  await click("Add a taxel");
  await wait(() => document.querySelector('[data-key="readout.taxels[0].name"]') && document.querySelector(".verdict.good"));
  await click("Add a taxel");
  await wait(() => document.querySelector('[data-key="readout.taxels[1].name"]') && document.querySelector(".verdict.good"));
  assert.match(await page.$eval("textarea", (one) => one.value), /\[\[readout\.taxels\]\]\nname = "t2"\n/);
  assert.ok(!(await page.$eval('[data-key="readout.taxels.rows"]', (one) => one.checkVisibility())), "a list of taxels is not a grid");
  // Of a list and a pair each number has an input.
  await click("Output", ".form");
  const instants = await page.$$eval('[data-key^="output.fields["]', (all) => all.length);
  await press("Add to Fields");
  await field(`output.fields[${instants}]`, "soon");
  await wait((key) => document.querySelector(`[data-key="${key}"][aria-invalid="true"]`), `output.fields[${instants}]`);
  await field(`output.fields[${instants}]`, "0.75 s");
  await good();
  assert.match(await page.$eval("textarea", (one) => one.value), /fields = \[.*"0\.75 s"\]/);
  await press(`Remove Fields, ${instants + 1}`);
  await wait((count) => document.querySelectorAll('[data-key^="output.fields["]').length === count && document.querySelector(".verdict.good"), instants);
  assert.equal(await page.$$eval('[data-key^="slider.start["]', (all) => all.length), 2);
  await picture("rows");
  await press("Remove taxel 2");
  await wait(() => !document.querySelector('[data-key="readout.taxels[1].name"]'));
  await press("Remove taxel 1");
  await wait(() => !document.querySelector('[data-key="readout.taxels[0].name"]') && document.querySelector(".verdict.good"));
  for (const section of ["Skin", "Readout", "Output"]) await click(section, ".form");
  await field("title", '<img src=x onerror="alert(1)">');
  await wait(() => document.querySelector(".verdict.good"));
  assert.match(await page.$eval("textarea", (one) => one.value), /friction = 0\.3\n/);
  await picture("case");

  // Run it.
  begun = performance.now();
  await fill("Name of the results", "first");
  await click("Run");
  await shown(["first"]);
  times["first run to curve"] = performance.now() - begun;
  assert.equal(await page.$(".facts img"), null);
  await wait(() => document.querySelector(".legend").textContent);
  await picture("results");

  // Other coupling; both curves.
  await click("Case");
  await wait(() => document.querySelector(".verdict.good"));
  await field("coupling.coefficient", "0.2");
  await wait(() => /coefficient = 0\.2/.test(document.querySelector("textarea").value) && document.querySelector(".verdict.good"));
  await fill("Name of the results", "second");
  begun = performance.now();
  await click("Run");
  await shown(["first", "second"]);
  times["rerun to curve (coupling)"] = performance.now() - begun;
  await click("Case");
  await wait(() => document.querySelector(".verdict.good"));
  await field("contact.friction", "0.15");
  await wait(() => /friction = 0\.15/.test(document.querySelector("textarea").value) && document.querySelector(".verdict.good"));
  await fill("Name of the results", "third");
  begun = performance.now();
  await click("Run");
  await shown(["first", "second", "third"]);
  times["rerun to curve (friction)"] = performance.now() - begun;
  await click("What differs between third and second");
  await wait(() => /contact.friction/.test(document.querySelector(".differences pre").textContent));
  await click("Case");
  await wait(() => document.querySelector(".verdict.good"));
  await field("electrochemistry.diffusivity", "5e-11 m2/s");
  await wait(() => /diffusivity = "5e-11/.test(document.querySelector("textarea").value) && document.querySelector(".verdict.good"));
  await fill("Name of the results", "fourth");
  begun = performance.now();
  await click("Run");
  await shown(["first", "second", "third", "fourth"]);
  times["rerun to curve (ions)"] = performance.now() - begun;

  // The scene follows the time bar, every cut and face.
  await page.$eval('.time-bar input', (one) => { one.value = "1.5"; one.dispatchEvent(new Event("input")); });
  const mark = () => page.$eval(".curves .instant", (one) => one.getBoundingClientRect().left);
  const early = await mark();
  await page.$eval('.time-bar input', (one) => { one.value = "2.5"; one.dispatchEvent(new Event("input")); });
  assert.ok(await mark() > early + 100, "the mark on the curves follows the time bar");
  await page.$eval('.time-bar input', (one) => { one.value = "1.5"; one.dispatchEvent(new Event("input")); });
  for (const [label, values] of [["Cut", ["x", "z", "volume", "y"]], ["Face", ["slip", "pressure"]]]) {
    for (const value of values) await fill(label, value);
  }
  // Curves stand before the list of stored fields has come.
  await wait((wanted) => {
    const listed = [...document.querySelectorAll(".scene-panel option")].map((one) => one.value);
    return wanted.every((one) => listed.includes(one));
  }, ["strain/gamma", "ions/concentration", "ions/potential"]);
  await fill("Field", "ions/concentration");
  await wait(() => /Concentration/.test(document.querySelector(".legend").textContent));
  await fill("Thickness stretched", "20");
  await picture("scene");
  times["scene, frames a second"] = await page.evaluate(async () => {
    document.querySelector(".time-bar button").click();
    const begin = performance.now();
    let frames = 0;
    await new Promise((resolve) => requestAnimationFrame(function step() { ++frames; performance.now() - begin > 2000 ? resolve() : requestAnimationFrame(step); }));
    document.querySelector(".time-bar button").click();
    return frames / ((performance.now() - begin) / 1000);
  });

  // Sweep.
  await click("Case");
  await wait(() => document.querySelector(".verdict.good"));
  await click("Sweep a key");
  await fill("Key", "coupling.coefficient");
  await fill("From", "0.1");
  await fill("Step", "0.1");
  await fill("To", "0.3");
  await click("Run the sweep");
  await wait(() => /Coupling: coefficient = 0.1/.test(document.querySelector(".sweep output")?.textContent));
  await page.$eval(".sweep input[type=range]", (one) => { one.value = "2"; one.dispatchEvent(new Event("input")); });
  await wait(() => /Coupling: coefficient = 0.3/.test(document.querySelector(".sweep output").textContent) && /0003/.test(document.querySelector(".curves .plot").textContent));
  await wait(() => document.querySelector(".legend").textContent);
  await picture("sweep");

  // Fit on a CSV.
  await click("Case");
  await wait(() => document.querySelector(".verdict.good"));
  await click("Fit to a measurement");
  const input = await page.$('.actions input[type="file"]');
  const measured = path.join(folder, "measured.csv");
  fs.copyFileSync(path.join(workspace, "second", "sampled.csv"), measured);
  await input.uploadFile(measured);
  await wait(() => [...document.querySelectorAll(".actions option")].some((one) => one.value === "measured.csv"));
  await wait(() => [...document.querySelectorAll(".actions option")].some((one) => one.value === "current_difference"));
  await click("Run the fit");
  await wait(() => /Fitted keys/.test(document.body.textContent));
  await picture("fit");

  // Overlay of the measurement, log scale, exports.
  await page.evaluate(() => [...document.querySelectorAll(".results button")].find((one) => one.textContent === "second").click());
  await shown(["second"]);
  await (await page.$('.curves input[type="file"]')).uploadFile(measured);
  await wait(() => /measured.csv/.test(document.querySelector(".curves .plot").textContent));
  await page.evaluate(() => [...document.querySelectorAll(".curves .check")].find((one) => /Log/.test(one.textContent)).querySelector("input").click());
  for (const [text, within] of [["Save CSV", ".curves"], ["Save SVG", ".curves"], ["Save PNG", ".curves"], ["Save PNG", ".scene-panel"]]) await click(text, within);
  for (const file of ["curves.csv", "curves.svg", "curves.png", "skin.png"]) {
    for (let i = 0; !fs.existsSync(path.join(downloads, file)); ++i) {
      assert.ok(i < 100, `${file} was not saved`);
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }
  assert.match(fs.readFileSync(path.join(downloads, "curves.csv"), "utf8"), /^series,time \[s\],value,unit\n/);
  await picture("overlay");

  // Dark, the queue, the keyboard.
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await picture("dark");
  await click("Queue");
  await wait(() => document.querySelectorAll(".job.finished").length === 6);
  assert.equal(await page.$eval(".job.found pre", (one) => one.textContent), "ionskin run '<i>brought.toml' -o brought --no-report");
  await picture("queue");
  await click("Remove", ".job.found");
  await wait(() => !document.querySelector(".job.found"));
  assert.ok(!fs.existsSync(brought));
  await page.keyboard.press("Tab");
  assert.notEqual(await page.evaluate(() => document.activeElement.tagName), "BODY");
};

const [server, link] = await start_server();
const browser = await puppeteer.launch({ executablePath: "/usr/bin/chromium", headless: true,
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage"] });
try {
  const page = await browser.newPage();
  listen(page);
  const session = await browser.target().createCDPSession();
  await session.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: downloads });
  try {
    await main(page, link);
  } catch (error) {
    await page.screenshot({ path: path.join(pictures, "failed.png"), fullPage: true });
    console.error(problems.join("\n"), await page.$eval("#status", (one) => one.textContent));
    throw error;
  }
  for (const [name, value] of Object.entries(times)) console.log(`${name}: ${name.includes("frames") ? value.toFixed(0) : `${(value / 1000).toFixed(2)} s`}`);
  assert.deepEqual(problems, []);
} finally {
  await browser.close();
  server.kill("SIGINT");
  await new Promise((resolve) => server.once("exit", resolve));
  fs.rmSync(folder, { recursive: true, force: true });
}

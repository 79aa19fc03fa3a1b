// The HTML report in a real browser. Usage: node report_browser_test.mjs PLUMBLINE MODULES CHROMIUM SCRATCH
// PLUMBLINE is the tool, MODULES a node_modules folder with playwright-core, SCRATCH where the drawing,
// the page and screenshots of it are left.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";

import { open } from "./browser.mjs";

const [plumbline, modules, chromium, scratch] = process.argv.slice(2);

// A room of 40 x 20 with a pillar of 20 x 10 in it, and two triangles with a corner cut off by
// 1/100: merging within 1/16 joins the two vertices there. Names that must not become markup.
const evil = "</script><img src=x onerror=alert(1)>";
const escaped = evil.replaceAll("<", "&lt;").replaceAll(">", "&gt;");
const drawing = `<svg xmlns="http://www.w3.org/2000/svg">
<rect id="room" width="40" height="20"/>
<rect x="10" y="5" width="20" height="10"/>
<polygon id="${escaped}" points="50,0 54,0 54,0.01 50,4"/>
<polygon points="50,10 52,10 52,10.01 50,12"/>
</svg>`;

const file = path.join(scratch, 'a&b"<i>.svg');
const page_file = path.join(scratch, "report.html");
let opened, context, page;

before(async () => {
  mkdirSync(scratch, { recursive: true });
  writeFileSync(file, drawing);
  const run = spawnSync(plumbline, ["check", file, "--radius", "0.0625", "--report", page_file]);
  assert.equal(run.status, 1, `the float result disagrees: ${run.stderr}`);
  opened = await open(page_file, modules, chromium);
  ({ context, page } = opened);
});

after(() => opened?.close());

const view = () =>
  page.evaluate(() => {
    const { view } = window.plumbline;
    const { k, x, y } = view.transform;
    return { k, x, y, width: view.width, height: view.height, all: view.wholeScale() };
  });
/// Where a place of the drawing is on the page.
const onPage = ([x, y]) =>
  page.evaluate(
    ([x, y]) => {
      const { view, drawing } = window.plumbline;
      const [u, v] = view.transform.apply(drawing.local([x, y]));
      const box = view.stage.getBoundingClientRect();
      return [u + box.left, v + box.top];
    },
    [x, y],
  );
/// Drawn and at rest.
const still = () => page.waitForTimeout(900);
const showAll = async () => {
  await page.click("#zoom-all");
  await still();
};
/// The pixel of the layer of lines and faces at a place of the drawing, moved by some pixels.
const pixel = ([x, y], [dx, dy] = [0, 0]) =>
  page.evaluate(
    ([x, y, dx, dy]) => {
      const { view, drawing, scene } = window.plumbline;
      scene.drawNow();
      const [u, v] = view.transform.apply(drawing.local([x, y]));
      const copy = document.createElement("canvas");
      const lines = document.getElementById("lines");
      copy.width = lines.width;
      copy.height = lines.height;
      copy.getContext("2d").drawImage(lines, 0, 0);
      const ratio = lines.width / view.width;
      const at = [Math.round((u + dx) * ratio), Math.round((v + dy) * ratio)];
      return [...copy.getContext("2d").getImageData(at[0], at[1], 1, 1).data];
    },
    [x, y, dx, dy],
  );
const brightness = ([r, g, b]) => r + g + b;
const items = () => page.locator("#finding-list > li").count();

test("the page loads nothing but itself, and says nothing on the console", async () => {
  await still();
  await page.screenshot({ path: path.join(scratch, "all.png") });
  assert.deepEqual(opened.requests, [pathToFileURL(page_file).href]);
  assert.deepEqual(opened.errors(), []);
});

test("title and verdict are those of the check", async () => {
  assert.match(await page.textContent("h1"), /Disagree: \d+ findings.*a&b"<i>\.svg/s);
  const cells = await page.locator("#answers tbody tr").first().locator("td").allTextContents();
  assert.deepEqual(cells, ["16", "16", "14"]); // vertices
});

test("groups come first: a click shows the group, its place and its findings alone", async () => {
  await showAll();
  const before = await view();
  const groups = page.locator("#group-list > li");
  assert.equal(await groups.count(), await page.evaluate(() => window.plumbline.drawing.report.groups.length));
  assert.equal(await groups.count(), 2);
  await page.screenshot({ path: path.join(scratch, "groups.png") });
  await groups.first().locator(".finding-head").click();
  await still();
  assert.ok((await view()).k > before.k);
  const members = await page.evaluate(() => window.plumbline.drawing.report.groups[0].findings.length);
  await page.screenshot({ path: path.join(scratch, "group.png") });
  await page.locator("#group-list .show").click();
  assert.ok(await page.isVisible("#findings-panel"));
  assert.equal(await items(), members);
  await page.click("#group-chip");
  assert.equal(await page.isVisible("#group-filter"), false);
  assert.equal(await items(), await page.evaluate(() => window.plumbline.drawing.report.findings.length));
});

test("a click on a finding flies to it and shows its exact numbers and sources", async () => {
  await showAll();
  const before = await view();
  await page.click("#findings-tab");
  await page.locator("#finding-list .finding-head", { hasText: "vertex merged" }).last().click();
  await still();
  const now = await view();
  assert.ok(now.k > 100 * before.k, `zoomed from ${before.k} to ${now.k}`);
  const box = await page.locator("#stage").boundingBox();
  const at = await onPage([54, 0.005]);
  assert.ok(Math.abs(at[0] - box.x - now.width / 2) < 0.25 * now.width, "it is in the middle");
  assert.ok(Math.abs(at[1] - box.y - now.height / 2) < 0.25 * now.height);
  const details = await page.textContent("li.open .details");
  assert.match(details, /exact x\s*54/);
  assert.match(details, /0\.01/);
  assert.ok(details.includes(`#${evil}`), "names are shown as they are");
  await page.screenshot({ path: path.join(scratch, "finding.png") });
});

test("kinds and stages filter the list", async () => {
  const all = await items();
  const chip = page.locator('#kind-filter [data-value="vertex"]');
  const vertices = Number(await chip.locator("span").textContent());
  assert.ok(vertices > 0 && vertices < all);
  await chip.click();
  assert.equal(await items(), all - vertices);
  await chip.click();
  assert.equal(await items(), all);
  for (const stage of await page.locator("#stage-filter .chip").all()) await stage.click();
  assert.equal(await items(), 0);
  for (const stage of await page.locator("#stage-filter .chip").all()) await stage.click();
  assert.equal(await items(), all);
});

test("a face under the pointer shows its area, depth, holes and sources", async () => {
  await showAll();
  await page.mouse.move(...(await onPage([5, 10])));
  await page.waitForSelector("#tip:not([hidden])");
  const tip = await page.textContent("#tip");
  assert.match(tip, /area600depth1holes1/); // 40 x 20 - 20 x 10
  assert.match(tip, /#room/);
  await page.screenshot({ path: path.join(scratch, "face.png") });
  await page.mouse.move(...(await onPage([20, 10])));
  await page.waitForFunction(() => document.getElementById("tip").textContent.includes("area200"));
  assert.match(await page.textContent("#tip"), /depth2holes0/);
  await page.mouse.move(...(await onPage([45, 10])));
  await page.waitForSelector("#tip", { state: "hidden" });
});

test("keys pan, zoom, show all and go through the findings", async () => {
  await showAll();
  const start = await view();
  await page.focus("#stage");
  await page.keyboard.press("+");
  const nearer = await view();
  assert.ok(Math.abs(nearer.k / start.k - 1.5) < 1e-9);
  await page.keyboard.press("ArrowRight");
  assert.ok((await view()).x < nearer.x);
  await page.keyboard.press("0");
  await still();
  assert.ok(Math.abs((await view()).k - start.k) < 1e-9 * start.k);
  await page.keyboard.press("Escape");
  await page.keyboard.press("n");
  assert.equal(await page.getAttribute("li.open", "data-number"), "1");
  await page.keyboard.press("n");
  assert.equal(await page.getAttribute("li.open", "data-number"), "2");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("li.open").count(), 0);
});

test("wheel, drag and two fingers move the view", async () => {
  await showAll();
  const start = await view();
  const [x, y] = await onPage([20, 10]);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -240);
  await still();
  const nearer = await view();
  assert.ok(nearer.k > 1.2 * start.k);
  const [now] = await onPage([20, 10]);
  assert.ok(Math.abs(now - x) < 1, "what is under the pointer stays there");
  await page.mouse.down();
  await page.mouse.move(x + 50, y + 30, { steps: 4 });
  await page.mouse.up();
  const moved = await view();
  assert.ok(Math.abs(moved.x - nearer.x - 50) < 1 && Math.abs(moved.y - nearer.y - 30) < 1);
  const touch = await context.newCDPSession(page);
  const fingers = (type, apart) =>
    touch.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: apart ? [{ x: x - apart, y, id: 0 }, { x: x + apart, y, id: 1 }] : [],
    });
  await fingers("touchStart", 40);
  await fingers("touchMove", 60);
  await fingers("touchMove", 80);
  await fingers("touchEnd", 0);
  assert.ok(Math.abs((await view()).k / moved.k - 2) < 0.01);
});

test("layers come and go", async () => {
  await showAll();
  const corner = [20, 0]; // on an edge of the room
  assert.equal((await pixel(corner))[3], 255);
  for (const layer of ["authored", "float"]) await page.uncheck(`#layer-${layer}`);
  await page.selectOption("#faces", "none");
  assert.equal((await pixel(corner))[3], 0);
  for (const layer of ["input", "doubles", "float", "authored"]) {
    await page.check(`#layer-${layer}`);
    assert.ok((await pixel(corner))[3] > 200, layer);
    await page.uncheck(`#layer-${layer}`);
  }
  for (const layer of ["authored", "float"]) await page.check(`#layer-${layer}`);
  await page.selectOption("#faces", "authored");
});

test("a corner stays sharp when it is a thousand million times larger", async () => {
  await page.evaluate(() => {
    const { view, drawing } = window.plumbline;
    const [x, y] = drawing.local([40, 20]);
    const half = 2e-8;
    view.show({ left: x - half, right: x + half, top: y - half, bottom: y + half }, false);
  });
  await still();
  const now = await view();
  assert.ok(now.k > 1e9 * now.all * 0.9, `${now.k / now.all} times`);
  const corner = [40, 20];
  const onEdge = await pixel(corner, [-200, 0]);
  assert.equal(onEdge[3], 255);
  for (const away of [-12, 12]) {
    assert.equal((await pixel(corner, [-200, away]))[3], 0, `${away} pixels beside the edge`);
    assert.ok(brightness(await pixel(corner, [away, -200])) !== brightness(onEdge));
  }
  assert.equal((await pixel(corner, [0, -200]))[3], 255);
  await page.screenshot({ path: path.join(scratch, "deep.png") });
});

test("faces are pulled apart by the slider, and still know who they are", async () => {
  await showAll();
  await page.evaluate(() => {
    const slider = document.getElementById("apart");
    slider.value = "100";
    slider.dispatchEvent(new Event("input"));
  });
  await still();
  assert.equal((await pixel([20, 0]))[3], 0, "the room has left its upper edge");
  await page.mouse.move(...(await onPage([20, 10])));
  await page.waitForFunction(() => document.getElementById("tip").textContent.includes("area200"));
  await page.screenshot({ path: path.join(scratch, "apart.png") });
  await page.evaluate(() => {
    const slider = document.getElementById("apart");
    slider.value = "0";
    slider.dispatchEvent(new Event("input"));
  });
});

test("the tolerance ladder is a plot and a table", async () => {
  await page.click("#ladder-tab");
  const steps = await page.evaluate(() => window.plumbline.drawing.report.ladder.steps.length);
  assert.ok(steps > 0);
  assert.equal(await page.locator("#ladder-panel svg path.series").count(), 3);
  assert.equal(await page.locator("#ladder-panel tbody tr").count(), steps + 1);
  await page.locator("#ladder-panel tbody button").first().click();
  await still();
  assert.ok((await view()).k > 10 * (await view()).all);
  await page.screenshot({ path: path.join(scratch, "ladder.png") });
  await page.click("#findings-tab");
});

test("dark colours are readable", async () => {
  await showAll();
  const light = brightness(await pixel([5, 10]));
  await page.emulateMedia({ colorScheme: "dark" });
  await still();
  assert.ok(brightness(await pixel([5, 10])) < light / 2);
  await page.screenshot({ path: path.join(scratch, "dark.png") });
  await page.emulateMedia({ colorScheme: "light" });
});

test("print has the picture and the whole list, and no controls", async () => {
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  await still();
  assert.ok(brightness(await pixel([5, 10])) > 600, "on white paper");
  for (const id of ["#layers", "#tools", ".filter"])
    assert.equal(await page.locator(id).first().isVisible(), false, id);
  const count = await page.evaluate(() => window.plumbline.drawing.report.findings.length);
  assert.equal(await items(), count);
  assert.ok(await page.locator("#group-list > li").last().isVisible());
  assert.equal(await page.locator("#finding-list .details").count(), count);
  assert.ok(await page.locator("#finding-list > li").last().isVisible());
  await page.screenshot({ path: path.join(scratch, "print.png"), fullPage: true });
  await page.emulateMedia({ media: null, colorScheme: "light" });
  const pdf = await page.pdf({ path: path.join(scratch, "report.pdf") });
  assert.ok(pdf.length > 20000);
});

test("everything that can be pressed has a name", async () => {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select")]
      .filter((node) => !(node.textContent.trim() || node.ariaLabel || node.labels?.length))
      .map((node) => node.outerHTML),
  );
  assert.deepEqual(nameless, []);
});

test("a browser without WebGL2 says so, and shows the rest", async () => {
  const plain = await context.newPage();
  await plain.addInitScript(() => {
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind === "webgl2" ? null : getContext.call(this, kind, ...rest);
    };
  });
  await plain.goto(pathToFileURL(page_file).href);
  await plain.waitForSelector("html[data-ready]");
  assert.match(await plain.textContent("#stage"), /WebGL2/);
  await plain.locator(".finding-head").first().click();
  assert.equal(await plain.locator("li.open .details").count(), 1);
  await plain.close();
});

test("nothing went wrong on the way", () => {
  assert.deepEqual(opened.errors(), []);
});

// The page of a repair in a real browser. Usage: node repair_browser_test.mjs PLUMBLINE MODULES CHROMIUM SCRATCH
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

// A box of 12 x 6 that is open at a corner by 0.02 and goes 0.03 too far there; a wall with a door of 0.9 in
// it; one side is drawn twice. A short line beside a wall, whose ends are near it and lead nowhere, is
// refused. An id that must not become markup.
const evil = "</script><img src=x onerror=alert(1)>";
const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
const line = (x1, y1, x2, y2, id = "") => `<line x1="${x1}" y1="${y1}" x2="${x2}" y2="${y2}" id="${escaped(id)}"/>`;
const drawing = `<svg xmlns="http://www.w3.org/2000/svg">${[
  line(0, 0, 12.03, 0), line(12, 0.02, 12, 6, evil), line(12, 6, 0, 6), line(0, 6, 0, 0), line(0, 6, 0, 0),
  line(6, 0, 6, 2.5), line(6, 3.4, 6, 6), line(11.96, 2, 11.96, 3),
].join("\n")}</svg>`;

const file = path.join(scratch, 'a&b"<i>.svg');
const page_file = path.join(scratch, "repair.html");
let opened, page;

before(async () => {
  mkdirSync(scratch, { recursive: true });
  writeFileSync(file, drawing);
  const run = spawnSync(plumbline, ["repair", file, "--grow", "0.05", "--trim", "0.05", "--weld", "off", "--doors", "0.6..1.2", "--report", page_file]);
  assert.equal(run.status, 1, String(run.stderr)); // something was refused
  opened = await open(page_file, modules, chromium);
  ({ page } = opened);
});

after(() => opened?.close());

const items = (panel) => page.locator(`#${panel}-panel .list > li`);
const kinds = async () => (await page.locator("#edits-panel .what").allTextContents()).join(" ");
const item = (kind) => items("edits").filter({ has: page.locator(".what", { hasText: kind }) });
const scale = () => page.evaluate(() => window.plumbline.view.transform.k);
/// Where a place of the drawing is on the stage, in pixels from its middle.
const offMiddle = (x, y) => page.evaluate(([x, y]) => {
  const { view, data } = window.plumbline;
  const [px, py] = view.transform.apply(data.local([x, y]));
  return Math.hypot(px - view.width / 2, py - view.height / 2);
}, [x, y]);
/// How many pixels of the picture are nearly of this colour of the style sheet.
const pixels = (name) => page.evaluate((name) => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const css = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  const wanted = [1, 3, 5].map((i) => parseInt(css.slice(i, i + 2), 16));
  const canvas = document.getElementById("lines");
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4)
    if (data[i + 3] > 250 && wanted.every((value, j) => Math.abs(data[i + j] - value) < 6)) ++count;
  resolve(count);
}))), name);
const still = () => page.waitForFunction(() => document.documentElement.dataset.flashing === "");
const home = async () => {
  await page.focus("#stage");
  await page.keyboard.press("Escape");
  await page.keyboard.press("0");
  await page.waitForTimeout(900);
};

test("the page loads nothing but itself, and says nothing on the console", async () => {
  await page.screenshot({ path: path.join(scratch, "both.png") });
  assert.deepEqual(opened.requests, [pathToFileURL(page_file).href]);
  assert.deepEqual(opened.errors(), []);
});

test("names stay text", async () => {
  assert.match(await page.title(), /a&b"<i>\.svg/);
  assert.match(await page.textContent("h1"), /a&b"<i>\.svg/);
  assert.match(await item("grow").textContent(), /<img src=x/);
  assert.equal(await page.locator("img, i, b").count(), 0);
});

test("what was done is in the list, what does most first, with rooms and elements", async () => {
  assert.match(await page.textContent("#facts"), /4 edits: .*1 end grown by 0\.02, 1 door of 0\.9 closed/);
  assert.equal(await page.textContent("#edits-tab"), "Edits 4");
  assert.match(await kinds(), /^(door grow|grow door) trim merge$/);
  assert.match(await item("door").textContent(), /0\.9.*a new line/);
  assert.match(await item("trim").textContent(), /0\.03\(12, 0\)/);
});

test("a click flies to the place and flashes the ring there", async () => {
  const before = await scale();
  await item("grow").locator("button").click();
  await page.waitForFunction(() => document.documentElement.dataset.flashing !== "");
  await page.screenshot({ path: path.join(scratch, "flash.png") });
  await still();
  assert.ok((await scale()) > 20 * before, "it is nearer");
  assert.ok((await offMiddle(12, 0.02)) < 1, "in the middle");
  assert.ok((await pixels("added")) > 50 && (await pixels("removed")) > 50, "what was done can be seen");
  assert.match(await item("grow").textContent(), /its square0\.0004/);
  await page.screenshot({ path: path.join(scratch, "chosen.png") });
  await home();
  assert.ok(Math.abs((await scale()) / before - 1) < 1e-6);
  assert.equal(await items("edits").locator("dl").count(), 0, "Escape closes it");
});

test("before, after, or both: each has its lines and faces", async () => {
  await item("door").locator("button").click();
  await still();
  for (const [side, has] of [["before", 0], ["after", 1], ["both", 1]]) {
    await page.check(`input[name="side"][value="${side}"]`);
    assert.equal((await pixels("virtual")) > 0, has === 1, `virtual lines ${side}`);
    assert.equal((await pixels("face-closed")) + (await pixels("face-split")) > 0, has === 1, `faces ${side}`);
    await page.screenshot({ path: path.join(scratch, `${side}-door.png`) });
  }
  await item("trim").locator("button").click();
  await still();
  for (const [side, has] of [["before", 1], ["after", 0], ["both", 1]]) {
    await page.check(`input[name="side"][value="${side}"]`);
    assert.equal((await pixels("removed")) > 0, has === 1, `removed lines ${side}`);
  }
  await home();
});

test("the legend says what there is, and nothing else", async () => {
  for (const [key, has] of [["kept", true], ["added", true], ["virtual", true], ["removed", true], ["moved-to", false], ["face-opened", false]])
    assert.equal(await page.locator(`#key-${key}`).isVisible(), has, key);
});

test("what was refused is a list of its own, with reasons, and has marks of its own", async () => {
  await page.click("#refused-tab");
  assert.equal(await items("refused").count(), 2);
  assert.match(await items("refused").first().textContent(), /grow.*nothing straight ahead/);
  await items("refused").first().locator("button").click();
  await still();
  assert.ok((await offMiddle(11.96, 2)) < 1 || (await offMiddle(11.96, 3)) < 1);
  await page.screenshot({ path: path.join(scratch, "refused.png") });
  await home();
  await page.click("#edits-tab");
});

test("rooms say which part of their border is virtual, and are flown to", async () => {
  await page.click("#faces-tab");
  const titles = await page.locator("#faces-panel .what").allTextContents();
  const shares = titles.filter((title) => /3\.8 % of its border virtual/.test(title)); // 0.9 of 24
  assert.equal(shares.length, 2, titles.join("\n"));
  const before = await scale();
  await items("faces").first().locator("button").click();
  await still();
  assert.ok((await scale()) > before, "nearer");
  await page.mouse.move(5, 5);
  const stage = await page.locator("#stage").boundingBox();
  await page.mouse.move(stage.x + stage.width / 2, stage.y + stage.height / 2 + 60);
  assert.match(await page.textContent("#tip"), /virtual/);
  await page.screenshot({ path: path.join(scratch, "rooms.png") });
  await home();
  await page.click("#edits-tab");
});

test("a search and the chips by kind leave out items; the count says so", async () => {
  await page.fill("#edits-panel .search", "DOOR");
  assert.equal(await kinds(), "door");
  assert.equal(await page.textContent("#edits-panel .total"), "1 of 4");
  await page.fill("#edits-panel .search", "img onerror");
  assert.equal(await kinds(), "grow");
  await page.fill("#edits-panel .search", "");
  const chip = page.locator('#edits-panel .chip[data-value="merge"]');
  await chip.click();
  assert.equal(await chip.getAttribute("aria-pressed"), "false");
  assert.equal(await items("edits").count(), 3);
  await chip.click();
  assert.equal(await items("edits").count(), 4);
});

test("a list can be sorted by size and by number", async () => {
  const sort = (title) => page.selectOption("#edits-panel select", { label: title });
  await sort("large ones");
  assert.equal(await kinds(), "door trim grow merge");
  await sort("low numbers");
  const numbers = await page.locator("#edits-panel .badge").allTextContents();
  assert.deepEqual(numbers, ["1", "2", "3", "4"]);
  await sort("what changes most");
});

test("a ring can be clicked, and goes through the list by n and p", async () => {
  await home();
  const stage = await page.locator("#stage").boundingBox();
  const [x, y] = await page.evaluate(() => {
    const { view, data } = window.plumbline;
    return view.transform.apply(data.local([6, 2.95]));
  });
  await page.mouse.click(stage.x + x, stage.y + y);
  assert.equal(await page.locator("#edits-panel li.open .what").textContent(), "door");
  await page.focus("#stage");
  const order = (await kinds()).split(" ");
  await page.keyboard.press("n");
  assert.equal(await page.locator("#edits-panel li.open .what").textContent(), order[(order.indexOf("door") + 1) % 4]);
  await page.keyboard.press("p");
  assert.equal(await page.locator("#edits-panel li.open .what").textContent(), "door");
  await home();
});

test("all is there for the keyboard", async () => {
  await item("trim").locator("button").focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.locator("#edits-panel li.open .what").textContent(), "trim");
  const focused = await page.evaluate(() => document.activeElement.closest("li")?.className);
  assert.equal(focused, "open", "the focus stays");
  await page.focus("#edits-tab");
  for (const tab of ["refused", "faces", "tolerances"]) {
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.locator(`#${tab}-panel`).isVisible(), true);
  }
  assert.match(await page.textContent("#tolerances-panel"), /grow 0\.05/);
  await page.click("#edits-tab");
  await page.focus('input[name="side"][value="both"]');
  await page.keyboard.press("ArrowLeft");
  assert.equal(await page.isChecked('input[name="side"][value="after"]'), true);
  await page.keyboard.press("ArrowRight");
  await home();
});

test("everything that can be pressed has a name", async () => {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select")]
      .filter((node) => !(node.textContent.trim() || node.ariaLabel || node.labels?.length))
      .map((node) => node.outerHTML),
  );
  assert.deepEqual(nameless, []);
});

test("dark colours are readable", async () => {
  await page.emulateMedia({ colorScheme: "dark" });
  assert.ok((await pixels("kept")) > 100);
  await page.screenshot({ path: path.join(scratch, "dark.png") });
  await page.emulateMedia({ colorScheme: "light" });
});

test("print has the picture and all lists, on white, and no controls", async () => {
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  for (const id of [".controls", "#tools", "#sides"]) assert.equal(await page.locator(id).first().isVisible(), false, id);
  for (const panel of ["edits", "refused", "faces", "tolerances"])
    assert.equal(await page.locator(`#${panel}-panel`).isVisible(), true, panel);
  const paper = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  assert.equal(paper, "rgb(255, 255, 255)");
  await page.screenshot({ path: path.join(scratch, "print.png"), fullPage: true });
  await page.emulateMedia({ media: null, colorScheme: "light" });
  const pdf = await page.pdf({ path: path.join(scratch, "repair.pdf"), printBackground: true });
  assert.ok(pdf.length > 10000);
});

test("5,000 edits stay usable: dots for rings, items as they come into sight", async () => {
  const rows = [];
  for (let i = 0; i <= 72; ++i)
    for (let j = 0; j < 72; ++j) {
      const gap = i > 0 && i < 72 ? 0.02 : 0;
      rows.push(`${10 * j},${10 * i},${10 * j + 10 - gap},${10 * i}`, `${10 * i},${10 * j},${10 * i},${10 * j + 10}`);
    }
  const many = path.join(scratch, "many.lines"), report = path.join(scratch, "many.html");
  writeFileSync(many, rows.join("\n"));
  assert.equal(spawnSync(plumbline, ["repair", many, "--grow", "0.05", "--report", report]).status, 0);
  const large = await open(report, modules, chromium);
  try {
    const edits = Number((await large.page.textContent("#edits-tab")).replace(/\D/g, ""));
    assert.ok(edits >= 5000, String(edits));
    assert.ok((await large.page.locator("#edits-panel li").count()) < 1000);
    const milliseconds = await large.page.evaluate(() => {
      const times = [];
      for (let i = 0; i < 5; ++i) {
        const begin = performance.now();
        window.plumbline.stage.draw();
        times.push(performance.now() - begin);
      }
      return times.sort((a, b) => a - b)[2];
    });
    assert.ok(milliseconds < 500, `a frame took ${milliseconds} ms`);
    console.log(`a frame of ${rows.length} lines and ${edits} edits: ${milliseconds.toFixed(1)} ms`);
    await large.page.screenshot({ path: path.join(scratch, "many.png") });
    await large.page.fill("#edits-panel .search", "nowhere");
    assert.equal(await large.page.locator("#edits-panel li").count(), 0);
    assert.deepEqual(large.errors(), []);
  } finally {
    await large.close();
  }
});

test("nothing went wrong on the way", () => {
  assert.deepEqual(opened.errors(), []);
});

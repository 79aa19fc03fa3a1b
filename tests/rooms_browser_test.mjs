// The page of rooms in a real browser. Usage: node rooms_browser_test.mjs PLUMBLINE MODULES CHROMIUM SCRATCH
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

// Four rooms side by side, in metres 2 x 1.5, 10 x 4, 3 x 4 and 4 x 4. Names that must not become markup.
const evil = ["</script><img src=x onerror=alert(1)>", "</title></svg><script>alert(2)</script>", '"&lt;b&gt;'];
const names = ["Bath", evil[0], evil[1], evil[2]];
const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
const lefts = [0, 2000, 12000, 15000], widths = [2000, 10000, 3000, 4000], heights = [1500, 4000, 4000, 4000];
const drawing = `<svg xmlns="http://www.w3.org/2000/svg" width="19000mm" height="4000mm" viewBox="0 0 19000 4000">
${names.map((name, i) => `<rect x="${lefts[i]}" width="${widths[i]}" height="${heights[i]}"/>
<text x="${lefts[i] + 1000}" y="1000">${escaped(name)}</text>`).join("\n")}
</svg>`;

const file = path.join(scratch, 'a&b"<i>.svg');
const page_file = path.join(scratch, "rooms.html");
let opened, page;

before(async () => {
  mkdirSync(scratch, { recursive: true });
  writeFileSync(file, drawing);
  const run = spawnSync(plumbline, ["rooms", file, "--report", page_file]);
  assert.equal(run.status, 0, String(run.stderr));
  opened = await open(page_file, modules, chromium);
  ({ page } = opened);
});

after(() => opened?.close());

const row = (room) => page.locator(`#rooms tr[data-room="${room}"]`);
const shape = (room) => page.locator(`#plan path[data-room="${room}"]`);
/// Rooms of which rows and shapes are of this class.
const marked = (name) =>
  page.evaluate(
    (name) => ["#rooms tr", "#plan path"].map((where) =>
      [...document.querySelectorAll(`${where}[data-room].${name}`)].map((node) => node.dataset.room).join(" ")),
    name,
  );
const order = () => page.locator("#rooms tbody tr").evaluateAll((rows) => rows.map((r) => r.dataset.room).join(" "));
const shown = async () => {
  const visible = await page.locator("#rooms tbody tr:visible").evaluateAll((rows) => rows.map((r) => r.dataset.room));
  return visible.join(" ");
};
const size = async (room) => (await shape(room).boundingBox()).width;

test("the page loads nothing but itself, and says nothing on the console", async () => {
  await page.screenshot({ path: path.join(scratch, "all.png") });
  assert.deepEqual(opened.requests, [pathToFileURL(page_file).href]);
  assert.deepEqual(opened.errors(), []);
});

test("names stay text, in the list, in the plan and in the title", async () => {
  assert.match(await page.title(), /a&b"<i>\.svg/);
  assert.match(await page.textContent("h1"), /a&b"<i>\.svg/);
  for (const [i, name] of names.entries()) {
    assert.equal(await row(i + 1).locator("td").nth(1).textContent(), name);
  }
  const words = await page.locator("#plan text").allTextContents();
  assert.ok(words.includes(names[0]) && words.includes(names[3]), words.join("\n"));
  assert.equal(await page.locator("img, i, b").count(), 0);
  assert.equal(await page.locator("script").count(), 1);
});

test("areas and neighbours are in the list", async () => {
  const headings = await page.locator("#rooms th").allTextContents();
  const cells = await row(2).locator("td").allTextContents();
  assert.equal(cells[headings.indexOf("area")], "40.00 m2");
  assert.equal(cells[headings.indexOf("neighbours")], "1, 3");
  assert.match(await page.textContent("#list p"), /4 rooms, 71\.00 m2/);
});

test("a room under the pointer is marked in the list and in the plan", async () => {
  await row(3).hover();
  assert.deepEqual(await marked("hovered"), ["3", "3"]);
  await shape(4).hover();
  assert.deepEqual(await marked("hovered"), ["4", "4"]);
  await page.screenshot({ path: path.join(scratch, "hovered.png") });
  await page.hover("h1");
  assert.deepEqual(await marked("hovered"), ["", ""]);
});

test("a click in the list flies to the room, a click in the plan chooses the row", async () => {
  const before = await size(1);
  await row(1).click();
  assert.deepEqual(await marked("chosen"), ["1", "1"]);
  assert.ok((await size(1)) > 1.5 * before, "it is nearer");
  const [plan, box] = [await page.locator("#plan svg").boundingBox(), await shape(1).boundingBox()];
  assert.ok(Math.abs(box.x + box.width / 2 - plan.x - plan.width / 2) < 2, "in the middle");
  assert.ok(Math.abs(box.y + box.height / 2 - plan.y - plan.height / 2) < 2);
  await page.screenshot({ path: path.join(scratch, "chosen.png") });
  await page.click("#whole");
  assert.deepEqual(await marked("chosen"), ["", ""]);
  assert.ok(Math.abs((await size(1)) - before) < 0.01);
  await shape(2).click();
  assert.deepEqual(await marked("chosen"), ["2", "2"]);
  assert.ok(Math.abs((await size(1)) - before) < 0.01, "the plan stays");
  await page.click("#whole");
});

test("the list is there for the keyboard", async () => {
  await row(4).focus();
  await page.keyboard.press("Enter");
  assert.deepEqual(await marked("chosen"), ["4", "4"]);
  await page.click("#whole");
});

test("a search hides rows, dims shapes and counts", async () => {
  await page.fill("#search", "BATH");
  assert.equal(await shown(), "1");
  assert.deepEqual(await marked("dimmed"), ["", "2 3 4"]);
  assert.equal(await page.textContent("#found"), "1 room");
  await page.screenshot({ path: path.join(scratch, "search.png") });
  await page.fill("#search", "alert script");
  assert.equal(await shown(), "2 3");
  assert.equal(await page.textContent("#found"), "2 rooms");
  await page.fill("#search", "nowhere");
  assert.equal(await shown(), "");
  assert.equal(await page.textContent("#found"), "0 rooms");
  await page.fill("#search", "");
  assert.equal(await shown(), "1 2 3 4");
  assert.deepEqual(await marked("dimmed"), ["", ""]);
  assert.equal(await page.textContent("#found"), "");
});

test("a click on a heading sorts, areas as numbers; another one the other way", async () => {
  const heading = (text) => page.locator("#rooms th", { hasText: text });
  await heading("area").locator("button").click();
  assert.equal(await order(), "1 3 4 2");
  assert.equal(await heading("area").getAttribute("aria-sort"), "ascending");
  await heading("area").locator("button").click();
  assert.equal(await order(), "2 4 3 1");
  await heading("room").locator("button").click();
  assert.equal(await order(), "1 2 3 4");
  assert.equal(await heading("area").getAttribute("aria-sort"), null);
});

test("everything that can be pressed has a name", async () => {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input")]
      .filter((node) => !(node.textContent.trim() || node.ariaLabel || node.labels?.length))
      .map((node) => node.outerHTML),
  );
  assert.deepEqual(nameless, []);
});

test("dark colours are readable", async () => {
  await page.emulateMedia({ colorScheme: "dark" });
  const colours = await page.evaluate(() => {
    const style = getComputedStyle(document.documentElement);
    return [style.color, style.backgroundColor].map((c) => c.match(/\d+/g).slice(0, 3).reduce((a, b) => a + +b, 0));
  });
  assert.ok(colours[0] > colours[1] + 300, colours.join(" on "));
  await page.screenshot({ path: path.join(scratch, "dark.png") });
  await page.emulateMedia({ colorScheme: "light" });
});

test("print has the plan and the whole list, on white, and no controls", async () => {
  await row(1).click(); // what is printed is what is seen, but for the controls
  await page.click("#whole");
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  for (const id of ["#search", "#whole", "#found"]) assert.equal(await page.locator(id).isVisible(), false, id);
  assert.equal(await shown(), "1 2 3 4");
  const paper = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  assert.equal(paper, "rgb(255, 255, 255)");
  await page.screenshot({ path: path.join(scratch, "print.png"), fullPage: true });
  await page.emulateMedia({ media: null, colorScheme: "light" });
  const pdf = await page.pdf({ path: path.join(scratch, "rooms.pdf"), printBackground: true });
  assert.ok(pdf.length > 10000);
});

test("nothing went wrong on the way", () => {
  assert.deepEqual(opened.errors(), []);
});

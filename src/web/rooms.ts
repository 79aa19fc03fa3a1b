// The page of rooms: the list beside the plan. The table and the plan are in the page without this;
// here they answer to each other: hovering, choosing, searching, sorting, zooming.

import { select } from "d3-selection";
import { zoom, zoomIdentity } from "d3-zoom";

import { byId, plural } from "./dom";

const table = byId<HTMLTableElement>("rooms");
const body = table.tBodies[0];
const rows = Array.from(body.rows);
const plan = document.querySelector<SVGSVGElement>("#plan svg")!;
const drawing = plan.querySelector<SVGGElement>("#drawing")!;

const shapes = new Map<string, SVGPathElement>();
for (const shape of drawing.querySelectorAll<SVGPathElement>("[data-room]")) {
  shapes.set(shape.dataset.room!, shape);
}

/** The room of an element, or of what it stands in. */
function roomOf(target: EventTarget | null): string | undefined {
  return (target as Element | null)?.closest<HTMLElement>("[data-room]")?.dataset.room;
}

function mark(name: string, room: string | undefined): void {
  for (const row of rows) row.classList.toggle(name, row.dataset.room === room);
  for (const [key, shape] of shapes) shape.classList.toggle(name, key === room);
}

const behaviour = zoom<SVGSVGElement, unknown>()
  .scaleExtent([1, 200])
  .on("zoom", (event) => drawing.setAttribute("transform", event.transform.toString()));
const stage = select(plan).call(behaviour);

function show(room: string): void {
  const shape = shapes.get(room);
  if (!shape) return;
  const box = shape.getBBox();
  const view = plan.viewBox.baseVal;
  const scale = Math.max(1, Math.min(
    200, 0.4 * Math.min(view.width / (box.width || 1), view.height / (box.height || 1)),
  ));
  const middle = zoomIdentity
    .translate(view.x + view.width / 2, view.y + view.height / 2)
    .scale(scale)
    .translate(-(box.x + box.width / 2), -(box.y + box.height / 2));
  stage.call(behaviour.transform, middle);
}

function choose(room: string | undefined, from: "plan" | "list"): void {
  mark("chosen", room);
  if (room === undefined) return;
  if (from === "list") show(room);
  else rows.find((row) => row.dataset.room === room)?.scrollIntoView({ block: "nearest" });
}

for (const [where, from] of [[plan, "plan"], [body, "list"]] as const) {
  where.addEventListener("pointerover", (event) => mark("hovered", roomOf(event.target)));
  where.addEventListener("pointerleave", () => mark("hovered", undefined));
  where.addEventListener("click", (event) => choose(roomOf(event.target), from));
}
body.addEventListener("keydown", (event) => {
  if (event.key === "Enter") choose(roomOf(event.target), "list");
});
byId("whole").addEventListener("click", () => {
  stage.call(behaviour.transform, zoomIdentity);
  mark("chosen", undefined);
});

const search = byId<HTMLInputElement>("search");
search.addEventListener("input", () => {
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  let found = 0;
  for (const row of rows) {
    const text = (row.textContent ?? "").toLowerCase();
    row.hidden = !words.every((word) => text.includes(word));
    shapes.get(row.dataset.room!)?.classList.toggle("dimmed", row.hidden);
    if (!row.hidden) ++found;
  }
  byId("found").textContent = words.length > 0 ? plural(found, "room") : "";
});

/** Numbers by size, texts as people sort them. */
function compare(a: HTMLTableRowElement, b: HTMLTableRowElement, column: number): number {
  const [p, q] = [a.cells[column], b.cells[column]];
  if (p.dataset.value !== undefined) return Number(p.dataset.value) - Number(q.dataset.value);
  return (p.textContent ?? "").localeCompare(q.textContent ?? "", "en", { numeric: true });
}

for (const heading of table.tHead!.rows[0].cells) {
  heading.querySelector("button")?.addEventListener("click", () => {
    const down = heading.getAttribute("aria-sort") === "ascending";
    for (const other of table.tHead!.rows[0].cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", down ? "descending" : "ascending");
    const sign = down ? -1 : 1;
    body.append(...rows.slice().sort((a, b) => sign * compare(a, b, heading.cellIndex)));
  });
}

document.documentElement.dataset.ready = "";

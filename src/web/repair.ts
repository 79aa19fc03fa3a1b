// The page of a repair: reads its data and connects its parts.

import { Box, extent } from "./box";
import { connectTabs, connectView } from "./controls";
import { byId, element, plural } from "./dom";
import { isOnePlace, markerAt } from "./markers";
import { connectPrinting } from "./printing";
import { faceKinds, fates, isInside, Item, readRepair, RepairData } from "./repair_data";
import { ItemList, Order } from "./repair_list";
import { Side, Stage } from "./repair_stage";
import { View } from "./view";

const isNarrow = matchMedia("(max-width: 860px)");
const fromPointer = 16; // pixels
const quiet = new Set(["merge", "dissolve"]); // that nobody sees: marked only where nothing else is listed

const bySize: Order = { title: "large ones", compare: (a, b) => (b.size ?? 0) - (a.size ?? 0) || a.number - b.number };
const byNumber: Order = { title: "low numbers", compare: (a, b) => a.number - b.number };
const byArea: Order = {
  title: "what changes most", compare: (a, b) => (b.area ?? 0) - (a.area ?? 0) || bySize.compare(a, b),
};

function showHead({ content }: RepairData): void {
  byId("title").textContent = document.title;
  byId("facts").textContent = content.line;
  const panel = byId("tolerances-panel");
  const list = element("ul", { class: "items" });
  for (const tolerance of content.tolerances.split(", ")) list.append(element("li", {}, tolerance));
  panel.append(list);
  for (const reason of content.reasons) panel.append(element("p", { class: "reason" }, reason));
  if (content.anchored > 0) panel.append(element("p", {}, `${plural(content.anchored, "segment")} anchored`));
}

/// Hides what the drawing has none of.
function showLegend({ lines, faces }: RepairData): void {
  for (const fate of fates) byId(`key-${fate}`).hidden = lines[fate].length === 0;
  for (const kind of faceKinds)
    byId(`key-face-${kind}`).hidden = !faces.some(({ item }) => item.kind === kind);
}

/// The part of the drawing around an item, so wide that what was done can be seen.
function boxAround(item: Item, data: RepairData): Box {
  const whole = extent(data.box);
  const least = item.size ? whole * 1e-9 : whole / 40;
  const half = Math.min(Math.max(8 * (item.size ?? 0), least), whole);
  const [x, y] = data.local(item.where.nearest);
  return { left: x - half, right: x + half, top: y - half, bottom: y + half };
}

function widened({ left, right, top, bottom }: Box): Box {
  const room = 0.3 * Math.max(right - left, bottom - top);
  return { left: left - room, right: right + room, top: top - room, bottom: bottom + room };
}

function connectLists(data: RepairData, view: View, stage: Stage): ItemList[] {
  const { edits, refused, faces } = data.content;
  const lists = [
    new ItemList(byId("edits-panel"), edits, "Nothing to repair.", [byArea, bySize, byNumber]),
    new ItemList(byId("refused-panel"), refused, "Nothing was refused.", [byNumber, bySize]),
    new ItemList(byId("faces-panel"), faces, "No room changed.", [byNumber, byArea]),
  ];
  const open = () => lists.find(({ panel }) => !panel.hidden);
  const show = () => {
    const items = open()?.filtered ?? [];
    const moving = items.filter(({ kind }) => !quiet.has(kind));
    stage.setItems(moving.length > 0 ? moving : items);
  };
  lists.forEach((list, i) => {
    list.onFilter = show;
    list.onChoose = (item) => {
      const face = i === 2 && item ? data.faces[item.number - 1] : undefined;
      stage.choose(item, i === 0 && item ? item.number - 1 : undefined, face);
      if (!item) return;
      view.show(face ? widened(face.box) : boxAround(item, data));
      if (isNarrow.matches) view.stage.scrollIntoView();
    };
  });
  for (const tab of document.querySelectorAll('[role="tab"]')) tab.addEventListener("click", show);
  view.stage.addEventListener("keydown", (event) => {
    if (event.key === "n") open()?.step(1);
    if (event.key === "p") open()?.step(-1);
    if (event.key === "Escape") open()?.choose(undefined);
  });
  view.stage.setAttribute(
    "aria-label",
    `The drawing with ${plural(edits.length, "edit")}. Arrow keys pan, + and - zoom, 0 shows all, n and p go through the list.`,
  );
  show();
  return lists;
}

/// What is under the pointer: items, or faces; a click chooses.
function connectPointer(data: RepairData, view: View, stage: Stage, lists: ItemList[]): void {
  const tip = byId("tip");
  const at = (event: MouseEvent): [number, number] => {
    const box = view.stage.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const clear = () => (tip.hidden = true);
  view.stage.addEventListener("pointermove", (event) => {
    if (event.buttons !== 0) return;
    const [px, py] = at(event);
    const [x, y] = view.transform.invert([px, py]);
    byId("readout").textContent = data.place(x, y).map((c) => c.toPrecision(8)).join(", ");
    const marker = markerAt(stage.markers, px, py);
    view.stage.classList.toggle("pointing", !!marker);
    const texts = marker
      ? marker.findings.slice(0, 4).map((item) => `${item.number}. ${item.title ?? item.kind}${item.message ? `: ${item.message}` : ""}`)
      : data.faces.filter((face) => stage.isShown(face) && isInside(face, x, y)).map(({ item }) => item.title!);
    if (marker && marker.findings.length > 4) texts.push(`and ${marker.findings.length - 4} more`);
    tip.replaceChildren(...texts.map((text) => element("p", {}, text)));
    tip.hidden = texts.length === 0;
    const right = px + fromPointer + tip.offsetWidth < view.width;
    tip.style.transform = `translate(${right ? px + fromPointer : Math.max(4, px - fromPointer - tip.offsetWidth)}px, ${py + fromPointer}px)`;
  });
  view.stage.addEventListener("pointerleave", clear);
  view.onMove((moving) => moving && clear());
  view.stage.addEventListener("click", (event) => {
    const marker = markerAt(stage.markers, ...at(event));
    if (!marker) return;
    if (isOnePlace(marker, view)) lists.find(({ panel }) => !panel.hidden)?.choose(marker.findings[0]);
    else view.show(widened(marker.box));
  });
}

function connectSides(stage: Stage): void {
  for (const radio of document.querySelectorAll<HTMLInputElement>('input[name="side"]'))
    radio.addEventListener("change", () => {
      stage.side = radio.value as Side;
      stage.refresh();
    });
  const marks = byId<HTMLInputElement>("marks");
  marks.addEventListener("change", () => {
    stage.showMarks = marks.checked;
    stage.refresh();
  });
}

async function start(): Promise<void> {
  const data = await readRepair(byId("report").textContent!, byId("arrays").textContent!);
  showHead(data);
  showLegend(data);
  for (const name of ["edits", "refused", "faces"] as const) byId(`${name}-tab`).append(` ${data.content[name].length}`);
  connectTabs();
  const view = new View(byId("stage"), data.box);
  const stage = new Stage(byId<HTMLCanvasElement>("lines"), view, data);
  connectView(view);
  connectSides(stage);
  const lists = connectLists(data, view, stage);
  connectPointer(data, view, stage, lists);
  connectPrinting((isPrinting) => {
    for (const list of lists) list.setPrinting(isPrinting);
    stage.recolour();
  });
  stage.draw();
  Object.assign(window, { plumbline: { view, stage, data } }); // for tests, and for the curious
  document.documentElement.dataset.ready = "yes";
}

start().catch((error: unknown) => {
  byId("facts").textContent = `No picture: ${error instanceof Error ? error.message : String(error)}.`;
  throw error;
});

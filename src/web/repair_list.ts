// A list of edits, refusals or faces: to search, to filter by kind, to sort, to click through.

import { count, element, number } from "./dom";
import type { Item } from "./repair_data";

const chunk = 200; // items added at a time
const mostEdits = 12; // named of a room

export interface Order {
  title: string;
  compare: (a: Item, b: Item) => number;
}

export class ItemList {
  onFilter: () => void = () => {};
  onChoose: (item: Item | undefined) => void = () => {};
  private readonly hidden = new Set<string>();
  private shown: Item[] = [];
  private chosen?: Item;
  private isPrinting = false;
  private readonly search = element("input", { type: "search", class: "search" });
  private readonly sorting = element("select");
  private readonly total = element("p", { class: "quiet total", role: "status" });
  private readonly list = element("ol", { class: "list" });
  private readonly more = element("div", { class: "quiet more-items" }, "more …");

  constructor(
    readonly panel: HTMLElement,
    readonly all: Item[],
    private readonly none: string,
    private readonly orders: Order[],
  ) {
    this.search.placeholder = "Search rooms, layers, elements, places";
    this.search.ariaLabel = "Search";
    orders.forEach(({ title }, i) => this.sorting.append(element("option", { value: String(i) }, title)));
    const chips = element("div", { role: "group", "aria-label": "Filter by kind" });
    const controls = element(
      "div", { class: "controls" }, this.search,
      element("label", { class: "choice" }, "first ", this.sorting),
      element("div", { class: "filter" }, element("span", {}, "kind"), chips),
    );
    controls.hidden = all.length === 0;
    panel.append(controls, this.total, this.list, this.more);
    this.addChips(chips);
    this.search.addEventListener("input", () => this.filter());
    this.sorting.addEventListener("change", () => this.filter());
    new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting)) this.add(chunk);
    }).observe(this.more);
    this.filter();
  }

  get filtered(): Item[] {
    return this.shown;
  }

  /// The next one, or the one before.
  step(by: 1 | -1): void {
    if (this.shown.length === 0) return;
    const now = this.chosen ? this.shown.indexOf(this.chosen) : by > 0 ? -1 : 0;
    this.choose(this.shown[(now + by + this.shown.length) % this.shown.length]);
  }

  choose(item: Item | undefined): void {
    const before = this.chosen;
    this.chosen = item;
    if (before) this.nodeOf(before)?.replaceWith(this.make(before));
    if (item) {
      this.add(this.shown.indexOf(item) + 1 - this.list.childElementCount);
      const node = this.make(item);
      const old = this.nodeOf(item);
      const hadFocus = !!old?.contains(document.activeElement);
      old?.replaceWith(node);
      if (hadFocus) node.querySelector("button")!.focus({ preventScroll: true });
      node.scrollIntoView({ block: "nearest" });
    }
    this.onChoose(item);
  }

  /// For print: all items.
  setPrinting(isPrinting: boolean): void {
    if (this.isPrinting === isPrinting) return;
    this.isPrinting = isPrinting;
    this.list.replaceChildren();
    this.add(isPrinting ? this.shown.length : chunk);
  }

  private addChips(row: HTMLElement): void {
    const counts = new Map<string, number>();
    for (const { kind } of this.all) counts.set(kind, (counts.get(kind) ?? 0) + 1);
    for (const [kind, n] of counts) {
      const chip = element("button", { class: "chip", type: "button", "aria-pressed": "true" }, kind, element("span", {}, count(n)));
      chip.dataset.value = kind;
      chip.addEventListener("click", () => {
        const isHidden = this.hidden.delete(kind) ? false : !!this.hidden.add(kind);
        chip.setAttribute("aria-pressed", String(!isHidden));
        this.filter();
      });
      row.append(chip);
    }
  }

  private filter(): void {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    this.shown = this.all.filter((item) => {
      if (this.hidden.has(item.kind)) return false;
      const text = [item.number, item.kind, item.title, item.message, item.at, item.element, ...(item.elements ?? [])]
        .join(" ").toLowerCase();
      return words.every((word) => text.includes(word));
    });
    this.shown.sort(this.orders[Number(this.sorting.value)].compare);
    if (this.chosen && !this.shown.includes(this.chosen)) this.choose(undefined);
    this.list.replaceChildren();
    this.add(chunk);
    const [all, some] = [this.all.length, this.shown.length];
    this.total.textContent = all === 0 ? this.none : some === all ? `${count(all)} in all` : `${count(some)} of ${count(all)}`;
    this.onFilter();
  }

  private add(most: number): void {
    const first = this.list.childElementCount;
    this.list.append(...this.shown.slice(first, first + Math.max(most, 0)).map((item) => this.make(item)));
    this.more.hidden = this.list.childElementCount >= this.shown.length;
  }

  private nodeOf(item: Item): Element | null {
    return this.list.querySelector(`[data-number="${item.number}"]`);
  }

  private make(item: Item): HTMLElement {
    const isOpen = item === this.chosen;
    const size = item.size ? number(item.size) : "";
    const head = element(
      "button",
      { type: "button", class: "item-head", "aria-expanded": String(isOpen) },
      element("span", { class: "badge" }, String(item.number)),
      element("span", { class: "what" }, item.title ?? item.kind),
      element("span", { class: "size" }, size),
      element("span", { class: "message" }, [item.at, item.element].filter(Boolean).join(" · ")),
      item.message && element("span", { class: "message rooms" }, item.message),
      item.edits && item.edits.length > 0 && element("span", { class: "message" }, `by edit ${item.edits.slice(0, mostEdits).join(", ")}${item.edits.length > mostEdits ? ", …" : ""}`),
    );
    head.addEventListener("click", () => this.choose(isOpen ? undefined : item));
    const node = element("li", { class: isOpen ? "open" : "" }, head, isOpen && details(item));
    node.dataset.number = String(item.number);
    return node;
  }
}

function details(item: Item): HTMLElement {
  const list = element("dl", { class: "details" });
  const add = (term: string, ...values: (string | Node | undefined | false)[]) => {
    if (values.some(Boolean)) list.append(element("dt", {}, term), element("dd", {}, ...values));
  };
  add("x", element("code", {}, item.where.exact[0]));
  add("y", element("code", {}, item.where.exact[1]));
  add("size", !!item.size && number(item.size, 12));
  add("its square", !!item.size && element("code", {}, item.squared_size!));
  add("area", item.area ? number(item.area, 12) : undefined);
  if (item.elements && item.elements.length > 0) {
    const elements = element("ul");
    for (const text of item.elements) elements.append(element("li", {}, text));
    add("from", elements);
  }
  return list;
}

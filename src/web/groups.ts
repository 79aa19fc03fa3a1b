// The groups of findings, what changes most first; the chosen one is shown in the picture, and its
// findings are those of the list.

import type { Box } from "./box";
import { byId, count, element, number } from "./dom";
import type { Drawing } from "./drawing";
import type { Group } from "./report";

const chunk = 100; // items added at a time

export class GroupList {
  onChoose: (group: Group | undefined) => void = () => {};
  private chosen?: Group;
  private readonly list = byId("group-list");
  private readonly more = byId("group-more");

  constructor(private readonly drawing: Drawing) {
    const { groups } = drawing.report;
    byId("group-total").textContent =
      groups.length === 0 ? "Nothing differs." : `${count(groups.length)} in all, what changes most first`;
    new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting)) this.addItems(chunk);
    }).observe(this.more);
    this.addItems(chunk);
  }

  get isChosen(): boolean {
    return this.chosen !== undefined;
  }

  /// All of them, for print.
  showAll(): void {
    this.addItems(this.drawing.report.groups.length);
  }

  choose(group: Group | undefined): void {
    const before = this.chosen;
    this.chosen = group;
    for (const changed of [before, group]) if (changed) this.item(changed)?.replaceWith(this.makeItem(changed));
    this.onChoose(group);
  }

  private addItems(number: number): void {
    const { groups } = this.drawing.report;
    const first = this.list.childElementCount;
    for (const group of groups.slice(first, first + number)) this.list.append(this.makeItem(group));
    this.more.hidden = this.list.childElementCount >= groups.length;
  }

  private item(group: Group): Element | null {
    return this.list.querySelector(`[data-number="${group.number}"]`);
  }

  private makeItem(group: Group): HTMLElement {
    const isOpen = group === this.chosen;
    const [what, ...rest] = group.message.split("; ");
    const head = element(
      "button",
      { type: "button", class: "finding-head", "aria-expanded": String(isOpen) },
      element("span", { class: "badge" }, String(group.number)),
      element("span", { class: "what" }, what.replace(/ \([^)]*\)/g, "")),
      element("span", { class: "message" }, rest.join("; ")),
    );
    head.addEventListener("click", () => this.choose(isOpen ? undefined : group));
    const item = element("li", { class: isOpen ? "open" : "" }, head, isOpen && this.details(group));
    item.dataset.number = String(group.number);
    return item;
  }

  private details(group: Group): HTMLElement {
    const list = element("dl", { class: "details" });
    const add = (term: string, ...values: (string | Node)[]) =>
      list.append(element("dt", {}, term), element("dd", {}, ...values));
    const findings = element("button", { type: "button", class: "show" }, `its ${count(group.findings.length)} in the list of findings`);
    findings.addEventListener("click", () => {
      byId("findings-tab").click();
      byId("findings-panel").scrollTop = 0;
    });
    add("findings", findings);
    if (group.where) add("place", group.where.nearest.map(String).join(", "));
    if (group.faces.length > 0) {
      const faces = element("ul");
      const most = 12;
      for (const { change, areas } of group.faces.slice(0, most))
        faces.append(element("li", {}, `${change}: ${areasText(areas)}`));
      if (group.faces.length > most) faces.append(element("li", {}, `${count(group.faces.length - most)} more`));
      add("faces", faces);
    }
    const sources = element("ul");
    for (const source of group.sources.slice(0, 8)) sources.append(element("li", {}, this.drawing.sourceText(source)));
    if (group.sources.length > 0) add("from", sources);
    return list;
  }
}

function areasText(areas: number[]): string {
  const largest = [...areas].sort((a, b) => b - a).slice(0, 4).map((area) => number(area, 4));
  const more = areas.length - largest.length;
  return (largest.join(", ") || "area unknown") + (more > 0 ? ` and ${more} more` : "");
}

/// The part of the drawing to look at.
export function boxOfGroup(group: Group, drawing: Drawing): Box {
  const corners = [drawing.local(group.low), drawing.local(group.high)];
  const xs = corners.map(([x]) => x), ys = corners.map(([, y]) => y);
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const half = Math.max(right - left, bottom - top, 4 * drawing.report.tolerance) * 0.75;
  const [cx, cy] = [(left + right) / 2, (top + bottom) / 2];
  return { left: cx - half, right: cx + half, top: cy - half, bottom: cy + half };
}

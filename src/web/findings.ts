// The list of findings, with filters by kind and by stage; the chosen one shows all that is known.

import { byId, count, element, number } from "./dom";
import type { Drawing } from "./drawing";
import type { Finding, Group } from "./report";

const chunk = 200; // items added at a time
export const noStage = "not attributed";

export const stageOf = (finding: Finding): string => finding.cause?.stage ?? noStage;

export type Comparison = "float" | "doubles";

export class FindingList {
  onFilter: () => void = () => {};
  onChoose: (finding: Finding | undefined) => void = () => {};
  onLeaveGroup: () => void = () => {};
  comparison: Comparison = "float";
  private readonly hiddenKinds = new Set<string>();
  private readonly hiddenStages = new Set<string>();
  private shown: Finding[] = [];
  private chosen?: Finding;
  private group?: Set<number>; // numbers of the findings of the chosen group
  private isPrinting = false;
  private readonly list = byId("finding-list");
  private readonly more = byId("finding-more");
  private readonly total = byId("finding-total");

  constructor(private readonly drawing: Drawing) {
    new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting)) this.addItems(chunk);
    }).observe(this.more);
    byId("group-chip").addEventListener("click", () => this.onLeaveGroup());
    this.setComparison("float");
  }

  /// Shows the findings of this group alone.
  setGroup(group: Group | undefined): void {
    if (group && this.comparison !== "float") this.setComparison("float");
    this.group = group && new Set(group.findings);
    byId("group-filter").hidden = !group;
    byId("group-chip").textContent = group ? `${group.number} \u00d7` : "";
    this.choose(undefined);
    this.filter();
  }

  get filtered(): Finding[] {
    return this.shown;
  }

  get all(): Finding[] {
    const { findings, conversion } = this.drawing.report;
    return this.comparison === "float" ? findings : conversion;
  }

  setComparison(comparison: Comparison): void {
    this.comparison = comparison;
    this.hiddenKinds.clear();
    this.hiddenStages.clear();
    this.chips(byId("kind-filter"), this.hiddenKinds, (finding) => finding.kind);
    this.chips(byId("stage-filter"), this.hiddenStages, stageOf);
    this.choose(undefined);
    this.filter();
  }

  /// The next one of the list, or the one before.
  step(by: 1 | -1): void {
    if (this.shown.length === 0) return;
    const now = this.chosen ? this.shown.indexOf(this.chosen) : by > 0 ? -1 : 0;
    this.choose(this.shown[(now + by + this.shown.length) % this.shown.length]);
  }

  choose(finding: Finding | undefined): void {
    this.item(this.chosen)?.replaceWith(this.makeItem(this.chosen!, false));
    this.chosen = finding;
    if (finding) {
      this.addItems(this.shown.indexOf(finding) + 1 - this.list.childElementCount);
      const item = this.makeItem(finding, true);
      this.item(finding)?.replaceWith(item);
      item.scrollIntoView({ block: "nearest" });
    }
    this.onChoose(finding);
  }

  /// For print: all items, with all that is known of each.
  setPrinting(isPrinting: boolean): void {
    if (this.isPrinting === isPrinting) return;
    this.isPrinting = isPrinting;
    this.list.replaceChildren();
    this.addItems(isPrinting ? this.shown.length : chunk);
  }

  private filter(): void {
    this.shown = this.all.filter(
      (f) =>
        !this.hiddenKinds.has(f.kind) &&
        !this.hiddenStages.has(stageOf(f)) &&
        (!this.group || this.comparison !== "float" || this.group.has(f.number)),
    );
    this.list.replaceChildren();
    this.addItems(chunk);
    const all = this.all.length;
    this.total.textContent =
      all === 0
        ? "No finding: every cell matches one to one."
        : this.shown.length === all
          ? `${count(all)} in all`
          : `${count(this.shown.length)} of ${count(all)}`;
    this.onFilter();
  }

  private addItems(number: number): void {
    const first = this.list.childElementCount;
    for (const finding of this.shown.slice(first, first + Math.max(number, 0)))
      this.list.append(this.makeItem(finding, this.isPrinting || finding === this.chosen));
    this.more.hidden = this.list.childElementCount >= this.shown.length;
  }

  private item(finding: Finding | undefined): Element | null {
    return finding ? this.list.querySelector(`[data-number="${finding.number}"]`) : null;
  }

  private chips(row: HTMLElement, hidden: Set<string>, group: (finding: Finding) => string): void {
    const counts = new Map<string, number>();
    for (const finding of this.all) counts.set(group(finding), (counts.get(group(finding)) ?? 0) + 1);
    row.parentElement!.hidden = counts.size === 0;
    row.replaceChildren();
    for (const [name, n] of counts) {
      const chip = element("button", { class: "chip", type: "button", "aria-pressed": "true" }, name, element("span", {}, count(n)));
      chip.dataset.value = name;
      chip.addEventListener("click", () => {
        const isHidden = hidden.delete(name) ? false : !!hidden.add(name);
        chip.setAttribute("aria-pressed", String(!isHidden));
        this.filter();
      });
      row.append(chip);
    }
  }

  private makeItem(finding: Finding, open: boolean): HTMLElement {
    const head = element(
      "button",
      { type: "button", class: "finding-head", "aria-expanded": String(open) },
      element("span", { class: "badge" }, String(finding.number)),
      element("span", { class: "what" }, `${finding.kind} ${finding.disagreement}`),
      finding.cause && element("span", { class: "stage" }, finding.cause.stage),
      element("span", { class: "message" }, finding.message),
    );
    head.addEventListener("click", () => this.choose(open ? undefined : finding));
    const item = element("li", { class: open ? "open" : "" }, head, open && this.details(finding));
    item.dataset.number = String(finding.number);
    return item;
  }

  private details(finding: Finding): HTMLElement {
    const list = element("dl", { class: "details" });
    const add = (term: string, ...values: (string | Node | null | undefined | false)[]) => {
      if (values.some(Boolean)) list.append(element("dt", {}, term), element("dd", {}, ...values));
    };
    const { where, cause } = finding;
    if (where) {
      add("place", where.nearest.map(String).join(", "));
      add("exact x", element("code", {}, where.exact[0]));
      add("exact y", element("code", {}, where.exact[1]));
    }
    if (finding.distance !== null) add("distance", number(finding.distance, 12));
    add("its square", finding.squared_distance && element("code", {}, finding.squared_distance.exact));
    if (finding.area)
      add("area", number(finding.area.nearest, 12), " = ", element("code", {}, finding.area.exact));
    add("invariant", finding.invariant);
    add("exact cells", this.cells(finding, finding.exact_cells));
    add(`${this.comparison} cells`, this.cells(finding, finding.float_cells));
    if (cause) {
      const round = cause.round ? `, round ${cause.round}` : "";
      add("stage", `${cause.stage}${round}`, cause.confirmed && element("span", { class: "confirmed", title: "With this one stage made exact, the finding disappears" }, "confirmed"));
      add("rule", cause.rule);
      add("cause", cause.explanation);
      add("advice", cause.advice && element("em", {}, cause.advice));
    }
    const sources = element("ul");
    for (const source of finding.sources) sources.append(element("li", {}, this.drawing.sourceText(source)));
    add("from", finding.sources.length > 0 && sources);
    return list;
  }

  private cells(finding: Finding, cells: number[]): string {
    if (cells.length === 0) return "none";
    const most = 24;
    const names = cells.slice(0, most).join(", ") + (cells.length > most ? ", …" : "");
    return `${finding.kind === "hole" ? "cycle" : finding.kind} ${names}`;
  }
}

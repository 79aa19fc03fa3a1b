// What was read: files, what was rejected, which numbers were replaced.

import { element, plural } from "./dom";
import { describeSource, Drawing } from "./drawing";

const mostItems = 500;

export function showInputs({ report }: Drawing, place: HTMLElement): void {
  const list = (title: string, items: string[]) => {
    if (items.length === 0) return;
    const ul = element("ul", { class: "items" });
    for (const item of items.slice(0, mostItems)) ul.append(element("li", {}, item));
    if (items.length > mostItems) ul.append(element("li", {}, `and ${items.length - mostItems} more`));
    place.append(element("h3", {}, title), ul);
  };
  list(plural(report.files.length, "file"), report.files);
  place.append(
    element("p", {}, report.exact
      ? "Every coordinate is exactly what the file says."
      : `${plural(report.ledger.length, "number")} had to be replaced on the way from the file to exact coordinates.`),
  );
  list("Exactness ledger", report.ledger.map((item) => `${describeSource(item, report.files)}: ${item.what}, by at most ${item.bound}`));
  list(`${plural(report.rejected.length, "item")} rejected`, report.rejected.map((item) => {
    const text = item.text ? ` “${item.text}”` : "";
    return `${describeSource(item, report.files)}: ${item.reason}${text}`;
  }));
  list(plural(report.remarks.length, "remark"), report.remarks.map((item) => {
    const text = item.text ? ` “${item.text}”` : "";
    return `${describeSource(item, report.files)}: ${item.what}${text}`;
  }));
}

// The head of the page and the three answers side by side.

import { count, element, number, plural } from "./dom";
import type { Drawing } from "./drawing";
import { ComplexName, complexNames, CountName, Report } from "./report";
import { complexTitle, answerTitle } from "./titles";

const rows: [CountName, string][] = [
  ["vertices", "vertices"],
  ["edges", "edges"],
  ["faces", "faces"],
  ["holes", "holes"],
  ["depth", "nesting depth"],
  ["components", "components"],
  ["antennas", "antennas"],
  ["isolated_vertices", "isolated vertices"],
];

const originOfRadius = {
  larlib: " (larlib: 0.001 on the unit square)", plasm: " (plasm: 1e-8)", drawing: " (the engine's default)",
  segment: " (a quarter of the shortest segment)", number: "",
};

export function showHead(
  report: Report, title: HTMLElement, verdict: HTMLElement, facts: HTMLElement, advice: HTMLElement,
): void {
  title.textContent = report.files.join(", ") || "drawing";
  const agrees = report.verdict === "agree";
  const groups = report.findings.length > 1 ? ` in ${plural(report.groups.length, "group")}` : "";
  const findings = plural(report.findings.length, "finding") + groups;
  const own = report.drift.findings;
  if (agrees) verdict.textContent = "Agree";
  else if (own === report.findings.length) verdict.textContent = `Agree but for the file's own drift: ${findings}`;
  else verdict.textContent = `Disagree: ${findings}${own > 0 ? `, ${own} of them the file's own drift` : ""}`;
  if (report.lost > 0) verdict.textContent += `; not all was read: ${report.lost} rejected look like geometry`;
  verdict.className = agrees && report.lost === 0 ? "agree" : "disagree";
  const parts = [answerTitle(report)];
  if (report.compared === "graph") parts.push("vertices and edges alone are compared: the result has no faces");
  if (report.compared === "faces" && report.left_out.edges > 0)
    parts.push(`the result has polygons alone: ${plural(report.left_out.edges, "edge")} with the same face on both sides not compared`);
  if (report.compared === "some faces") parts.push("each face of the result is compared, and nothing else");
  if (report.radius !== null) parts.push(`radius ${number(report.radius)}${originOfRadius[report.radius_from ?? "number"]}`);
  if (report.tolerance !== report.radius) parts.push(`tolerance ${number(report.tolerance)}`);
  facts.textContent = parts.join(" · ");
  advice.textContent = radiusAdvice(report);
}

/// What to do, where the engine merges within a radius.
function radiusAdvice(report: Report): string {
  const sentences: string[] = [];
  if (report.crowded_vertices > 0)
    sentences.push(
      `The radius is larger than details of the drawing: ${count(report.crowded_vertices)} of its ` +
        `${count(report.counts.exact.vertices)} vertices are nearer to another one.`,
    );
  const [least, largest] = report.right_radii ?? [];
  if (least !== undefined && largest !== undefined)
    sentences.push(
      `Right is --radius ${report.advised_radius ?? largest}, and all that were tried ` +
        `from ${number(least)} to ${number(largest)}.`,
    );
  else if (report.tried_radii.length > 0) sentences.push("No radius that was tried is right.");
  return sentences.join(" ");
}

const namesOfGraph: CountName[] = ["vertices", "edges", "components"];

const countsOf = (report: Report, name: ComplexName) =>
  report.counts[name === "authored" ? "exact" : name];

function totalArea(drawing: Drawing, name: ComplexName): number {
  return drawing.complexes[name].area.reduce((sum, area) => sum + area, 0);
}

export function showAnswers(drawing: Drawing, table: HTMLTableElement): void {
  const { report } = drawing;
  const head = element("tr", {}, element("td"));
  for (const name of complexNames)
    head.append(element("th", { scope: "col" }, element("span", { class: `swatch ${name}` }), complexTitle[name]));
  const body = element("tbody");
  const addRow = (title: string, texts: string[], isOfGraph = false) => {
    if (report.compared === "graph" && !isOfGraph) texts[texts.length - 1] = "\u2013";
    const row = element("tr", {}, element("th", { scope: "row" }, title));
    texts.forEach((text, i) =>
      row.append(element("td", { class: i > 0 && text !== texts[0] ? "differs" : "" }, text)),
    );
    body.append(row);
  };
  for (const [name, title] of rows) {
    const values = complexNames.map((complex) => countsOf(report, complex)[name]);
    if (name === "isolated_vertices" && values.every((value) => value === 0)) continue;
    addRow(title, values.map(count), namesOfGraph.includes(name));
  }
  addRow("area of all faces", complexNames.map((name) => number(totalArea(drawing, name), 7)));
  const conversionValid = report.conversion.every((finding) => finding.disagreement !== "invalid");
  addRow("valid complex", ["yes", conversionValid ? "yes" : "no", report.float_valid ? "yes" : "no"], true);
  table.append(element("thead", {}, head), body);
}

// The tolerance ladder: how the numbers of cells fall as the radius grows, as steps over the
// logarithm of the radius, and as a table.

import { axisBottom, axisLeft } from "d3-axis";
import { scaleLinear, scaleLog } from "d3-scale";
import { select } from "d3-selection";
import { count, element, number } from "./dom";
import type { Ladder, LadderStep, Report } from "./report";

const size = { width: 372, height: 230, left: 46, right: 12, top: 12, bottom: 36 };
const series = ["edges", "vertices", "faces"] as const;
const rowsAtOnce = 100;

export function showLadder(report: Report, place: HTMLElement, goTo: (step: LadderStep) => void): void {
  const { ladder } = report;
  if (!ladder || ladder.steps.length === 0) {
    place.append(element("p", { class: "quiet" }, ladder ? "No critical radius: nothing falls together." : "This report has no tolerance ladder."));
    return;
  }
  place.append(
    element("p", { class: "quiet" }, "Numbers of cells of the exact complex when all within the radius is merged."),
    plot(report, ladder),
    legend(),
    table(ladder, goTo),
  );
  if (report.tried_radii.length > 0) {
    const right = report.right_radii;
    place.append(element("p", { class: "quiet" }, right
      ? `The float result is right for every radius tried from ${number(right[0])} to ${number(right[1])} (filled dots).`
      : "The float result was wrong for every radius tried (empty dots)."));
  }
  if (!ladder.complete) place.append(element("p", { class: "quiet" }, "The ladder goes on beyond its last step."));
}

function plot(report: Report, ladder: Ladder): SVGElement {
  const { width, height } = size;
  const radii = ladder.steps.map((step) => step.radius).filter((radius) => radius > 0);
  const all = report.radius ? [...radii, report.radius] : radii;
  const first = Math.min(...all) / 3;
  const last = Math.max(...all) * 3;
  const x = scaleLog([first, last], [size.left, width - size.right]).clamp(true);
  const most = Math.max(ladder.vertices, ladder.edges, ladder.faces);
  const y = scaleLinear([0, most], [height - size.bottom, size.top]).nice(4);

  const svg = select(document.createElementNS("http://www.w3.org/2000/svg", "svg"))
    .attr("viewBox", `0 0 ${width} ${height}`)
    .attr("role", "img")
    .attr("aria-label", "Numbers of vertices, edges and faces over the radius; the table below has them");
  if (report.right_radii) {
    const [least, largest] = report.right_radii.map((radius) => x(Math.max(radius, first)));
    svg.append("rect").attr("class", "right-radii").attr("x", least).attr("y", size.top)
      .attr("width", Math.max(largest - least, 1)).attr("height", height - size.top - size.bottom)
      .append("title").text("radii for which the float result is right");
  }
  const decades = Math.ceil(Math.log10(last / first));
  svg.append("g").attr("transform", `translate(0,${height - size.bottom})`)
    .call(axisBottom(x).ticks(Math.min(decades, 6), "~e").tickSizeOuter(0));
  svg.append("g").attr("transform", `translate(${size.left},0)`)
    .call(axisLeft(y).ticks(4, "~s").tickSizeOuter(0))
    .call((g) => g.selectAll(".tick line").clone().attr("class", "grid").attr("x2", width - size.left - size.right));
  svg.append("text").attr("class", "axis-title").attr("x", (size.left + width) / 2)
    .attr("y", height - 4).attr("text-anchor", "middle").text("radius");
  for (const name of series) {
    let path = `M${x(first)},${y(ladder[name])}`;
    for (const step of ladder.steps) path += `H${x(Math.max(step.radius, first))}V${y(step[name])}`;
    svg.append("path").attr("class", `series ${name}`).attr("d", `${path}H${x(last)}`);
  }
  for (const { radius, right } of report.tried_radii)
    if (radius >= first && radius <= last)
      svg.append("circle").attr("class", right ? "tried right" : "tried").attr("cx", x(radius))
        .attr("cy", height - size.bottom).attr("r", 3)
        .append("title").text(`radius ${number(radius)}: ${right ? "right" : "wrong"}`);
  if (report.radius) {
    const at = x(report.radius);
    svg.append("line").attr("class", "radius").attr("x1", at).attr("x2", at)
      .attr("y1", size.top).attr("y2", height - size.bottom);
    const isRight = at > width / 2;
    svg.append("text").attr("class", "radius").attr("x", at + (isRight ? -5 : 5)).attr("y", size.top + 9)
      .attr("text-anchor", isRight ? "end" : "start").text(`radius ${number(report.radius, 4)}`);
  }
  return svg.node()!;
}

function legend(): HTMLElement {
  const row = element("p", { class: "legend" });
  for (const name of series) row.append(element("span", { class: `key ${name}` }), ` ${name} `);
  return row;
}

function table(ladder: Ladder, goTo: (step: LadderStep) => void): HTMLElement {
  const body = element("tbody");
  const rows: (LadderStep | null)[] = [null, ...ladder.steps];
  const more = element("button", { type: "button", class: "more" }, "Show more");
  const add = () => {
    const next = rows.slice(body.childElementCount, body.childElementCount + rowsAtOnce);
    for (const step of next) body.append(row(step, ladder, goTo));
    more.hidden = body.childElementCount >= rows.length;
  };
  more.addEventListener("click", add);
  add();
  const head = element("tr");
  for (const title of ["radius", "V", "E", "F", "what is near"])
    head.append(element("th", { scope: "col" }, title));
  return element("div", {}, element("table", { class: "numbers" }, element("thead", {}, head), body), more);
}

function row(step: LadderStep | null, ladder: Ladder, goTo: (step: LadderStep) => void): HTMLElement {
  const { vertices, edges, faces } = step ?? ladder;
  const near = element("td");
  if (step && step.vertex !== null) {
    const other = step.edge !== null ? `edge ${step.edge}` : `vertex ${step.other_vertex}`;
    const button = element("button", { type: "button", class: "link" }, `vertex ${step.vertex}, ${other}`);
    button.addEventListener("click", () => goTo(step));
    near.append(button);
  }
  return element(
    "tr",
    {},
    element("th", { scope: "row", title: step ? `squared: ${step.squared_radius}` : "" }, step ? number(step.radius) : "0"),
    ...[vertices, edges, faces].map((n) => element("td", {}, count(n))),
    near,
  );
}

// The page of a check: reads its data and connects its parts.

import { unpacked } from "./arrays";
import { connectLayers, connectTabs, connectView } from "./controls";
import { byId, element, plural } from "./dom";
import { Drawing } from "./drawing";
import { FindingList } from "./findings";
import { Hover } from "./hover";
import { showInputs } from "./inputs";
import { showLadder } from "./ladder";
import { boxOf, Overlay, Side } from "./overlay";
import { connectPrinting } from "./printing";
import type { Finding, LadderStep, Report } from "./report";
import { Scene } from "./scene";
import { showAnswers, showHead } from "./summary";
import { View } from "./view";

async function readReport(): Promise<Report> {
  return (await (await unpacked(byId("report").textContent!)).json()) as Report;
}

function connectFindings(drawing: Drawing, view: View, overlay: Overlay): FindingList {
  const list = new FindingList(drawing);
  const sidesOf = (finding: Finding): Side[] => [
    { complex: drawing.complexes[list.comparison], cells: finding.float_cells },
    { complex: drawing.complexes.authored, cells: finding.exact_cells },
  ];
  list.onFilter = (findings) => overlay.setFindings(findings);
  list.onChoose = (finding) => {
    overlay.chosen = finding && { finding, sides: sidesOf(finding) };
    if (finding) view.show(boxOf(finding, overlay.chosen!.sides, drawing));
    overlay.draw();
  };
  overlay.setFindings(list.all);
  view.stage.addEventListener("keydown", (event) => {
    if (event.key === "n") list.step(1);
    if (event.key === "p") list.step(-1);
    if (event.key === "Escape") list.choose(undefined);
  });
  connectComparison(drawing, list);
  return list;
}

function connectComparison({ report }: Drawing, list: FindingList): void {
  const choice = byId("comparison");
  choice.hidden = report.conversion.length === 0;
  for (const button of choice.querySelectorAll("button"))
    button.addEventListener("click", () => {
      for (const other of choice.querySelectorAll("button"))
        other.setAttribute("aria-pressed", String(other === button));
      list.setComparison(button.value as "float" | "doubles");
    });
}

/// The two cells of the exact complex that a step of the ladder joins.
function showStep(step: LadderStep, drawing: Drawing, view: View): void {
  const complex = drawing.complexes.authored;
  const [x, y] = [complex.x[step.vertex!], complex.y[step.vertex!]];
  const half = 3 * step.radius;
  view.show({ left: x - half, right: x + half, top: y - half, bottom: y + half });
}

async function start(): Promise<void> {
  const report = await readReport();
  showHead(report, byId("title"), byId("verdict"), byId("facts"));
  const drawing = await Drawing.read(report, byId("arrays").textContent!);
  showAnswers(drawing, byId<HTMLTableElement>("answers"));
  showInputs(drawing, byId("inputs-panel"));
  byId("findings-tab").append(` ${report.findings.length}`);

  const stage = byId("stage");
  const view = new View(stage, drawing.box);
  const scene = new Scene(byId<HTMLCanvasElement>("lines"), byId<HTMLCanvasElement>("below"), view, drawing);
  const overlay = new Overlay(byId<HTMLCanvasElement>("overlay"), view, drawing, scene);
  scene.onDraw = () => overlay.draw();
  connectLayers(scene, overlay);
  connectView(view);
  connectTabs();
  const list = connectFindings(drawing, view, overlay);
  showLadder(report, byId("ladder-panel"), (step) => showStep(step, drawing, view));
  new Hover(byId("tip"), view, drawing, scene, overlay, byId("readout"), (finding) => list.choose(finding));
  connectPrinting(() => list.showAll(), () => scene.recolour());
  stage.setAttribute("aria-label", `The drawing with ${plural(report.findings.length, "finding")}. Arrow keys pan, + and - zoom, 0 shows all, n and p go through the findings.`);
  scene.drawNow();
  document.documentElement.dataset.ready = "yes";
  Object.assign(window, { plumbline: { view, scene, drawing } }); // for tests, and for the curious
}

start().catch((error: unknown) => {
  byId("stage").replaceChildren(element("p", { class: "failure", role: "alert" }, `The page cannot show the drawing: ${error instanceof Error ? error.message : error}.`));
  throw error;
});

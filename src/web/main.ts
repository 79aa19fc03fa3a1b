// The page of a check: reads its data and connects its parts.

import { unpacked } from "./arrays";
import { connectLayers, connectTabs, connectView } from "./controls";
import { byId, element, plural } from "./dom";
import { Drawing } from "./drawing";
import { FindingList } from "./findings";
import { boxOfGroup, GroupList } from "./groups";
import { Hover } from "./hover";
import { showInputs } from "./inputs";
import { showLadder } from "./ladder";
import { boxOf, Overlay, Side } from "./overlay";
import { connectPrinting } from "./printing";
import type { Finding, Group, LadderStep, Report } from "./report";
import { Scene } from "./scene";
import { showAnswers, showHead } from "./summary";
import { View } from "./view";

const isNarrow = matchMedia("(max-width: 860px)");

async function readReport(): Promise<Report> {
  return (await (await unpacked(byId("report").textContent!)).json()) as Report;
}

/// The picture, and what in the rest of the page shows something of it.
function showPicture(drawing: Drawing, list: FindingList, groups: GroupList): { goTo: (step: LadderStep) => void; recolour: () => void } {
  const stage = byId("stage");
  const view = new View(stage, drawing.box);
  const scene = new Scene(byId<HTMLCanvasElement>("lines"), byId<HTMLCanvasElement>("below"), view, drawing);
  const overlay = new Overlay(byId<HTMLCanvasElement>("overlay"), view, drawing, scene);
  scene.onDraw = () => overlay.draw();
  connectLayers(scene, overlay);
  connectView(view);
  connectFindings(drawing, list, view, overlay);
  const markOfGroup = new Map(drawing.report.groups.map((group) => [markOf(group, drawing), group]));
  const showMarks = () =>
    overlay.setFindings(byId("groups-panel").hidden || groups.isChosen ? list.filtered : [...markOfGroup.keys()]);
  groups.onChoose = (group) => {
    list.setGroup(group);
    if (!group) return;
    view.show(boxOfGroup(group, drawing));
    if (isNarrow.matches) stage.scrollIntoView();
  };
  list.onFilter = showMarks;
  list.onLeaveGroup = () => groups.choose(undefined);
  for (const tab of document.querySelectorAll('[role="tab"]')) tab.addEventListener("click", showMarks);
  showMarks();
  new Hover(byId("tip"), view, drawing, scene, overlay, byId("readout"), (finding) => {
    const group = markOfGroup.get(finding);
    if (group) return groups.choose(group);
    byId("findings-tab").click();
    list.choose(finding);
  });
  scene.drawNow();
  Object.assign(window, { plumbline: { view, scene, drawing } }); // for tests, and for the curious
  return { goTo: (step) => showStep(step, drawing, view), recolour: () => scene.recolour() };
}

function connectFindings(drawing: Drawing, list: FindingList, view: View, overlay: Overlay): void {
  const sidesOf = (finding: Finding): Side[] => [
    { complex: drawing.complexes[list.comparison], cells: finding.float_cells },
    { complex: drawing.complexes.authored, cells: finding.exact_cells },
  ];
  list.onChoose = (finding) => {
    overlay.chosen = finding && { finding, sides: sidesOf(finding) };
    if (finding) view.show(boxOf(finding, overlay.chosen!.sides, drawing));
    overlay.draw();
  };
  view.stage.addEventListener("keydown", (event) => {
    if (event.key === "n" || event.key === "p") byId("findings-tab").click();
    if (event.key === "n") list.step(1);
    if (event.key === "p") list.step(-1);
    if (event.key === "Escape") list.onLeaveGroup();
    if (event.key === "Escape") list.choose(undefined);
  });
  const findings = plural(drawing.report.findings.length, "finding");
  view.stage.setAttribute(
    "aria-label",
    `The drawing with ${findings}. Arrow keys pan, + and - zoom, 0 shows all, n and p go through the findings.`,
  );
}

/// A group as what is marked on the stage.
function markOf(group: Group, { report }: Drawing): Finding {
  const lead = report.findings[group.lead - 1];
  return { ...lead, number: group.number, kind: "group", disagreement: "", message: group.message };
}

function connectComparison({ report }: Drawing, list: FindingList): void {
  const choice = byId("comparison");
  choice.hidden = report.conversion.length === 0;
  const buttons = [...choice.querySelectorAll("button")];
  for (const button of buttons)
    button.addEventListener("click", () => {
      for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
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

function showFailure(error: unknown): void {
  const reason = error instanceof Error ? error.message : String(error);
  for (const id of ["layers", "tools", "scale"]) byId(id).hidden = true;
  byId("stage").replaceChildren(element("p", { class: "failure", role: "alert" }, `No picture: ${reason}.`));
}

async function start(): Promise<void> {
  const report = await readReport();
  showHead(report, byId("title"), byId("verdict"), byId("facts"), byId("radius-advice"));
  const drawing = await Drawing.read(report, byId("arrays").textContent!);
  showAnswers(drawing, byId<HTMLTableElement>("answers"));
  showInputs(drawing, byId("inputs-panel"));
  byId("groups-tab").append(` ${report.groups.length}`);
  byId("findings-tab").append(` ${report.findings.length}`);
  connectTabs();
  // On a phone the picture needs the room.
  if (isNarrow.matches) byId("layers").querySelector("details")!.open = false;
  const list = new FindingList(drawing);
  const groups = new GroupList(drawing);
  connectComparison(drawing, list);
  let picture: ReturnType<typeof showPicture> | undefined;
  try {
    picture = showPicture(drawing, list, groups);
  } catch (error) {
    showFailure(error); // the rest of the page is there without it
  }
  showLadder(report, byId("ladder-panel"), (step) => picture?.goTo(step));
  connectPrinting((isPrinting) => {
    if (isPrinting) groups.showAll();
    list.setPrinting(isPrinting);
    picture?.recolour();
  });
  document.documentElement.dataset.ready = "yes";
}

start().catch((error: unknown) => {
  showFailure(error);
  throw error;
});

// What is under the pointer: a finding's marker, or a face with its area, depth, holes and sources.

import { element, number } from "./dom";
import type { Complex, Drawing } from "./drawing";
import { isOnePlace, Marker, markerAt } from "./markers";
import type { Overlay } from "./overlay";
import { faceAt } from "./picking";
import { ComplexName, complexNames, Finding } from "./report";
import type { Scene } from "./scene";
import { complexTitle } from "./titles";
import type { View } from "./view";

const shownSources = 4;
const shownFindings = 3;
const distanceFromPointer = 16;

export class Hover {
  private x = 0;
  private y = 0;
  private scheduled = false;

  constructor(
    private readonly tip: HTMLElement,
    private readonly view: View,
    private readonly drawing: Drawing,
    private readonly scene: Scene,
    private readonly overlay: Overlay,
    private readonly readout: HTMLElement,
    choose: (finding: Finding) => void,
  ) {
    const stage = view.stage;
    stage.addEventListener("pointermove", (event) => this.at(event));
    stage.addEventListener("pointerleave", () => this.clear());
    stage.addEventListener("pointerdown", () => this.clear());
    stage.addEventListener("click", (event) => {
      const marker = markerAt(overlay.markers, ...this.position(event));
      if (!marker) return;
      if (isOnePlace(marker, view)) choose(marker.findings[0]);
      else view.show(marker.box);
    });
    view.onMove((moving) => moving && this.clear());
  }

  private position(event: MouseEvent): [number, number] {
    const box = this.view.stage.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private at(event: PointerEvent): void {
    [this.x, this.y] = this.position(event);
    if (this.scheduled || event.buttons !== 0) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.show();
    });
  }

  private show(): void {
    const [u, v] = this.view.transform.invert([this.x, this.y]);
    this.readout.textContent = this.drawing.place(u, v).map((c) => this.coordinate(c)).join(", ");
    const marker = markerAt(this.overlay.markers, this.x, this.y);
    this.view.stage.classList.toggle("pointing", !!marker);
    const content = marker ? this.aboutFindings(marker) : this.aboutFaces(u, v);
    this.tip.replaceChildren(...content);
    this.tip.hidden = content.length === 0;
    if (content.length > 0) this.place();
  }

  /// As many digits as the view tells apart.
  private coordinate(value: number): string {
    const digits = Math.ceil(Math.log10(this.view.transform.k));
    return value.toFixed(Math.min(Math.max(digits, 0), 15));
  }

  private aboutFindings(marker: Marker): Node[] {
    this.setHovered(undefined);
    const { findings } = marker;
    if (!isOnePlace(marker, this.view))
      return [element("strong", {}, `${findings.length} findings`), element("p", {}, "Click to come nearer")];
    const nodes = findings.slice(0, shownFindings).flatMap((finding) => [
      element("strong", {}, `${finding.number}. ${finding.kind} ${finding.disagreement}`),
      element("p", {}, finding.message),
    ]);
    const more = findings.length - shownFindings;
    return more > 0 ? [...nodes, element("p", {}, `and ${more} more`)] : nodes;
  }

  private aboutFaces(u: number, v: number): Node[] {
    const shown = complexNames.filter((name) => this.scene.lines.has(name) || this.scene.faces === name);
    const apart = this.scene.size < 1;
    const names = apart ? shown.filter((name) => name === this.scene.faces) : shown;
    const found = names
      .map((name) => ({ name, face: this.faceAt(name, u, v) }))
      .filter(({ face }) => face > 0);
    const first = found[0];
    this.setHovered(first && !apart ? { complex: this.complex(first.name), face: first.face } : undefined);
    return found.flatMap(({ name, face }, i) => this.aboutFace(name, face, i === 0));
  }

  private faceAt(name: ComplexName, u: number, v: number): number {
    const { size } = this.scene;
    const complex = this.complex(name);
    return size < 1 ? faceAt(complex, u, v, size, this.scene.centres(name)) : faceAt(complex, u, v);
  }

  private complex(name: ComplexName): Complex {
    return this.drawing.complexes[name];
  }

  private aboutFace(name: ComplexName, face: number, withSources: boolean): Node[] {
    const complex = this.complex(name);
    const exactArea = name === "authored" ? this.drawing.report.page.exact_areas[face] : "";
    const holes = complex.cells.faceHoles.of(face).length;
    const rows: [string, string][] = [
      ["area", exactArea || `≈ ${number(complex.area[face], 12)}`],
      ["depth", String(complex.cells.faceDepth[face])],
      ["holes", String(holes)],
    ];
    const list = element("dl");
    for (const [term, value] of rows) list.append(element("dt", {}, term), element("dd", {}, value));
    const title = element("strong", {}, `Face ${face}`, element("span", { class: `swatch ${name}` }), complexTitle[name]);
    return withSources ? [title, list, this.sources(complex, face)] : [title, list];
  }

  private sources(complex: Complex, face: number): Node {
    const sources = this.drawing.sourcesOf(complex.segmentsAround(face));
    const list = element("ul");
    for (const source of sources.slice(0, shownSources))
      list.append(element("li", {}, this.drawing.sourceText(source, false)));
    if (sources.length > shownSources)
      list.append(element("li", {}, `and ${sources.length - shownSources} more`));
    return list;
  }

  private setHovered(hovered: { complex: Complex; face: number } | undefined): void {
    const before = this.overlay.hovered;
    if (before?.complex === hovered?.complex && before?.face === hovered?.face) return;
    this.overlay.hovered = hovered;
    this.overlay.draw();
  }

  private place(): void {
    const { width, height } = this.view;
    const box = this.tip.getBoundingClientRect();
    const right = this.x + distanceFromPointer + box.width < width;
    const below = this.y + distanceFromPointer + box.height < height;
    const x = right ? this.x + distanceFromPointer : this.x - distanceFromPointer - box.width;
    const y = below ? this.y + distanceFromPointer : this.y - distanceFromPointer - box.height;
    this.tip.style.transform = `translate(${Math.max(x, 4)}px, ${Math.max(y, 4)}px)`;
  }

  private clear(): void {
    this.tip.hidden = true;
    this.setHovered(undefined);
  }
}

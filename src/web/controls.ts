// Layers, faces, the slider that pulls faces apart, buttons of the view, tabs.

import { byId } from "./dom";
import type { Overlay } from "./overlay";
import { ComplexName, complexNames } from "./report";
import type { LineName, Scene } from "./scene";
import type { View } from "./view";

export function connectLayers(scene: Scene, overlay: Overlay): void {
  for (const name of ["input", ...complexNames] as LineName[]) {
    const box = byId<HTMLInputElement>(`layer-${name}`);
    box.checked = scene.lines.has(name);
    box.addEventListener("change", () => {
      if (box.checked) scene.lines.add(name);
      else scene.lines.delete(name);
      scene.refresh();
    });
  }
  const findings = byId<HTMLInputElement>("layer-findings");
  findings.checked = overlay.showFindings;
  findings.addEventListener("change", () => {
    overlay.showFindings = findings.checked;
    overlay.draw();
  });
  const faces = byId<HTMLSelectElement>("faces");
  const apart = byId<HTMLInputElement>("apart");
  faces.value = scene.faces;
  faces.addEventListener("change", () => {
    scene.faces = faces.value as ComplexName | "none";
    apart.disabled = scene.faces === "none";
    if (scene.faces === "none") apart.value = "0";
    scene.size = sizeFor(apart);
    scene.refresh();
  });
  apart.value = "0";
  apart.addEventListener("input", () => {
    scene.size = sizeFor(apart);
    scene.refresh();
  });
}

/// Faces moved away from the middle by this part of their distance, all of it fitted to the stage.
const sizeFor = (apart: HTMLInputElement): number => 1 / (1 + Number(apart.value) / 100);

export function connectView(view: View): void {
  byId("zoom-in").addEventListener("click", () => view.zoomBy(2));
  byId("zoom-out").addEventListener("click", () => view.zoomBy(0.5));
  byId("zoom-all").addEventListener("click", () => view.showAll());
  const bar = byId("scale-bar");
  view.onMove(() => showScale(view, bar));
  showScale(view, bar);
}

/// A bar of 1, 2 or 5 times a power of ten units, at most 120 pixels long.
function showScale(view: View, bar: HTMLElement): void {
  const most = 120 / view.transform.k;
  const power = 10 ** Math.floor(Math.log10(most));
  const length = [5, 2, 1].map((digit) => digit * power).find((units) => units <= most) ?? power;
  bar.style.width = `${length * view.transform.k}px`;
  const decimals = Math.max(0, -Math.floor(Math.log10(length) + 1e-9));
  bar.textContent = decimals > 6 || length >= 1e7 ? length.toExponential(0).replace("e+", "e") : length.toFixed(decimals);
}

export function connectTabs(): void {
  const tabs = [...document.querySelectorAll<HTMLButtonElement>('[role="tab"]')];
  const open = (chosen: HTMLButtonElement) => {
    for (const tab of tabs) {
      const isChosen = tab === chosen;
      tab.setAttribute("aria-selected", String(isChosen));
      tab.tabIndex = isChosen ? 0 : -1;
      byId(tab.getAttribute("aria-controls")!).hidden = !isChosen;
    }
  };
  tabs.forEach((tab, i) => {
    tab.addEventListener("click", () => open(tab));
    tab.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      const next = tabs[(i + step + tabs.length) % tabs.length];
      open(next);
      next.focus();
    });
  });
}

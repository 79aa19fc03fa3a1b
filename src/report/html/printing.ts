// For print: light colours, and all findings of the list.

export function connectPrinting(prepare: () => void, recolour: () => void): void {
  const print = matchMedia("print");
  window.addEventListener("beforeprint", () => {
    prepare();
    recolour();
  });
  window.addEventListener("afterprint", recolour);
  print.addEventListener("change", () => {
    if (print.matches) prepare();
    recolour();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolour);
}

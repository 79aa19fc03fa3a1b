// For print: light colours, and all findings with all their numbers.

export function connectPrinting(prepare: (isPrinting: boolean) => void): void {
  const print = matchMedia("print");
  window.addEventListener("beforeprint", () => prepare(true));
  window.addEventListener("afterprint", () => prepare(false));
  print.addEventListener("change", () => prepare(print.matches));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => prepare(print.matches));
}

import type { ComplexName, Report } from "./report";

export const complexTitle: Record<ComplexName, string> = {
  authored: "as authored",
  doubles: "over the doubles",
  float: "float result",
};

/// Whose answer it is.
export function answerTitle(report: Report): string {
  return report.engine.title;
}

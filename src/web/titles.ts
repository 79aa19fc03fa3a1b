import type { ComplexName, Report } from "./report";

export const complexTitle: Record<ComplexName, string> = {
  authored: "as authored",
  doubles: "over the doubles",
  float: "float result",
};

/// The float result by its name.
export function resultTitle(report: Report): string {
  return report.radius === null ? report.result : `float LAR, ${report.result}`;
}

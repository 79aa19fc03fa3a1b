// What is in the page's JSON: the report as docs/json.md describes it, and `page`, which
// src/output/page/data.hpp describes.

export interface Exact {
  exact: string;
  nearest: number;
}

export interface Place {
  exact: [string, string];
  nearest: [number, number];
}

export interface Cause {
  stage: string;
  round: number;
  rule: string;
  explanation: string;
  advice: string;
  confirmed: boolean;
}

export interface Finding {
  number: number;
  kind: "vertex" | "edge" | "face" | "hole" | "complex" | "group"; // group: on the stage only
  disagreement: string;
  invariant: string | null;
  message: string;
  where: Place | null;
  exact_cells: number[];
  float_cells: number[];
  distance: number | null;
  squared_distance: Exact | null;
  area: Exact | null;
  cause: Cause | null;
  segments: number[];
  sources: number[];
}

/// Findings that are one event in one place.
export interface Group {
  number: number;
  message: string;
  where: Place | null;
  low: [number, number];
  high: [number, number];
  area: number;
  own: boolean;
  faces: { change: string; finding: number; areas: number[]; area: number }[];
  lead: number;
  findings: number[];
  sources: number[];
}

export type CountName =
  | "vertices"
  | "edges"
  | "faces"
  | "holes"
  | "isolated_vertices"
  | "components"
  | "antennas"
  | "depth";
export type Counts = Record<CountName, number>;

export interface LadderStep {
  radius: number;
  squared_radius: string;
  vertices: number;
  edges: number;
  faces: number;
  vertex: number | null;
  other_vertex: number | null;
  edge: number | null;
}

export interface Ladder {
  vertices: number;
  edges: number;
  faces: number;
  complete: boolean;
  steps: LadderStep[];
}

export interface SourceKind {
  file: number;
  element: string;
  path: string;
}

export interface ArrayEntry {
  name: string;
  type: "u32" | "f64";
  count: number;
  reference: string;
  index: string;
}

export interface Report {
  verdict: "agree" | "disagree";
  engine: { name: string; version: string; title: string };
  drift: { places: number; largest: number; findings: number };
  compared: "all" | "graph" | "faces" | "some faces";
  left_out: { edges: number; vertices: number };
  lost: number;
  float_valid: boolean;
  exact: boolean;
  radius: number | null;
  radius_from: "larlib" | "plasm" | "drawing" | "segment" | "number" | null;
  tolerance: number;
  largest_displacement: number;
  counts: Record<ComplexName | "exact", Counts>;
  crowded_vertices: number;
  groups: Group[];
  findings: Finding[];
  conversion: Finding[];
  ladder: Ladder | null;
  right_radii: [number, number] | null;
  advised_radius: number | null;
  tried_radii: { radius: number; right: boolean }[];
  files: string[];
  rejected: (SourceKind & { line: number; column: number; id: string; reason: string; text: string })[];
  remarks: (SourceKind & { line: number; column: number; id: string; what: string; text: string })[];
  ledger: (SourceKind & { line: number; column: number; id: string; what: string; bound: string })[];
  page: {
    y_up: boolean;
    arrays: ArrayEntry[];
    same_incidences: ComplexName[];
    exact_areas: string[];
    kinds: SourceKind[];
    ids: [number, string][];
  };
}

export type ComplexName = "authored" | "doubles" | "float";
export const complexNames: ComplexName[] = ["authored", "doubles", "float"];

import type { Reason } from "../../kernel/plan/issue.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import type { Run, RunFinding } from "../../program/state/run-types.ts";
import type { Simulation } from "../../sim/simulation.ts";

/**
 * What an answer is judged by. The first ones are never allowed; "missing" and "residue" compare the made part with the
 * wanted one; the rest are the rules of a task under their own names.
 */
export const RULES = [
  "errors",
  "unproved",
  "blank",
  "rapid",
  "holder",
  "gouge",
  "missing",
  "residue",
  "size",
  "clean",
  "depth",
  "speed",
  "tools",
  "mostTools",
  "seconds",
  "cycles",
  "without",
  "values",
  "passes",
  "rz",
  "words",
] as const;
export type RuleName = (typeof RULES)[number];

/** The learner's program and what comes of it. */
export interface Answer {
  readonly text: string;
  readonly run: Run;
  readonly simulation: Simulation;
}

/**
 * One thing that was looked at, and whether it is as it must be. Lengths mm, areas mm² of the half section, Rz µm,
 * times s.
 */
export interface TaskMark {
  readonly rule: RuleName;
  readonly passed: boolean;
  /** What is there, and what may be there. */
  readonly value?: number;
  readonly limit?: number;
  /**
   * Number of the block that did it, or that should be another one; the step of the run, from 0; the cycle call, from
   * 0.
   */
  readonly block?: number;
  readonly step?: number;
  readonly operation?: number;
  /** The parameter that it is about: "Q463". */
  readonly q?: string;
  /** A point inside the place where it shows, and the place itself. */
  readonly place?: Pt;
  readonly rings?: readonly Ring[];
  /** Of `Task.sizes`, from 0; of a list in the rules, its entry. */
  readonly size?: number;
  readonly entry?: number;
  /** The number of the cycle or of the tool, or the word, that it is about. */
  readonly about?: number | string;
  /** Why material stays, where the operation that should have taken it knows it. */
  readonly reason?: Reason;
  /** The finding of the run or of the stock that it tells. */
  readonly issue?: RunFinding["issue"];
}

/**
 * What a free program is worth, out of 100; nothing as long as it hurts the part, runs into material or is not proved.
 */
export interface Score {
  readonly total: number;
  readonly parts: readonly ScorePart[];
}
export interface ScorePart {
  /** "proof": the share of the rules that hold; "residue", "time" and "tools" against what a good answer needs. */
  readonly what: "proof" | "residue" | "time" | "tools";
  readonly points: number;
  readonly of: number;
  /** mm², s, or tools; a count of rules for the proof. */
  readonly value: number;
  readonly par: number;
}

export interface TaskJudgement {
  readonly passed: boolean;
  /** In the order of `RULES`; of several of a rule the gravest first. */
  readonly marks: readonly TaskMark[];
  /** Of a "drawing". */
  readonly score?: Score;
}

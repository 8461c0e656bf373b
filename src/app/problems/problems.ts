import { useMemo } from "react";
import type { Severity } from "../../kernel/issue.ts";
import type { Finding } from "../../program/run-types.ts";
import { contourProblems } from "../contour/contour-problems.ts";
import { useOutcome, type Outcome } from "../engine/outcome.ts";
import { usePrompted } from "../prompted.ts";
import { useReading, type JobReading } from "../reading.ts";

/** One thing to tell the operator, with the place it belongs to. */
export interface Problem {
  readonly issue: Finding["issue"];
  /** The field it belongs to: a Q number, "start.x", "tool", "contour" …; null when it belongs to none. */
  readonly at: string | null;
  readonly block: number | null;
}

const placeOf = (issue: Finding["issue"]): string | null => ("at" in issue ? (issue.at ?? null) : null);

/** A prompt that is still empty, or a Q parameter that still waits for its value: something to do, not something done wrong. */
export const isOpen = ({ issue }: Problem): boolean => issue.code === "missing" || issue.code === "unknownParameter";

/** Findings about a tool name it, or the column of the tool table. */
const toolPlaces: ReadonlySet<string> = new Set([
  "tool", "T", "NAME", "TYPE", "TO", "RS", "DRS", "ZL", "XL", "DZL", "DXL", "ORI", "T-ANGLE", "P-ANGLE", "CUTLENGTH", "CUTWIDTH", "DCW",
]);
export const isAboutTool = (at: string | null): boolean => at !== null && toolPlaces.has(at);

const weight: Readonly<Record<Severity, number>> = { error: 0, warning: 1, info: 2 };

/**
 * Everything found, worst first: what the prompts say at once, and what the last calculated program says. None twice.
 */
export function problemsOf(read: JobReading | null, newest: Outcome | null): readonly Problem[] {
  const typed = read?.reading.issues.map((issue): Problem => ({ issue, at: placeOf(issue), block: null })) ?? [];
  const found = typed.length > 0 ? [] : (newest?.run.issues ?? []).map(({ issue, block }): Problem => ({ issue, at: placeOf(issue), block }));
  const contour = read?.cycle.contour === "free" ? contourProblems(read.job.contour).map((issue): Problem => ({ issue, at: "contour", block: null })) : [];
  const all = new Map<string, Problem>();
  for (const problem of [...typed, ...contour, ...found]) {
    const { code, data } = problem.issue;
    const key = JSON.stringify([code, problem.at, data]);
    if (!all.has(key)) all.set(key, problem);
  }
  return [...all.values()].sort((a, b) => weight[a.issue.severity] - weight[b.issue.severity]);
}

/** The problems of the open job, or of the block whose prompts are shown; the same list as long as neither values nor results change. */
export function useProblems(): readonly Problem[] {
  const read = useReading();
  const newest = useOutcome((s) => s.newest);
  const block = usePrompted((p) => p.block);
  return useMemo(() => block?.problems ?? problemsOf(read, newest), [block, read, newest]);
}

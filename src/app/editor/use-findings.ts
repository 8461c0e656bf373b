import { useMemo } from "react";
import type { Severity } from "../../kernel/issue.ts";
import type { Finding } from "../../program/run-types.ts";
import { useOutcome } from "../engine/outcome.ts";

const weight: Readonly<Record<Severity, number>> = { error: 0, warning: 1, info: 2 };

/** Everything found in the whole program, worst first, then in the order of the text. */
export function useFindings(): readonly Finding[] {
  const newest = useOutcome((s) => s.newest);
  return useMemo(() => (newest?.run.issues ?? []).toSorted((a, b) => weight[a.issue.severity] - weight[b.issue.severity]), [newest]);
}

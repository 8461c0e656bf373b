import type { Severity } from "../../kernel/plan/issue.ts";
import { programIssue } from "./issue.ts";
import type { RunFinding } from "./run-types.ts";

/** Findings of one kind that are listed one by one. More would fill memory and lists, and say nothing new. */
export const MOST_ALIKE = 1000;

const WEIGHT: Readonly<Record<Severity, number>> = { info: 0, warning: 1, error: 2 };

/**
 * What is known of the findings of one kind: how many there are, and of those that are not listed where they begin and
 * how grave they are.
 */
interface Kind {
  count: number;
  gravest: Severity;
  /** Index in the list, -1 while all are listed. */
  first: number;
}

/**
 * Of each kind the first MOST_ALIKE findings, in their order. In the place of the first that is left out stands how
 * many there are, as grave as the gravest of them: nothing is left out in silence.
 */
export function fewAlike(findings: Iterable<RunFinding>): RunFinding[] {
  const kinds = new Map<string, Kind>();
  const listed: RunFinding[] = [];
  for (const finding of findings) {
    const { code, severity } = finding.issue;
    const kind = kinds.get(code) ?? { count: 0, gravest: "info", first: -1 };
    kinds.set(code, kind);
    kind.count += 1;
    if (kind.count <= MOST_ALIKE) {
      listed.push(finding);
      continue;
    }
    if (kind.first < 0) kind.first = listed.push(finding) - 1;
    if (WEIGHT[severity] > WEIGHT[kind.gravest]) kind.gravest = severity;
  }
  for (const [code, { count, gravest, first }] of kinds) {
    const place = listed[first];
    if (place)
      listed[first] = {
        ...place,
        issue: programIssue("moreAlike", gravest, { code, count: count - MOST_ALIKE }),
        operation: null,
      };
  }
  return listed;
}

import type { Severity } from "../../kernel/plan/issue.ts";
import { programIssue } from "./issue.ts";
import type { RunFinding } from "./run-types.ts";

/** Findings of one code that are listed. More would only fill memory and lists. */
export const MOST_PER_CODE = 1000;

const WEIGHT: Readonly<Record<Severity, number>> = { info: 0, warning: 1, error: 2 };

/** Findings of one code: their number, and the place and gravest severity of those left out. */
interface Kind {
  count: number;
  gravest: Severity;
  /** Index in the list, -1 while all are listed. */
  first: number;
}

/**
 * Keeps the first MOST_ALIKE findings of each code in their order. In place of the first one left out stands their
 * number, with the gravest severity among them: nothing is dropped silently.
 */
export function limitPerCode(findings: Iterable<RunFinding>): RunFinding[] {
  const kinds = new Map<string, Kind>();
  const listed: RunFinding[] = [];
  for (const finding of findings) {
    const { code, severity } = finding.issue;
    const kind = kinds.get(code) ?? { count: 0, gravest: "info", first: -1 };
    kinds.set(code, kind);
    kind.count += 1;
    if (kind.count <= MOST_PER_CODE) {
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
        issue: programIssue("moreAlike", gravest, { code, count: count - MOST_PER_CODE }),
        operation: null,
      };
  }
  return listed;
}

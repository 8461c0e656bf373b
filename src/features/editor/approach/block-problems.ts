import type { Issue } from "../../../kernel/plan/issue.ts";
import type { ApproachReading } from "../../../program/edits/approach-draft.ts";
import { entryAt, type FindingEntry } from "../../../app/findings/entry.ts";

const weight = { error: 0, warning: 1, info: 2 } as const;
const placed = (issue: Issue): FindingEntry => entryAt(issue, issue.at ?? null, null);

/** Everything about one block, worst first, nothing twice: what its words say, what its geometry says, what the run found. */
export function approachProblems(
  reading: ApproachReading,
  made: readonly Issue[],
  found: readonly FindingEntry[],
): readonly FindingEntry[] {
  const typed = Object.values(reading).flatMap((r) => (r.issue ? [placed(r.issue)] : []));
  const taken = new Set(typed.map((p) => p.at));
  const more = [...made.map(placed), ...found].filter((p) => p.at === null || !taken.has(p.at));
  const all = new Map([...typed, ...more].map((p) => [`${p.issue.code} ${p.at ?? ""}`, p]));
  return [...all.values()].sort((a, b) => weight[a.issue.severity] - weight[b.issue.severity]);
}

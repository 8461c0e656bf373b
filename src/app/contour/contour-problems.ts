import type { Issue } from "../../kernel/issue.ts";
import { readRows } from "../../program/contour-rows.ts";
import type { ContourRow } from "../../program/job.ts";

/** Findings that only the table knows: in the program text an open or unreadable element does not stand at all. */
const ONLY_HERE: ReadonlySet<Issue["code"]> = new Set<Issue["code"]>([
  "elementFree",
  "elementContradicts",
  "elementUnreachable",
  "centreMissing",
  "notANumber",
  "badExpression",
  "unknownParameter",
]);
const read = new WeakMap<readonly ContourRow[], readonly Issue[]>();

/** What is wrong with a contour table beyond what its program shows, read once per state of the table. */
export function contourProblems(rows: readonly ContourRow[]): readonly Issue[] {
  const known = read.get(rows);
  if (known) return known;
  const found = readRows(rows).issues.map(({ issue }) => issue).filter((issue): issue is Issue =>
    ONLY_HERE.has(issue.code as Issue["code"])
  );
  read.set(rows, found);
  return found;
}

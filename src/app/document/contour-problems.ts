import type { Issue } from "../../kernel/plan/issue.ts";
import { readRows, type RowIssue } from "../../program/job/contour-rows.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { hasBlock } from "../../program/job/print-contour.ts";

/** Findings of the table only: an incomplete or unreadable element is not in the program text. */
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

/** Findings of a contour table that its program does not show, cached per state of the table. */
export function contourProblems(rows: readonly ContourRow[]): readonly Issue[] {
  const known = read.get(rows);
  if (known) return known;
  const reading = readRows(rows);
  const isMissing = ({ row, issue }: RowIssue) => {
    const typed = rows[row];
    return (
      issue.code === "contourPoint" &&
      issue.severity === "error" &&
      typed !== undefined &&
      !hasBlock(typed, reading.rows[row])
    );
  };
  const found = reading.issues
    .filter((each) => ONLY_HERE.has(each.issue.code as Issue["code"]) || isMissing(each))
    .map(({ issue }) => issue as Issue);
  read.set(rows, found);
  return found;
}

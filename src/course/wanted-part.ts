import { boxAround } from "../kernel/box.ts";
import { difference, intersection, union } from "../kernel/clip.ts";
import type { Issue } from "../kernel/issue.ts";
import { at, part, type Pt, type Ring, type Segment } from "../kernel/point.ts";
import { CHORD, SAME } from "../kernel/tolerance.ts";
import { parse } from "../nc/parse.ts";
import { readContour } from "../program/contour-subprogram.ts";
import { Machine } from "../program/machine.ts";
import { run } from "../program/run.ts";
import type { Task } from "./task.ts";

/** The wanted part of a task as shapes. Part space, mm. */
export interface WantedPart {
  readonly blank: readonly Ring[];
  /** Its outlines from the free end, arcs kept; empty where the task states none. */
  readonly outside: readonly Segment[];
  readonly bore: readonly Segment[];
  /** What is to be left of the blank. */
  readonly rings: readonly Ring[];
  /** What is wrong with the outlines; empty for a part that can be judged by. */
  readonly issues: readonly Issue[];
}

/** Past everything that is drawn, mm: what lies behind an outline reaches this much farther than the blank. */
const PAST = 10;
const framed = (lines: readonly string[]): string => ["BEGIN PGM PART MM", ...lines, "END PGM PART MM", ""].join("\n");
/** No tool is called where only a blank or a contour is read. */
const SHOP = { tools: [], rapid: 1 } as const;

/** The blank that `BLK FORM` lines state; empty where they state none. */
export const blankOfLines = (lines: readonly string[]): readonly Ring[] => run(parse(framed(lines)), SHOP).blank;

/** The outline that lines of a contour subprogram describe. */
export function outlineOfLines(lines: readonly string[]): { readonly segments: readonly Segment[]; readonly issues: readonly Issue[] } {
  const program = parse(framed(["LBL 1", ...lines, "LBL 0"]));
  const read = readContour(new Machine(program, SHOP), 1, 0);
  return read ? read.contour : { segments: [], issues: [] };
}

/** The area between an outline and the axis. */
function below(outline: readonly Segment[]): Ring[] {
  const points: readonly Pt[] = part.flattenedChain(outline, CHORD);
  const [first, last] = [points[0], points.at(-1)];
  return first && last ? union([[at(last.z, 0), at(first.z, 0), ...points]]) : [];
}

/** The wanted part: the blank within the outside and without the bore; what lies behind the end of an outline stays as the blank is. */
export function wantedPart(wanted: NonNullable<Task["part"]>): WantedPart {
  const blank = blankOfLines(wanted.blank);
  const [outside, bore] = [outlineOfLines(wanted.outside ?? []), outlineOfLines(wanted.bore ?? [])];
  const issues = [...(wanted.outside ? outside.issues : []), ...(wanted.bore ? bore.issues : [])];
  let rings: readonly Ring[] = blank;
  if (blank.length > 0) {
    const box = boxAround([...blank]);
    const last = outside.segments.at(-1)?.to;
    if (last) {
      const [left, high] = [box.left - PAST, box.high + PAST];
      const behind: Ring[] = last.z > left + SAME ? [[at(left, 0), at(last.z, 0), at(last.z, high), at(left, high)]] : [];
      rings = intersection(rings, union(below(outside.segments), behind));
    }
    if (bore.segments.length > 0) rings = difference(rings, below(bore.segments));
  }
  return { blank, outside: outside.segments, bore: bore.segments, rings, issues };
}

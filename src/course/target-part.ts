import { areaOf } from "../kernel/area/area.ts";
import { boxAround } from "../kernel/area/box.ts";
import { difference, union } from "../kernel/area/clip.ts";
import { at, part, type Pt, type Ring, type Segment } from "../kernel/geometry/point.ts";
import { CHORD } from "../kernel/tolerance.ts";
import { diameter, toRadius } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import { readContour } from "../program/blocks/contour-subprogram.ts";
import { Machine } from "../program/state/machine.ts";
import { runInput } from "../program/state/run-input.ts";
import { run } from "../program/run/run.ts";
import type { RunFinding } from "../program/state/run-types.ts";
import type { Task } from "./task.ts";

type Found = RunFinding["issue"];

/** The target part of a task as shapes. Part space, mm. */
export interface TargetPart {
  readonly blank: readonly Ring[];
  /** Its outlines from the free end, arcs kept; empty where the task states none. */
  readonly outside: readonly Segment[];
  readonly bore: readonly Segment[];
  /** The finished half section. */
  readonly rings: readonly Ring[];
  /** The area that no tool may cut: the part without the grooves of its threads. */
  readonly solid: readonly Ring[];
  /** Faults of the blank and the outlines; empty for a usable part. */
  readonly issues: readonly Found[];
}

const framed = (lines: readonly string[]) => parse(["BEGIN PGM PART MM", ...lines, "END PGM PART MM", ""].join("\n"));
/** Reading a blank or a contour calls no tool. */
const SHOP = { tools: [], rapid: 1 } as const;
const faulty = (issues: readonly Found[]) => issues.filter((i) => i.severity === "error");

/** The half section that `BLK FORM` lines define, empty without any. Contours that they name follow with LBL. */
export function blankOfLines(lines: readonly string[]): {
  readonly rings: readonly Ring[];
  readonly issues: readonly Found[];
} {
  const states = (line: string) => /^\s*(?:\d+\s*)?BLK\s+FORM/.test(line);
  const contours = lines.filter((line) => !states(line));
  const { blank, issues } = run(framed([...lines.filter(states), "FUNCTION MODE TURN", "M30", ...contours]), SHOP);
  return { rings: blank, issues: faulty(issues.map((f) => f.issue)) };
}

/** The outline that lines of a contour subprogram describe. X is a diameter, as in every contour. */
export function outlineOfLines(lines: readonly string[]): {
  readonly segments: readonly Segment[];
  readonly issues: readonly Found[];
} {
  const machine = new Machine(runInput(framed(["LBL 1", ...lines, "LBL 0"]), SHOP));
  machine.set({ turning: true });
  const contour = readContour(machine, 1, 0)?.contour;
  const told = machine.log.allFindings().map((f) => f.issue);
  return { segments: contour?.segments ?? [], issues: faulty([...told, ...(contour?.issues ?? [])]) };
}

const counterClockwise = (ring: Ring): Ring => (areaOf([ring]) < 0 ? ring.toReversed() : ring);
/** A chain of points closed into an area; empty without a chain. */
const closed = (chain: readonly Pt[], round: (first: Pt, last: Pt) => Pt[]): Ring[] => {
  const [first, last] = [chain[0], chain.at(-1)];
  return first && last ? union([counterClockwise([...chain, ...round(first, last)])]) : [];
};

export type TargetThread = NonNullable<NonNullable<Task["part"]>["threads"]>[number];

/** The band between crest and root of a thread, over its full length. */
export function bandOfThread({ from, to, crest, root }: TargetThread): Ring {
  const [left, right] = [Math.min(from, to), Math.max(from, to)];
  const [one, other] = [toRadius(diameter(crest)), toRadius(diameter(root))];
  return counterClockwise([at(left, one), at(right, one), at(right, other), at(left, other)]);
}

/** Distance beyond the drawing, mm. */
const PAST = 100;

/**
 * The target part: the blank inside the outside outline and without the bore; behind the end of an outline the blank is
 * unmachined.
 */
export function targetPart(wanted: NonNullable<Task["part"]>): TargetPart {
  const blank = blankOfLines(wanted.blank);
  const [outside, bore] = [outlineOfLines(wanted.outside ?? []), outlineOfLines(wanted.bore ?? [])];
  const [outer, inner] = [outside.segments, bore.segments].map((s) => part.flattenedChain(s, CHORD)) as [Pt[], Pt[]];
  const { right, high } = boxAround([...blank.rings, outer, inner]);
  const far = Math.max(right, high) + PAST;
  const gone = [
    // In front of the first point and outside the last one, even where the outline runs back on itself in between.
    ...closed(outer, (first, last) => [at(last.z, far), at(far, far), at(far, 0), at(first.z, 0)]),
    ...closed(inner, (first, last) => [at(last.z, 0), at(far, 0), at(far, first.r)]),
  ];
  const rings = gone.length === 0 ? blank.rings : difference(blank.rings, gone);
  return {
    blank: blank.rings,
    outside: outside.segments,
    bore: bore.segments,
    rings,
    solid: wanted.threads?.length ? difference(rings, wanted.threads.map(bandOfThread)) : rings,
    issues: [...blank.issues, ...(wanted.outside ? outside.issues : []), ...(wanted.bore ? bore.issues : [])],
  };
}

import { areaOf } from "../../kernel/area.ts";
import { boxAround } from "../../kernel/box.ts";
import { difference, intersection, union } from "../../kernel/clip.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import { parse } from "../../nc/parse.ts";
import { readContour } from "../../program/contour-subprogram.ts";
import { Machine } from "../../program/machine.ts";
import { run } from "../../program/run.ts";
import type { RunFinding } from "../../program/run-types.ts";
import type { Task } from "../task.ts";

/** The part that a task asks for. Half sections, mm. */
export interface WantedPart {
  readonly blank: readonly Ring[];
  readonly part: readonly Ring[];
  /** The outlines as they are written, arcs kept; empty where none is given. */
  readonly outside: readonly Segment[];
  readonly bore: readonly Segment[];
  /** What is wrong with blank or outlines: then the part is not the one that is meant. */
  readonly problems: readonly RunFinding["issue"][];
}

const framed = (lines: readonly string[]) => parse(["BEGIN PGM PART MM", ...lines, "END PGM PART MM"].join("\n"));
const SHOP = { tools: [], rapid: 10_000 };
/** Label of an outline. */
const OUTLINE = 1;

/** Lines of a contour subprogram as segments. X is a diameter, as in every contour. */
export function outlineOf(lines: readonly string[]): { readonly segments: readonly Segment[]; readonly problems: RunFinding["issue"][] } {
  const machine = new Machine(framed([`LBL ${OUTLINE}`, ...lines, "LBL 0"]), SHOP);
  machine.set({ turning: true });
  const read = readContour(machine, OUTLINE, 0);
  const told = machine.log.allFindings().map((f) => f.issue);
  return {
    segments: read?.contour.segments ?? [],
    problems: [...told, ...(read?.contour.issues ?? [])].filter((i) => i.severity === "error"),
  };
}

/** The half section that blocks of BLK FORM state; what they follow, as `LBL 1` and its lines, stands behind them. */
export function statedBlank(lines: readonly string[]): { readonly rings: readonly Ring[]; readonly problems: RunFinding["issue"][] } {
  const states = (line: string) => /^\s*\d*\s*BLK\s+FORM/.test(line);
  const [blocks, outlines] = [lines.filter(states), lines.filter((line) => !states(line))];
  const { blank, issues } = run(framed([...blocks, "FUNCTION MODE TURN", "M30", ...outlines]), SHOP);
  return { rings: blank, problems: issues.map((f) => f.issue).filter((i) => i.severity === "error") };
}

const points = (outline: readonly Segment[]): Pt[] => part.flattenedChain(outline, CHORD);

/** What stands outside an outline: between it and the open, in front of its first point, and outside of its last one. */
function outsideOf(outline: readonly Segment[], far: number): Ring[] {
  const chain = points(outline);
  const [first, last] = [chain[0], chain.at(-1)];
  if (!first || !last) return [];
  return union([counterClockwise([...chain, at(last.z, far), at(far, far), at(far, 0), at(first.z, 0)])]);
}

/** The hollow inside an outline: between it and the axis, and in front of its first point. */
function insideOf(outline: readonly Segment[], far: number): Ring[] {
  const chain = points(outline);
  const [first, last] = [chain[0], chain.at(-1)];
  if (!first || !last) return [];
  return union([counterClockwise([...chain, at(last.z, 0), at(far, 0), at(far, first.r)])]);
}

const counterClockwise = (ring: Ring): Ring => (areaOf([ring]) < 0 ? ring.toReversed() : ring);

/** Farther than any blank reaches, mm. */
const BEYOND = 100;

/** The wanted part as a task describes it; null where it describes none. */
export function wantedOf({ part: given }: Pick<Task, "part">): WantedPart | null {
  if (!given) return null;
  const blank = statedBlank(given.blank);
  const [outside, bore] = [given.outside, given.bore].map((lines) => lines ? outlineOf(lines) : { segments: [], problems: [] });
  const { right, high } = boxAround([...blank.rings, ...[outside, bore].map((o) => points(o?.segments ?? []))]);
  const far = Math.max(right, high) + BEYOND;
  const gone = [...outsideOf(outside?.segments ?? [], far), ...insideOf(bore?.segments ?? [], far)];
  return {
    blank: blank.rings,
    part: gone.length === 0 ? blank.rings : difference(blank.rings, gone),
    outside: outside?.segments ?? [],
    bore: bore?.segments ?? [],
    problems: [...blank.problems, ...(outside?.problems ?? []), ...(bore?.problems ?? [])],
  };
}

/** Whether two half sections are the same but for chords and grid. */
export const areSame = (one: readonly Ring[], other: readonly Ring[]): boolean =>
  areaOf(difference(one, other)) + areaOf(difference(other, one)) < SAME * Math.max(1, Math.sqrt(areaOf(union(one, other))));

/** How much of an area lies in another one, mm². */
export const shared = (one: readonly Ring[], other: readonly Ring[]): number => areaOf(intersection(one, other));

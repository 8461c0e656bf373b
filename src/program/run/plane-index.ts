import type { BlockSpan } from "./block-span.ts";
import { markedBy, placeInSorted, stretchesBy, type MoveSpan, type PathChoice } from "./path-index.ts";
import type { Run } from "../state/run-types.ts";

/** The two views of a program: the section of the lathe, and the working plane of the mill. */
export type MachineSide = "lathe" | "plane";

/** The motions that a view shows. */
export const motionsOf = (run: Pick<Run, "plane" | "steps">, side: MachineSide): Run["plane"] | Run["steps"] =>
  side === "plane" ? run.plane : run.steps;

interface PlaneIndex {
  /** Blocks that made motions, in the order of the text, and the stretches of each. */
  readonly blocks: readonly number[];
  readonly ofBlock: ReadonlyMap<number, readonly MoveSpan[]>;
}

const indices = new WeakMap<Run["plane"], PlaneIndex>();

function planeIndex({ plane }: Pick<Run, "plane">): PlaneIndex {
  const known = indices.get(plane);
  if (known) return known;
  const ofBlock = stretchesBy(plane, ({ index }) => index);
  const made = { blocks: [...ofBlock.keys()].sort((a, b) => a - b), ofBlock };
  indices.set(plane, made);
  return made;
}

/** Milling motions of some blocks, in run order. */
export function milledBy(run: Pick<Run, "plane">, { from, to }: BlockSpan): readonly MoveSpan[] {
  const { blocks, ofBlock } = planeIndex(run);
  const own: MoveSpan[] = [];
  for (let i = placeInSorted(blocks, from); i < blocks.length && (blocks[i] ?? to + 1) <= to; i += 1)
    for (const span of ofBlock.get(blocks[i] ?? -1) ?? []) own.push(span);
  return own.sort((a, b) => a.first - b.first);
}

/** First milling motion of a block or of a later one; null where none moves. */
export function planeBegin(run: Pick<Run, "plane">, block: number): number | null {
  const { blocks, ofBlock } = planeIndex(run);
  return ofBlock.get(blocks[placeInSorted(blocks, block)] ?? -1)?.[0]?.first ?? null;
}

/** Choice of a milling motion: its block. */
export function choiceOfMilled({ plane }: Pick<Run, "plane">, step: number): PathChoice | null {
  const made = plane[step];
  return made ? { kind: "blocks", span: { from: made.index, to: made.index }, line: 0 } : null;
}

/** View that shows a choice, by its own moves or else by the next ones; null where a program has only one view. */
export function sideOfChoice(run: Run, choice: PathChoice): MachineSide | null {
  if (run.plane.length === 0 || run.steps.length === 0) return null;
  if (choice.kind !== "blocks") return "lathe";
  const [milled] = milledBy(run, choice.span),
    turned = markedBy(run, choice);
  if (turned.stretches.length > 0) return milled && firstIsMilled(run, milled.first, turned.begin) ? "plane" : "lathe";
  if (milled) return "plane";
  const [next, begin] = [planeBegin(run, choice.span.to), turned.begin];
  if (next === null || begin === null) return next === null ? (begin === null ? null : "lathe") : "plane";
  return (run.plane[next]?.index ?? 0) < (run.stepBlocks[begin] ?? 0) ? "plane" : "lathe";
}

/** Whether a milling motion runs before a turning motion. */
const firstIsMilled = ({ plane }: Run, milled: number, turned: number | null): boolean =>
  turned === null || (plane[milled]?.turned ?? 0) <= turned;

/** First milling motion with more turning steps before it than this; the count of milling motions when none has. */
function firstBehind(plane: Run["plane"], turned: number): number {
  let [low, high] = [0, plane.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((plane[middle]?.turned ?? 0) > turned) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** The same moment in the other view: its first move there at this time or later. */
export function momentOn(run: Pick<Run, "plane" | "steps">, side: MachineSide, step: number): number {
  const { plane, steps } = run;
  if (side === "lathe") return plane[step]?.turned ?? steps.length;
  // A milling motion with this many turning steps before it comes before the step itself.
  return firstBehind(plane, step);
}

/** Where playback from one step to another switches views: the first step there; null while it stays. */
export function crossing(
  { plane, steps }: Pick<Run, "plane" | "steps">,
  side: MachineSide,
  from: number,
  to: number,
): number | null {
  if (side === "plane") {
    const before = plane[from]?.turned;
    const after = to < plane.length ? plane[to]?.turned : steps.length;
    return before === undefined || after === undefined || after <= before || before >= steps.length ? null : before;
  }
  const next = firstBehind(plane, from);
  return (plane[next]?.turned ?? Infinity) <= to ? next : null;
}

import { areaOf } from "../kernel/area/area.ts";
import { boxAround } from "../kernel/area/box.ts";
import { CHUCK_SIZES, clampingBodies, missesBlank, type Clamped } from "../kernel/area/clamping.ts";
import { at, part as geometry, type Pt, type Ring, type Segment } from "../kernel/geometry/point.ts";
import { SAME } from "../kernel/tolerance.ts";
import { radius, rounded, toDiameter } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import type { Program } from "../nc/program.ts";
import { withClamping } from "../program/clamping/draft.ts";
import { clampingOf } from "../program/clamping/read-clamping.ts";
import type { ClampingDraft, ClampingWord } from "../program/clamping/words.ts";
import { flippedPiece, secondSide } from "../program/edits/second-side.ts";
import { surfacesOf, type StockSurface } from "../program/job/stock-surface.ts";
import { NC_OUTPUTS } from "../program/machine/nc-output.ts";
import { areaBeyond } from "./apply-action.ts";
import { LEAST_REGION, openRegions } from "./open-regions.ts";
import { solidOf } from "./actions/outside-work.ts";
import { threadId, threadsOf } from "./actions/thread.ts";
import type { Chain, ElementMark, PlannedPart, PlanRequest, PlanState } from "./types.ts";
import type { Residue, WorkingPlan } from "./working-plan.ts";

/** Turned end for end about the rear end of the part, which becomes Z0. */
const over =
  (rear: number) =>
  ({ z, r }: Pt): Pt =>
    at(rear - z, r);

/** An element seen from the other end, in the direction of a chain from there. */
function flipped(s: Segment, turned: (p: Pt) => Pt): Segment {
  const ends = { from: turned(s.to), to: turned(s.from) };
  // Mirrored and reversed: the turn stays.
  return s.kind === "line" ? { ...s, ...ends } : { ...s, ...ends, centre: turned(s.centre) };
}

const flippedChain = ({ segments, marks }: Chain, turned: (p: Pt) => Pt): Chain => ({
  segments: segments.map((s) => flipped(s, turned)).reverse(),
  marks: marks.toReversed(),
});

/** A mark without a word of the drawing. */
const UNMARKED: ElementMark = { row: "" };

/** A part seen from its rear end: that face is its front at Z0. A blind bore is behind a solid face. */
export function flippedPart(part: PlannedPart): PlannedPart {
  const { left: rear, right: front } = boxAround(part.rings);
  const turned = over(rear);
  const isFace = (s: Segment) => Math.abs(s.from.z - front) < SAME && Math.abs(s.to.z - front) < SAME;
  const faces = part.outside.segments.findIndex((s) => !isFace(s));
  const skipped = Math.max(0, faces);
  const own: Chain = {
    segments: part.outside.segments.slice(skipped),
    marks: part.outside.marks.slice(skipped),
  };
  const outer = own.segments.at(-1)?.to ?? at(rear, 0);
  const bore = part.inside.segments.at(-1)?.to;
  const isThrough = bore !== undefined && bore.r > SAME && Math.abs(bore.z - rear) < SAME;
  const outside = flippedChain(own, turned);
  const face = geometry.line(turned(at(rear, isThrough ? bore.r : 0)), turned(outer));
  return {
    ...part,
    outside: { segments: [face, ...outside.segments], marks: [UNMARKED, ...outside.marks] },
    inside: isThrough ? flippedChain(part.inside, turned) : { segments: [], marks: [] },
    rings: flippedPiece(part.rings, 0),
  };
}

/** A chain without the marks of threads that are made. */
function cut(chain: Chain, made: ReadonlySet<string>): Chain {
  const done = threadsOf(chain).filter((place) => made.has(threadId(chain, place)));
  const isDone = (i: number) => done.some(({ first, last }) => i >= first && i <= last);
  const without = ({ thread: _, ...mark }: ElementMark): ElementMark => mark;
  return { ...chain, marks: chain.marks.map((mark, i) => (isDone(i) ? without(mark) : mark)) };
}

const withoutThreads = (part: PlannedPart, made: ReadonlySet<string>): PlannedPart => ({
  ...part,
  outside: cut(part.outside, made),
  inside: cut(part.inside, made),
});

/** What a first clamping leaves: a region that the second one takes is reached from the rear, a thread is made. */
export function withRear(
  left: readonly Residue[],
  { stock, steps }: Pick<WorkingPlan, "stock" | "steps">,
  part: PlannedPart,
): readonly Residue[] {
  const turned = over(boxAround(part.rings).left);
  const threads = steps.flatMap(({ tried }) => tried.action.threads);
  const isMade = ({ region, thread }: Residue): boolean => {
    if (!region) return threads.some((id) => id.startsWith(`${thread} `));
    const rings = region.rings.map((ring) => ring.map(turned).reverse());
    return areaBeyond(rings, stock) > areaOf(rings) - LEAST_REGION;
  };
  return left
    .filter((each) => each.region || !isMade(each))
    .map((each) => (isMade(each) ? { ...each, why: "rear", missing: null } : each));
}

/** Length that jaws grip: at least, in diameters, and at most, mm; clearance of their face from the cuts. */
const GRIP = { least: 5, share: 0.25, most: 40, clear: 2 };
/** A chuck is larger than what it grips by this factor. */
const LARGER = 1.3;

/** The cylinders of a stock that soft jaws can grip behind a Z, the best first: long, large, without a thread. */
function grips(stock: readonly Ring[], { outside }: PlannedPart, behind: number): readonly StockSurface[] {
  const threaded = outside.segments.filter((_, i) => outside.marks[i]?.thread !== undefined);
  const isThread = ({ from, to }: StockSurface) =>
    threaded.some((s) => {
      const { left, right, low, high } = geometry.boxOf(s);
      return left < from.z && right > to.z && from.r > low - SAME && from.r < high + SAME;
    });
  const points = stock.flat();
  const lengthOf = ({ from, to }: StockSurface) => Math.min(GRIP.most, Math.min(from.z, behind) - to.z);
  return surfacesOf(stock, "outside")
    .filter((s) => lengthOf(s) >= Math.max(GRIP.least, GRIP.share * s.from.r))
    .filter((s) => points.every(({ z, r }) => z > s.to.z - SAME || r < s.from.r + SAME))
    .toSorted((a, b) => Number(isThread(a)) - Number(isThread(b)) || lengthOf(b) * b.from.r - lengthOf(a) * a.from.r);
}

/** Soft jaws on a finished cylinder behind all that is left to cut outside; null where the stock has none. */
export function softJaws(stock: readonly Ring[], part: PlannedPart): ClampingDraft | null {
  // Jaws stand beside the outside: what is left in a bore is in front of none of them.
  const left = openRegions(stock, { ...part, rings: [solidOf(part.outside)] }).map(({ box }) => box.left);
  const behind = Math.min(boxAround(stock).right, ...left) - GRIP.clear;
  const [grip] = grips(stock, part, behind);
  if (!grip) return null;
  const across = toDiameter(radius(grip.from.r));
  const face = Math.min(grip.from.z, behind);
  const size = CHUCK_SIZES.find((each) => each > across * LARGER) ?? Math.ceil((across * LARGER) / 100) * 100;
  const text = (mm: number) => String(rounded(mm));
  const long = Math.min(GRIP.most, face - grip.to.z);
  // A grip that would begin far in front of the end holds its rear part.
  return { kind: "softJaws", words: { D: text(across), LENGTH: text(long), FACE: text(face), SIZE: text(size) } };
}

/** The stated clamping of a stock; null where it is not complete or does not grip. */
function clampedBy({ kind, words }: ClampingDraft, blank: readonly Ring[]): Clamped | null {
  const values = Object.fromEntries(Object.entries(words).map(([word, text]) => [word, Number(text)]));
  const made = clampingOf({ kind, values: values as Partial<Record<ClampingWord, number>>, what: [] }, (n) => n);
  return "kind" in made && !missesBlank(made, blank) ? { clamping: made, bodies: clampingBodies(made, blank) } : null;
}

/**
 * The request of the second clamping: what the first one leaves, turned end for end and held in soft jaws on a finished
 * cylinder, with Z0 at the finished rear face. Its program has the stock as its blank. Null for a part that is parted
 * off or finished; without a clamping where no cylinder can be held. `program`: that of the first clamping.
 */
export function secondClamping(
  request: PlanRequest,
  { stock, threads }: Pick<PlanState, "stock" | "threads">,
  program: Program,
): PlanRequest | null {
  const { partsOff } = request;
  const part = withoutThreads(request.part, threads);
  if (partsOff || openRegions(stock, part).length === 0) return null;
  const allowance = boxAround(part.rings).left - boxAround(stock).left;
  const text = secondSide(program, stock, { allowance, output: NC_OUTPUTS.manual, callsTool: false });
  if (text === "") return null;
  const [turned, blank] = [flippedPart(part), flippedPiece(stock, allowance)];
  const jaws = softJaws(blank, flippedPart(request.part));
  const clamping = jaws && clampedBy(jaws, blank);
  const begun = parse(text);
  return { ...request, part: turned, blank, clamping, begun: jaws && clamping ? withClamping(begun, jaws) : begun };
}

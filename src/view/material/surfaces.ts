import { isDrill } from "../../kernel/cutter/drill.ts";
import { hypotenuse } from "../../kernel/geometry/vectors.ts";
import { noseRadius } from "../../kernel/cutter/insert.ts";
import type { Spindle, Step } from "../../kernel/time/step.ts";
import { handOf, type ThreadHand } from "../../kernel/time/thread-turns.ts";
import { GRID, SAME } from "../../kernel/tolerance.ts";
import { ROUGH_RZ, rzByRule } from "../../sim/load/cusp.ts";
import { feedPerTurn, rpmAt } from "../../sim/load/spindles.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { touchIndex, type TouchIndex } from "../../sim/touch-index.ts";

/** Look of a stretch of a boundary: unmachined, rough, finished, or a flank of a thread. */
export type Texture = "raw" | "rough" | "finished" | "thread";

/** The origin of a stretch of the boundary. */
export interface SurfaceOrigin {
  readonly texture: Texture;
  /** Index of the move; −1 where nothing has cut yet. */
  readonly step: number;
  /** Feed per revolution, mm; for a thread its lead. 0 if unknown. */
  readonly pitch: number;
  /** Z where the move began: its feed marks count from there. */
  readonly from: number;
  /** Direction of the move, as a vector of length 1: surfaces left by the tool's flank have no feed marks. */
  readonly way: readonly [z: number, r: number];
  /** Hand of a thread: left-handed threads are announced. */
  readonly hand: ThreadHand;
}

/** A straight piece of the boundary of the stock, in the direction of its ring, mm. */
export interface StockSide {
  readonly z0: number;
  readonly r0: number;
  readonly z1: number;
  readonly r1: number;
}

/** A piece of one side with its origin; `begin` and `end` are fractions of the side. */
export interface SurfaceStretch {
  readonly begin: number;
  readonly end: number;
  readonly made: SurfaceOrigin;
}

/**
 * Finds the origin of the stock's surfaces in a run. Answers depend on the query alone; earlier queries only make it
 * faster.
 */
export interface Surfaces {
  readonly of: (side: StockSide, now: PlayPosition) => readonly SurfaceStretch[];
  /** The greatest lead of the threads begun so far, mm; 0 without threads. */
  readonly lead: (now: PlayPosition) => number;
  /** The surfaces of another run; cached sides are reused as far as both runs begin alike. */
  readonly forRun: (
    steps: readonly Step[],
    spindleOf: (step: number) => Spindle | null,
    isBackwards: (step: number) => boolean,
  ) => Surfaces;
}

const RAW: SurfaceOrigin = { texture: "raw", step: -1, pitch: 0, from: 0, way: [0, 0], hand: 1 };

/** Sides shorter than this were made by one move, mm. */
const ONE = 0.3;
/** Stretches are split down to this length, mm. */
const FINE = 0.1;
/** Sample places on a side, as shares of it. */
const LOOKS = [0.03, 0.5, 0.97] as const;
/** Limit of cached sides. */
const MOST = 20_000;

/** Feed per revolution, mm; 0 if unknown. */
function perTurnOf({ move, from }: Step, spindle: Spindle | null): number {
  const way = feedPerTurn(move, rpmAt(spindle, from.r));
  return Number.isFinite(way) ? way : 0;
}

function wayOf({ from, move: { to } }: Step): readonly [number, number] {
  const size = hypotenuse(to.z - from.z, to.r - from.r);
  return size > 0 ? [(to.z - from.z) / size, (to.r - from.r) / size] : [0, 0];
}

/**
 * Whether a cut finishes. A cycle states the purpose of its cuts; a path block does not, and is judged by the height
 * that its feed and nose radius leave between two revolutions.
 */
function finishes({ move, tool, operation }: Step, perTurn: number): boolean {
  if (operation !== null || move.phase !== "position") return move.phase === "finish";
  const nose = noseRadius(tool);
  return perTurn > 0 && nose > 0 && !isDrill(tool) && rzByRule(perTurn, nose) <= ROUGH_RZ;
}

function textureOf(step: Step, perTurn: number): Texture {
  if (step.move.kind === "thread") return "thread";
  return finishes(step, perTurn) ? "finished" : "rough";
}

interface CachedSide extends StockSide {
  /** The last move that had begun when this was found, and its fraction. */
  last: number;
  fraction: number;
  readonly newest: number;
  readonly stretches: readonly SurfaceStretch[];
}

const grid = (v: number) => Math.round(v / GRID) | 0;
const keyOf = ({ z0, r0, z1, r1 }: StockSide): number => {
  let key = Math.imul(grid(z0), 0x9e3779b1);
  key = Math.imul(key ^ (key >>> 15) ^ grid(r0), 0x85ebca6b);
  key = Math.imul(key ^ (key >>> 13) ^ grid(z1), 0xc2b2ae35);
  return key ^ (key >>> 16) ^ Math.imul(grid(r1), 0x27d4eb2f);
};
const isSame = (a: StockSide, b: StockSide) => a.z0 === b.z0 && a.r0 === b.r0 && a.z1 === b.z1 && a.r1 === b.r1;

const handOfStep = ({ move, from }: Step, backwards: boolean): ThreadHand =>
  move.kind === "thread" ? handOf(from, move, backwards) : 1;

/**
 * Builds the surfaces of a run. A stretch was made by the latest cutting move with the stretch on the edge of its
 * sweep: a surface that a finishing cut passes is finished, even if the cut removed nothing there. `spindleOf` turns
 * feeds per minute into feeds per revolution, `isBackwards` decides the hand of threads.
 */
export const surfacesOf = (
  steps: readonly Step[],
  spindleOf: (step: number) => Spindle | null = () => null,
  isBackwards: (step: number) => boolean = () => false,
): Surfaces => surfacesBy(touchIndex(steps), steps, spindleOf, isBackwards);

/** Steps of unchanged calls keep their identity; between them there are rapids, which make no surface. */
const isAlike = (a: Step, b: Step | undefined): boolean =>
  a === b || (a.move.kind === "rapid" && b?.move.kind === "rapid");

/** Cached sides of the previous run. */
interface PreviousSides {
  readonly steps: readonly Step[];
  readonly sides: readonly CachedSide[];
}

function surfacesBy(
  touched: TouchIndex,
  steps: readonly Step[],
  spindleOf: (step: number) => Spindle | null,
  isBackwards: (step: number) => boolean,
  before: PreviousSides | null = null,
): Surfaces {
  const made = new Map<number, SurfaceOrigin>();
  const known = new Map<number, CachedSide>();
  let previous = before;

  /** Reuses sides that were made by steps common to both runs, until a later step touches them. */
  function reuse({ steps: others, sides }: PreviousSides): void {
    const last = steps.findIndex((step, i) => !isAlike(step, others[i])) - 1;
    const common = last < -1 ? steps.length - 1 : last;
    for (const side of sides) {
      const isTrue =
        side.newest <= common &&
        side.stretches.every(({ made: { step, pitch, texture, hand } }) => {
          const own = madeBy(step);
          return own.pitch === pitch && own.texture === texture && own.hand === hand;
        });
      if (isTrue) known.set(keyOf(side), side.last <= common ? { ...side } : { ...side, last: common, fraction: 0 });
    }
  }

  function madeBy(step: number): SurfaceOrigin {
    const s = steps[step];
    if (!s) return RAW;
    const perTurn = perTurnOf(s, spindleOf(step));
    const have = made.get(step) ?? {
      texture: textureOf(s, perTurn),
      step,
      // The marks of an arc are not evenly spaced along the axis.
      pitch: s.move.kind === "arc" ? 0 : perTurn,
      from: s.from.z,
      way: wayOf(s),
      hand: handOfStep(s, isBackwards(step)),
    };
    made.set(step, have);
    return have;
  }

  const makerAt = (side: StockSide, t: number, now: PlayPosition, after = -1): number =>
    touched.latest(side.z0 + (side.z1 - side.z0) * t, side.r0 + (side.r1 - side.r0) * t, now, after);

  function split(side: StockSide, length: number, now: PlayPosition): SurfaceStretch[] {
    const out: { begin: number; end: number; made: SurfaceOrigin }[] = [];
    const put = (begin: number, end: number, step: number) => {
      const last = out.at(-1);
      if (last?.made.step === step) last.end = end;
      else out.push({ begin, end, made: madeBy(step) });
    };
    const look = (begin: number, end: number) => {
      const size = (end - begin) * length;
      const middle = (begin + end) / 2;
      if (size < FINE) return put(begin, end, makerAt(side, middle, now));
      const makers = LOOKS.map((t) => makerAt(side, begin + (end - begin) * t, now));
      const [first = -1] = makers;
      if (makers.every((m) => m === first)) return put(begin, end, first);
      look(begin, middle);
      look(middle, end);
    };
    if (length < ONE) put(0, 1, makerAt(side, 0.5, now));
    else look(0, 1);
    return out;
  }

  function isStillValid(k: CachedSide, last: number, now: PlayPosition): boolean {
    if (last < k.last || (last === k.last && now.fraction < k.fraction)) return k.newest < last;
    // Split sides are split again: a later move may have come between.
    if (k.stretches.length > 1 && (last !== k.last || now.fraction !== k.fraction)) return false;
    if (LOOKS.some((t) => makerAt(k, t, now, k.last - 1) > k.newest)) return false;
    k.last = last;
    k.fraction = now.fraction;
    return true;
  }

  const threads = steps.flatMap(({ move }, step) =>
    move.kind === "thread" ? [{ step, lead: Math.abs(move.pitch) }] : [],
  );

  return {
    lead: (now) => threads.reduce((most, t) => (t.step <= now.step ? Math.max(most, t.lead) : most), 0),
    of(side, now) {
      if (previous) reuse(previous);
      previous = null;
      const last = now.fraction > 0 ? now.step : now.step - 1;
      const key = keyOf(side),
        have = known.get(key);
      if (have && isSame(have, side) && isStillValid(have, last, now)) return have.stretches;
      const length = hypotenuse(side.z1 - side.z0, side.r1 - side.r0);
      const stretches = length < SAME ? [{ begin: 0, end: 1, made: RAW }] : split(side, length, now);
      if (known.size > MOST) known.clear();
      const newest = stretches.reduce((most, s) => Math.max(most, s.made.step), -1);
      known.set(key, { ...side, last, fraction: now.fraction, newest, stretches });
      return stretches;
    },
    forRun: (next, spindleAt, turnsBack) =>
      surfacesBy(touched.of(next), next, spindleAt, turnsBack, previous ?? { steps, sides: [...known.values()] }),
  };
}

/** The surfaces of an uncut blank. */
export const UNTOUCHED: Surfaces = surfacesOf([]);

import type { Ring } from "../../kernel/geometry/point.ts";
import { part } from "../../kernel/geometry/point.ts";
import type { StatedBlank, Step } from "../../kernel/time/step.ts";
import { cuttingSpeedAt, isAtLimit, pathOf, travelOf } from "../../kernel/time/time.ts";
import { SAME, SLIVER } from "../../kernel/tolerance.ts";
import { cutting } from "../cutting.ts";
import { outlinesOf } from "../outlines.ts";
import { isCheckpointDue } from "../marks.ts";
import { statedBlanks } from "../stated-blanks.ts";
import { sweptBy } from "../sweep.ts";
import { takenBy } from "./engaged.ts";
import { feedPerTurn, rpmAt, spindleAt, type SpindleFrom } from "./spindles.ts";

/** Inputs of the tool load. */
export interface LoadInput {
  readonly blank: readonly Ring[];
  readonly stated?: readonly StatedBlank[];
  readonly steps: readonly Step[];
  readonly spindles: readonly SpindleFrom[];
}

/**
 * The tool load along the feeds, in columns: one row per stretch of a move with little change, in path order. NaN where
 * unknown.
 */
export interface PathLoad {
  readonly count: number;
  readonly step: Int32Array;
  /** Start and end as fractions of the path of the move. */
  readonly from: Float64Array;
  readonly to: Float64Array;
  /** Cut square to the path, mm: the depth of cut of a straight cut, the width of a plunge. */
  readonly depth: Float64Array;
  /** Cut per revolution, mm² of the half plane: depth times feed. */
  readonly chip: Float64Array;
  /** mm/rev. */
  readonly feed: Float64Array;
  /** m/min at the tip. */
  readonly speed: Float64Array;
  readonly rpm: Float64Array;
  /** 1 where the spindle is at its limit and the cutting speed is not held. */
  readonly limited: Uint8Array;
}

/** Length of a stretch, mm, and the most stretches in total; beyond that they are longer. */
const STRETCH = 0.75;
const MOST_STRETCHES = 20_000;
/** Most stretches of a straight move, and of an arc, which costs more. */
const MOST_STRAIGHT = 400;
const MOST_ROUND = 48;
/** Neighbours that differ by less are joined: a share of the value, and for depths mm. */
const SAME_SHARE = 0.02;
const SAME_DEPTH = 0.01;
/** Moves cut between two yields. */
const AT_ONCE = 32;

interface Row {
  readonly step: number;
  readonly from: number;
  to: number;
  depth: number;
  readonly feed: number;
  readonly speed: number;
  readonly rpm: number;
  readonly limited: boolean;
}

const isNear = (a: number, b: number, least = 0) =>
  Object.is(a, b) || Math.abs(a - b) <= Math.max(least, SAME_SHARE * Math.max(Math.abs(a), Math.abs(b)));
const areAlike = (a: Row, b: Row) =>
  a.limited === b.limited &&
  isNear(a.speed, b.speed) &&
  isNear(a.rpm, b.rpm) &&
  isNear(a.feed, b.feed) &&
  isNear(a.depth, b.depth, SAME_DEPTH) &&
  a.depth > 0 === b.depth > 0;

const cuts = ({ move, from }: Step) => {
  if (move.kind === "rapid" || (move.kind === "feed" && move.dwell !== undefined)) return 0;
  const travel = travelOf(pathOf(from, move));
  return travel > SAME ? travel : 0;
};

/** The stretches of one feed with their cut square to the path; similar neighbours are joined. */
function rowsOf(step: Step, index: number, depths: Float64Array, spindle: ReturnType<typeof spindleAt>): Row[] {
  const rows: Row[] = [];
  const point = part.pointsOn(pathOf(step.from, step.move)),
    count = depths.length;
  let joined = 1;
  depths.forEach((depth, i) => {
    const { r } = step.move.kind === "thread" ? step.from : point((i + 0.5) / count);
    const rpm = rpmAt(spindle, r),
      limited = spindle !== null && isAtLimit(spindle, r);
    const feed = feedPerTurn(step.move, rpm),
      speed = cuttingSpeedAt(rpm, r);
    const row: Row = { step: index, from: i / count, to: (i + 1) / count, depth, feed, speed, rpm, limited };
    const last = rows.at(-1);
    if (!last || !areAlike(last, row)) {
      rows.push(row);
      joined = 1;
      return;
    }
    last.to = row.to;
    last.depth += (depth - last.depth) / (joined += 1);
  });
  return rows;
}

function columnsOf(rows: readonly Row[]): PathLoad {
  const numbers = (pick: (row: Row) => number) => Float64Array.from(rows, pick);
  return {
    count: rows.length,
    step: Int32Array.from(rows, (row) => row.step),
    from: numbers((row) => row.from),
    to: numbers((row) => row.to),
    depth: numbers((row) => row.depth),
    chip: numbers((row) => row.depth * row.feed),
    feed: numbers((row) => row.feed),
    speed: numbers((row) => row.speed),
    rpm: numbers((row) => row.rpm),
    limited: Uint8Array.from(rows, (row) => Number(row.limited)),
  };
}

/**
 * Cuts the stock once more and measures the cut of each stretch of each feed. This takes as long as a simulation, so
 * the generator yields after every few moves. Threads have no depth.
 */
export function* loadAlong({ blank, stated = [], steps, spindles }: LoadInput): Generator<void, PathLoad, void> {
  const outlines = outlinesOf(),
    statements = statedBlanks(stated);
  const size = Math.max(STRETCH, steps.reduce((sum, step) => sum + cuts(step), 0) / MOST_STRETCHES);
  const rows: Row[] = [];
  let cut = cutting(blank),
    marked = 0;
  for (const [index, step] of steps.entries()) {
    const now = statements.at(index, cut);
    if (now || isCheckpointDue(index, marked, cut.pieces)) [cut, marked] = [cutting(now ?? cut.stock()), index];
    const { insert } = outlines(step.tool),
      sweep = sweptBy(insert, step),
      travel = cuts(step);
    if (travel > 0) {
      const most = step.move.kind === "arc" ? MOST_ROUND : MOST_STRAIGHT;
      const count = step.move.kind === "thread" ? 1 : Math.max(1, Math.min(most, Math.ceil(travel / size)));
      const taken =
        step.move.kind === "thread" ? Float64Array.of(NaN) : takenBy(step, insert, sweep, cut.present(), count);
      const depths = taken.map((area) => {
        const depth = (area * count) / travel;
        return depth < SLIVER ? 0 : depth;
      });
      for (const row of rowsOf(step, index, depths, spindleAt(spindles, index))) rows.push(row);
    }
    cut.add(sweep);
    if (index % AT_ONCE === AT_ONCE - 1) yield;
  }
  return columnsOf(rows);
}

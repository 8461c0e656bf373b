import { boxAround, boxOf } from "../../kernel/area/box.ts";
import { difference, intersection, offset, union } from "../../kernel/area/clip.ts";
import { insertOutline } from "../../kernel/cutter/insert.ts";
import { part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { handOf, turnsIn, type ThreadHand, type ThreadMove } from "../../kernel/time/thread-turns.ts";
import { pathOf } from "../../kernel/time/time.ts";
import { CHORD } from "../../kernel/tolerance.ts";
import { turnsBack, type SpindleFrom } from "../../sim/load/spindles.ts";
import type { PlayPosition } from "../../sim/simulation.ts";
import { sweptBy } from "../../sim/sweep.ts";

/** One cut along a thread, up to the current moment. */
export interface ThreadCut {
  readonly from: Pt;
  readonly move: ThreadMove;
  /** Turns of the spindle done so far, and those of the whole cut. */
  readonly done: number;
  readonly turns: number;
  readonly hand: ThreadHand;
  /** Outline of the insert round its tip, counter-clockwise. */
  readonly outline: Ring;
}

/** A stock with threads in it. */
export interface ThreadedStock {
  /** The stock as it would be without the grooves. */
  readonly base: readonly Ring[];
  readonly cuts: readonly ThreadCut[];
}

/** The threads of a run. */
export interface RunThreads {
  /**
   * The stock of a moment, split into the turned body and the grooves in it; null before the first groove. `within`:
   * nothing is filled beyond it.
   */
  readonly of: (stock: readonly Ring[], now: PlayPosition, within?: readonly Ring[]) => ThreadedStock | null;
}

/** Further inputs that determine the threads of a run. */
export interface ThreadsOf {
  /** The steps from which on another blank is in the chuck, without the earlier cuts. */
  readonly stated?: readonly number[];
  /** The direction of the spindle; forwards if not given. */
  readonly spindles?: readonly SpindleFrom[];
}

/** Consecutive cuts with one tool in one operation. */
interface Group {
  readonly first: number;
  last: number;
  readonly steps: number[];
}

/** Grooves are filled farther than they were cut by this, mm, so that filling and stock join. */
const JOIN = 0.01;
/** Without gaps that are thinner than twice that. */
const joinedUp = (area: readonly Ring[]): readonly Ring[] => offset(offset(area, JOIN), -JOIN);

type ThreadStep = Step & { readonly move: ThreadMove };
const isThread = (step: Step | undefined): step is ThreadStep => step?.move.kind === "thread";
const isCut = ({ move }: Step) => move.kind === "feed" || move.kind === "arc";

function groupsOf(steps: readonly Step[]): readonly Group[] {
  const groups: Group[] = [];
  let open: Group | undefined;
  steps.forEach((step, i) => {
    const before = open && steps[open.first];
    if (!isThread(step)) {
      if (isCut(step)) open = undefined;
      return;
    }
    if (!open || before?.tool !== step.tool || before.operation !== step.operation)
      groups.push((open = { first: i, last: i, steps: [] }));
    open.last = i;
    open.steps.push(i);
  });
  return groups;
}

/**
 * The threads of a run; null if it has none. `stockAt` is called once for each of them, for the stock before its first
 * cut.
 */
export function runThreads(
  steps: readonly Step[],
  stockAt: (position: PlayPosition) => readonly Ring[],
  { stated = [], spindles = [] }: ThreadsOf = {},
): RunThreads | null {
  const groups = groupsOf(steps);
  if (groups.length === 0) return null;
  const outlines = new Map<Step["tool"], Ring>();
  const outlineOf = ({ tool }: Step): Ring => {
    const have = outlines.get(tool) ?? insertOutline(tool, CHORD);
    outlines.set(tool, have);
    return have;
  };
  const filled = new Map<Group, readonly Ring[]>();
  const fillOf = (group: Group): readonly Ring[] => {
    const have = filled.get(group);
    if (have) return have;
    const swept = union(
      group.steps.flatMap((i) => {
        const step = steps[i];
        return step ? [...sweptBy(outlineOf(step), step).rings] : [];
      }),
    );
    const fill = intersection(stockAt({ step: group.first, fraction: 0 }), offset(swept, JOIN));
    filled.set(group, fill);
    return fill;
  };

  /** The part of a filling that has not been turned off since. */
  function stillThere(fill: readonly Ring[], from: number, now: PlayPosition): readonly Ring[] {
    if (fill.length === 0) return fill;
    const box = boxAround(fill),
      gone: Ring[] = [];
    for (let i = from; i <= Math.min(now.step, steps.length - 1); i += 1) {
      const step = steps[i] as Step,
        fraction = i < now.step ? 1 : now.fraction;
      if (!isCut(step) || fraction === 0) continue;
      const way = part.boxOf(pathOf(step.from, step.move)),
        tool = boxOf(outlineOf(step));
      const isAway =
        way.right + tool.right < box.left ||
        way.left + tool.left > box.right ||
        way.high + tool.high < box.low ||
        way.low + tool.low > box.high;
      if (!isAway) gone.push(...sweptBy(outlineOf(step), step, fraction).rings);
    }
    return gone.length > 0 ? difference(fill, union(gone)) : fill;
  }

  const cutOf = (i: number, now: PlayPosition): ThreadCut[] => {
    const step = steps[i],
      fraction = i < now.step ? 1 : now.fraction;
    if (!isThread(step) || i > now.step || fraction === 0) return [];
    const turns = turnsIn(step.from, step.move);
    const hand = handOf(step.from, step.move, turnsBack(spindles, i));
    return [{ from: step.from, move: step.move, turns, done: turns * fraction, hand, outline: outlineOf(step) }];
  };

  return {
    of(stock, now, within) {
      const since = stated.findLast((step) => step <= now.step) ?? 0;
      const begun = groups.filter(
        ({ first }) => first >= since && (first < now.step || (first === now.step && now.fraction > 0)),
      );
      if (begun.length === 0) return null;
      const filling = begun.flatMap((group) => [...stillThere(fillOf(group), group.first + 1, now)]);
      // Filling up to another outline than that of the stock leaves hairline gaps along it, in which a surface would be
      // doubled.
      const base = within ? joinedUp(union(stock, intersection(filling, within))) : union(stock, filling);
      return { base, cuts: begun.flatMap(({ steps: all }) => all.flatMap((i) => cutOf(i, now))) };
    },
  };
}

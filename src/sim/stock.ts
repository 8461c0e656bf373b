import { unpacked } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { cutting, type Cutting, type Present } from "./cutting.ts";
import { isStockReplaced } from "./marks.ts";
import { outlinesOf } from "./outlines.ts";
import type { Checkpoint, PlayPosition, Simulation } from "./simulation.ts";
import { sweptBy } from "./sweep.ts";

/** The stock at any moment of a run. Moving on from the last query is cheapest; the result is the same. */
export interface Player {
  at(position: PlayPosition): readonly Ring[];
  /**
   * The stock at the start of a step. The last few steps are cached, so that looking back one revolution costs nothing.
   */
  before(step: number): Present;
}

/** Steps before the running one whose stock is cached for looking back. */
const RECENT_STEPS = 32;

/** The position inside the run that is nearest to the given one. */
function within(simulation: Simulation, position: PlayPosition): PlayPosition {
  const count = simulation.steps.length;
  if (!(position.step >= 0)) return { step: 0, fraction: 0 };
  const step = Math.floor(position.step);
  if (step >= count) return { step: count, fraction: 0 };
  const fraction = Math.min(1, Math.max(0, position.fraction || 0));
  return fraction === 1 ? { step: step + 1, fraction: 0 } : { step, fraction };
}

/** Index of the last mark at or before a step. */
function markFor(checkpoints: readonly Checkpoint[], step: number): number {
  let [low, high] = [0, checkpoints.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((checkpoints[middle]?.step ?? 0) <= step) low = middle;
    else high = middle - 1;
  }
  return low;
}

/**
 * A player of one simulation. The stock of a moment is always that of an earlier mark less the same pieces in the same
 * order, recomputed at the same marks. So playing, stepping and seeking give the same stock.
 */
export function playerOf(simulation: Simulation): Player {
  const outlines = outlinesOf();
  const { checkpoints } = simulation;
  let now: { mark: number; next: number; cut: Cutting } | null = null;
  /** The stock at the start of the last steps. */
  const recent = new Map<number, Present>();

  /** The nearest mark at or before a step with a stored stock. */
  function keptFor(step: number): number {
    let mark = markFor(checkpoints, step);
    while (mark > 0 && !checkpoints[mark]?.stock) mark -= 1;
    return mark;
  }

  function keep(step: number, stock: Present) {
    recent.set(step, stock);
    for (const oldest of recent.keys()) {
      if (recent.size <= RECENT_STEPS) break;
      recent.delete(oldest);
    }
  }

  function cutUpTo(step: number): Cutting {
    const mark = keptFor(step);
    if (!now || now.mark < mark || now.next > step)
      now = { mark, next: checkpoints[mark]?.step ?? 0, cut: cutting(unpacked(checkpoints[mark]?.stock ?? [])) };
    for (;;) {
      const begun: Checkpoint | undefined = checkpoints[now.mark + 1];
      if (begun?.step === now.next)
        now = {
          mark: now.mark + 1,
          next: now.next,
          cut: cutting(isStockReplaced(begun) ? unpacked(begun.stock ?? []) : now.cut.stock()),
        };
      if (step - now.next < RECENT_STEPS && !recent.has(now.next)) keep(now.next, now.cut.present());
      if (now.next >= step) return now.cut;
      const s = simulation.steps[now.next];
      if (s) now.cut.add(sweptBy(outlines(s.tool).insert, s));
      now.next += 1;
    }
  }

  return {
    before(step) {
      return recent.get(step) ?? cutUpTo(step).present();
    },
    at(asked) {
      const { step, fraction } = within(simulation, asked);
      const cut = cutUpTo(step);
      const running = simulation.steps[step];
      return cut.stock(running && sweptBy(outlines(running.tool).insert, running, fraction));
    },
  };
}

/** The stock at one moment. */
export const stockAt = (simulation: Simulation, position: PlayPosition): readonly Ring[] =>
  playerOf(simulation).at(position);

/** Whether two moments of a run are in the same blank, with no other one stated between them. */
export function sameBlank({
  checkpoints,
}: Pick<Simulation, "checkpoints">): (one: PlayPosition, other: PlayPosition) => boolean {
  const stated = checkpoints.filter((mark) => mark.isStated).map((mark) => mark.step);
  return (one, other) => stated.every((step) => step <= one.step === step <= other.step);
}

/** The initial blank and all blanks stated later. */
export const blanksOf = ({ blank, checkpoints }: Pick<Simulation, "blank" | "checkpoints">): readonly Ring[] => [
  ...blank,
  ...checkpoints.flatMap(({ isStated, stock }) => (isStated && stock ? unpacked(stock) : [])),
];

import { areaOf } from "../kernel/area/area.ts";
import { union } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { boxAround, gapBetween } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { AnyFinding } from "./simulation.ts";

/** Moves whose places are nearer than this do the same damage, mm. */
const SAME_PLACE = 0.1;
/** Findings that are kept apart; what comes after them is added to the last of its kind. */
const MOST = 500;
/** Rings that are kept before they are merged. */
const RINGS = 64;

interface Kept {
  finding: AnyFinding;
  box: Box;
  /** Area of the largest single piece, which gives the place. */
  largest: number;
  /** Rings after which they are merged: twice what the last merging left, so that merging does not become the work. */
  many: number;
}

/** Gathers what moves do wrong, and makes one finding of moves that do it in the same place. */
export interface Collector {
  add(found: readonly AnyFinding[]): void;
  all(): AnyFinding[];
}

const around = (a: Box, b: Box): Box => ({
  left: Math.min(a.left, b.left),
  right: Math.max(a.right, b.right),
  low: Math.min(a.low, b.low),
  high: Math.max(a.high, b.high),
});

/**
 * A gouge and a rapid take away what they find, so their areas add up; a holder leaves it, as a clamping stays, and
 * finds it again.
 */
const staysThere = (f: AnyFinding) => f.kind === "holderContact" || f.kind === "clampContact";

/** What goes on over several blocks: a groove is cut in more than one. */
const goesOn = (f: AnyFinding) => staysThere(f) || f.kind === "cutBelowContour";
/** Sweeps in a place where no stock is are the same place each time. */
const covers = (f: AnyFinding) =>
  staysThere(f) || f.kind === "cutOnLoosePiece" || f.kind === "rapidBehindBlank" || f.kind === "feedBehindBlank";

/** What belongs together: of a spindle that stands still everything that is cut until it is started. */
function groupOf(f: AnyFinding): string {
  if (f.idle) return `${f.idle.how} ${f.idle.by ?? ""}`;
  const part = f.clamp ? `${f.clamp.part} ${f.clamp.by} ` : "";
  return `${f.kind} ${part}${f.isMeant ?? false} ${f.operation ?? (goesOn(f) ? "" : `block ${f.block}`)}`;
}

/**
 * Begins to gather. Moves of one cycle call belong together, outside cycles those of one block; a holder that touches,
 * however it goes on.
 */
export function collector(): Collector {
  const kept: Kept[] = [];
  const groups = new Map<string, Kept[]>();
  const last = new Map<AnyFinding["kind"], Kept>();

  function join(k: Kept, f: AnyFinding, box: Box): void {
    let rings: readonly Ring[] = [...k.finding.rings, ...f.rings];
    if (rings.length > k.many) {
      rings = union(rings);
      k.many = Math.max(RINGS, 2 * rings.length);
    }
    k.finding = {
      ...k.finding,
      area: k.finding.area + f.area,
      moves: k.finding.moves + f.moves,
      rings,
      ...(f.area > k.largest && { place: f.place }),
    };
    k.largest = Math.max(k.largest, f.area);
    k.box = around(k.box, box);
  }
  return {
    add(found) {
      for (const f of found) {
        const key = groupOf(f);
        const group = groups.get(key) ?? [];
        const box = boxAround(f.rings);
        const same =
          group.find((k) => f.idle !== undefined || gapBetween(k.box, box) <= SAME_PLACE) ??
          (kept.length >= MOST ? last.get(f.kind) : undefined);
        if (same) join(same, f, box);
        else {
          const fresh = { finding: f, box, largest: f.area, many: RINGS };
          kept.push(fresh);
          groups.set(key, [...group, fresh]);
          last.set(f.kind, fresh);
        }
      }
    },
    all: () =>
      kept.map(({ finding: f }) => {
        if (f.moves === 1) return f;
        const rings = union(f.rings);
        return { ...f, rings, ...(covers(f) && { area: areaOf(rings) }) };
      }),
  };
}

import { areaOf } from "../kernel/area/area.ts";
import { union } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { boxAround, gapBetween } from "../kernel/area/box.ts";
import type { Box } from "../kernel/geometry/segments.ts";
import type { AnyFinding } from "./simulation.ts";

/** Findings nearer to each other than this are the same damage, mm. */
const SAME_PLACE = 0.1;
/** Most separate findings; later ones are added to the last of their kind. */
const MOST = 500;
/** Rings collected before they are merged. */
const RINGS = 64;

interface Kept {
  finding: AnyFinding;
  box: Box;
  /** Area of the largest single piece, which sets the marked place. */
  largest: number;
  /** Ring count that triggers a merge: twice the result of the last one, to limit the cost. */
  many: number;
}

/** Collects damage, and joins moves that do the same damage in one place. */
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
 * Contour damage and rapids remove material, so their areas add up. Holder and clamping contacts recur in the same
 * place.
 */
const leavesStock = (f: AnyFinding) => f.kind === "holderContact" || f.kind === "clampContact";

/** Findings that may span several blocks, such as a groove below the contour. */
const goesOn = (f: AnyFinding) => leavesStock(f) || f.kind === "cutBelowContour" || f.kind === "intendedCut";
/** Findings without stock cover the same place each time. */
const covers = (f: AnyFinding) =>
  leavesStock(f) ||
  f.kind === "toolLimit" ||
  f.kind === "cutOnLoosePiece" ||
  f.kind === "rapidBehindBlank" ||
  f.kind === "feedBehindBlank";

/** The key of findings that belong together: with a stopped spindle, every cut until it starts. */
function groupOf(f: AnyFinding): string {
  if (f.limit) return `${f.kind} ${f.limit.tool} ${f.limit.column}`;
  if (f.idle) return `${f.idle.how} ${f.idle.by ?? ""}`;
  const part = f.clamp ? `${f.clamp.part} ${f.clamp.by} ` : "";
  return `${f.kind} ${part}${f.isMeant ?? false} ${f.operation ?? (goesOn(f) ? "" : `block ${f.block}`)}`;
}

/**
 * Starts a collection. Damage is joined per cycle call, outside cycles per block, and holder contact across all moves.
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
          group.find((k) => f.idle !== undefined || f.limit !== undefined || gapBetween(k.box, box) <= SAME_PLACE) ??
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

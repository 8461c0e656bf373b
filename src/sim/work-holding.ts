import { areaOf, areaOfRing } from "../kernel/area/area.ts";
import { boxAround } from "../kernel/area/box.ts";
import { gripZones, missesBlank, type Clamping } from "../kernel/area/clamping.ts";
import { intersection, offset, union } from "../kernel/area/clip.ts";
import { isBar } from "../kernel/cutter/insert.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { REAL_AREA, withoutSlivers } from "../kernel/area/real-area.ts";
import type { Step } from "../kernel/time/step.ts";
import { SAME } from "../kernel/tolerance.ts";
import { sidesOf, type Edges } from "./edges.ts";
import { largest, placeIn, regionsOf, type Region } from "./region.ts";
import type { AnyFinding, LoosePiece, LooseShape } from "./simulation.ts";

/** The blank's rear plane and its largest radius, mm; null where there is no blank. */
export interface RearEnd {
  readonly z: number;
  readonly outside: number;
}

/** The work holding. */
export interface WorkHold {
  readonly rear: RearEnd;
  /** Where a stated clamping grips; null where the rear end holds. */
  readonly zones: readonly Ring[] | null;
}

/** The rear end of a blank. */
function rearOf(blank: readonly Ring[]): RearEnd | null {
  if (areaOf(blank) < REAL_AREA) return null;
  const { left, high } = boxAround(blank);
  return { z: left, outside: high };
}

/** The work holding: the stated clamping if it grips the blank, else the rear end. Null without a blank. */
export function holdOf(blank: readonly Ring[], clamping: Clamping | null): WorkHold | null {
  const rear = rearOf(blank);
  return rear && { rear, zones: clamping && !missesBlank(clamping, blank) ? gripZones(clamping, blank) : null };
}

/** The fields of a clamping that define its grip. */
const gripOf = (c: Clamping | null) =>
  c && [c.kind, c.diameter, c.length, c.face, c.kind === "centres" ? c.tailstock : null];

/** Whether two clampings hold a blank in the same places. */
export const sameHold = (a: Clamping | null, b: Clamping | null): boolean =>
  a === b || JSON.stringify(gripOf(a)) === JSON.stringify(gripOf(b));

const ringsOf = (regions: readonly Region[]): Ring[] => regions.flatMap(({ outline, holes }) => [outline, ...holes]);

/** A stock split into the held part and the loose pieces. */
interface Apart {
  readonly held: readonly Ring[];
  readonly loose: readonly Region[];
}

/** A split found before a step. */
export interface Parted extends Apart {
  readonly step: number;
}

/** The pieces in the grip of a clamping. */
const gripped = (regions: readonly Region[], zones: readonly Ring[]): readonly Region[] =>
  regions.filter((region) => areaOf(intersection(ringsOf([region]), zones)) >= REAL_AREA);

/** The pieces at the rear end; where none reaches it, the piece that reaches farthest back. */
function atRear(regions: readonly Region[], rear: RearEnd): readonly Region[] {
  const back = ({ outline }: Region) => boxAround([outline]).left;
  const farthest = Math.max(rear.z, Math.min(...regions.map(back)));
  return regions.filter((region) => back(region) <= farthest + SAME);
}

/**
 * Splits a stock into held and loose; null where it is in one piece. With nothing left in the grip of the clamping (an
 * error of its own) the rear end counts.
 */
export function brokenApart(stock: readonly Ring[], { rear, zones }: WorkHold): Apart | null {
  if (stock.filter((ring) => areaOfRing(ring) > 0).length < 2) return null;
  const regions = regionsOf(stock, 0),
    inGrip = zones ? gripped(regions, zones) : [];
  const held = new Set(inGrip.length > 0 ? inGrip : atRear(regions, rear));
  const isHeld = (region: Region) => held.has(region);
  const loose = regions.filter((region) => !isHeld(region));
  if (!loose.some(({ area }) => area >= REAL_AREA)) return null;
  return { held: ringsOf(regions.filter(isHeld)), loose };
}

function shapeOf({ outline }: Region, held: readonly Ring[]): LooseShape {
  const [own, stays] = [boxAround([outline]), boxAround(held)];
  if (own.left >= stays.right - SAME) return "piece";
  // Where both overlap along Z, the one farther from the axis is around the other.
  const beside = held.flat().filter((p) => p.z >= own.left && p.z <= own.right);
  const high = Math.max(...beside.map((p) => p.r));
  if (own.low <= SAME && !(high > own.high)) return "piece";
  return own.high > high ? "ring" : "slug";
}

/** The pieces that came loose, without crumbs. */
export function loosePieces({ step, held, loose }: Parted, steps: readonly Step[]): LoosePiece[] {
  const by = steps[step - 1];
  return loose.flatMap((region) => {
    const rings = ringsOf([region]);
    if (!by || region.area < REAL_AREA) return [];
    const shape = shapeOf(region, held);
    return [
      {
        step,
        block: by.block,
        operation: by.operation,
        shape,
        isPartedOff: shape === "piece" && (isBar(by.tool) || by.operation === null),
        rings,
        area: region.area,
        place: placeIn(region.outline),
      },
    ];
  });
}

/** Depth below the surface at which a loose piece counts as cut, mm. */
const SKIN = 0.05;

/** Loose pieces, prepared for contact checks. */
export interface Loose {
  readonly rings: readonly Ring[];
  readonly edges: Edges;
  /** Without the skin: a tip that runs inside cuts, one along the outside does not. */
  readonly inside: readonly Ring[];
}

/** The work holding of a run, and the pieces that have come off. */
export interface Holding {
  hold(): WorkHold | null;
  /** The blank as it was stated. */
  blank(): readonly Ring[];
  /** The loose pieces before a step. */
  loose(step: number): Loose | null;
  /** Checks before a step whether the stock is in one piece; null: it is. */
  separate(step: number, stock: readonly Ring[]): Parted | null;
  /** Another blank is stated. */
  change(blank: readonly Ring[]): void;
  /** All splits of the run. */
  parted(): readonly Parted[];
}

/** Starts with a blank, held as `piece`; `before`: splits in steps that are not simulated again. */
export function holding(
  blank: readonly Ring[],
  clamping: Clamping | null,
  before: readonly Parted[],
  piece: readonly Ring[] = blank,
): Holding {
  let [now, hold] = [blank, holdOf(piece, clamping)];
  const parted = [...before];
  let since = 0;
  let known: { readonly count: number; readonly loose: Loose } | null = null;
  return {
    hold: () => hold,
    blank: () => now,
    loose(step) {
      if (parted.length === since) return null;
      const fallen = parted.slice(since).filter((each) => each.step <= step);
      if (fallen.length === 0) return null;
      if (known?.count !== fallen.length) {
        const rings = union(fallen.flatMap(({ loose }) => ringsOf(loose)));
        known = { count: fallen.length, loose: { rings, edges: sidesOf(rings), inside: offset(rings, -SKIN) } };
      }
      return known.loose;
    },
    separate(step, stock) {
      const apart = hold && brokenApart(stock, hold),
        found = apart && { step, ...apart };
      if (found) parted.push(found);
      return found;
    },
    change(next) {
      [now, hold, since, known] = [next, holdOf(next, clamping), parted.length, null];
    },
    parted: () => parted,
  };
}

/** The areas of pieces in front of the held part: parts cut off the bar. */
export const partedOffPieces = ({ held, loose }: Parted): Ring[] =>
  ringsOf(loose.filter((region) => shapeOf(region, held) === "piece"));

/** A cut that leaves less than this share of a ring or slug removes it whole: nobody means to turn it. */
const TAKEN_WHOLE = 0.1;

/**
 * The finding of a cut on loose pieces, with the area cut from them. A ring or slug that is removed whole was left by
 * earlier cuts and does not count.
 */
export function onLoosePieces(finding: AnyFinding, pieces: readonly LoosePiece[]): AnyFinding[] {
  const met = pieces
    .filter(({ step }) => step <= finding.step)
    .flatMap((piece) => {
      const taken = withoutSlivers(intersection(finding.rings, piece.rings));
      const isWhole = piece.shape !== "piece" && areaOf(taken) > (1 - TAKEN_WHOLE) * piece.area;
      return isWhole || taken.length === 0 ? [] : [{ taken, by: piece.block }];
    });
  const [first] = met;
  if (!first) return [];
  const rings = met.flatMap(({ taken }) => taken);
  return [{ ...finding, rings, area: areaOf(rings), place: placeIn(largest(rings)), other: first.by }];
}

/** A tip this near to the axis may part off the work, mm. */
const NEAR_AXIS = 2;
/** Whether a motion outside cycles may part the work off by itself. */
const mayPart = ({ tool, from, move }: Step): boolean =>
  isBar(tool) || Math.min(Math.abs(from.r), Math.abs(move.to.r)) < NEAR_AXIS;

/**
 * Whether a cut ends before a step, so that the stock is checked for loose pieces: after an operation, and after a run
 * of feeds or rapids that may part off the work. Other cuts outside cycles are checked together, after the last one of
 * their tool.
 */
export function cutEnds(steps: readonly Step[], index: number): boolean {
  const [before, next] = [steps[index - 1], steps[index]];
  if (!before) return false;
  if (before.operation !== null) return next?.operation !== before.operation;
  if (next?.operation !== null || next.tool !== before.tool) return true;
  return (before.move.kind === "rapid") !== (next.move.kind === "rapid") && mayPart(before);
}

import { areaOf } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { difference, intersection, isInside, offset, union } from "../../kernel/area/clip.ts";
import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import type { ThreadHand } from "../../kernel/time/thread-turns.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { encodedLook, type StockLooks } from "./finish.ts";
import { joinedMeshes, NO_MESH } from "./mesh.ts";
import { profileOf, type Profile } from "./profile.ts";
import { directionsOf, cutFaces, spanOf, type Solid, type Turning } from "./revolve.ts";
import type { ThreadedStock } from "./thread-cuts.ts";
import { threadFloors, type ThreadFloor, type ThreadSide } from "./thread-floor.ts";
import { stripMesh, type Strip } from "./thread-mesh.ts";
import { threadRows, type ThreadRows } from "./thread-rows.ts";

/** How a body with threads is made. */
export interface ThreadTurning extends Turning {
  /** 1: as they were cut; −1 if the picture is a mirror image, so that its threads are mirrored. */
  readonly hand: ThreadHand;
  /** How far a flank may lie from the true one, mm. */
  readonly within: number;
  /** Most corners of the grooves in one piece of the outline. */
  readonly most: number;
}

/**
 * Resolution of threads, on the screen as in a file: tolerance of flanks, mm, and the limit of corners of all of them.
 */
export const THREAD_FINENESS = {
  resting: { within: 0.015, most: 90_000 },
  playing: { within: 0.015, most: 30_000 },
  file: { within: 0.01, most: 1_000_000 },
} as const;

/**
 * Tolerance of a threaded body's section against that of the stock: this share of the grooves, or the tolerance of
 * flanks all along them.
 */
const AREA_TOLERANCE = 0.03;
const isSectionOff = (area: number, grooves: number, cuts: ThreadedStock["cuts"], within: number) =>
  Math.abs(area) >
  Math.max(AREA_TOLERANCE * grooves, within * Math.max(...cuts.map(({ from, move }) => Math.abs(move.to.z - from.z)))) +
    SAME;

type Floors = readonly ThreadFloor[];

/** Outside an outline runs to the left, on the wall of a bore to the right; along a face there is no thread. */
const facing = (p: Pt, q: Pt): ThreadSide | null => {
  if (Math.abs(q.z - p.z) <= SAME) return null;
  return q.z < p.z ? 1 : -1;
};

/** The threads that reach a straight piece of the outline, and their range. */
function reachesOn(p: Pt, q: Pt, floors: Floors) {
  const side = facing(p, q);
  return floors.flatMap((floor) => {
    const reach = side === floor.side ? floor.reach(Math.max(floor.side * p.r, floor.side * q.r)) : null;
    if (!reach) return [];
    const left = Math.max(reach[0], Math.min(p.z, q.z)),
      right = Math.min(reach[1], Math.max(p.z, q.z));
    return right - left > 2 * SAME ? [{ floor, left, right }] : [];
  });
}

/** An outline with corners where grooves begin and end, and where the look beside the grooves changes. */
function parted(ring: Ring, floors: Floors, finish: StockLooks | undefined): Ring {
  return ring.flatMap((p, i) => {
    const q = ring[(i + 1) % ring.length] ?? p,
      found = reachesOn(p, q, floors),
      changes = finish?.changes(p, q) ?? [];
    if (found.length === 0) return [p, ...changes];
    const way = Math.sign(q.z - p.z),
      ends = found.flatMap(({ left, right }) => [left, right]);
    const beside = changes.flatMap(({ z }) =>
      found.every(({ left, right }) => z < left - SAME || z > right + SAME) ? [z] : [],
    );
    const inside = [...beside, ...ends].filter((z) => Math.abs(z - p.z) > SAME && Math.abs(z - q.z) > SAME);
    return [
      p,
      ...inside.sort((a, b) => way * (a - b)).map((z) => at(z, p.r + ((q.r - p.r) * (z - p.z)) / (q.z - p.z))),
    ];
  });
}

interface Surfaces {
  readonly strips: readonly Strip[];
  /** The strips between rows of a thread, with places of each in the half plane of the stock. */
  readonly threadStrips: ReadonlyMap<Strip, readonly Pt[]>;
  /** Rows drawn as lines, with the columns in which they are visible. */
  readonly lines: readonly {
    readonly z: Float64Array;
    readonly r: Float64Array;
    readonly shown: (column: number) => boolean;
  }[];
  /** The outline of a column. */
  readonly outline: (column: number) => Pt[];
}

function rowsOn(profile: Profile, floors: Floors, { chords, within, most }: ThreadTurning) {
  let failed = false;
  const rows = profile.sides.map(([a, b]) => {
    const [p, q] = [profile.points[a]?.p, profile.points[b]?.p],
      [found, other] = p && q ? reachesOn(p, q, floors) : [];
    if (!p || !q || !found) return null;
    const {
        floor,
        floor: { side },
      } = found,
      [low, high] = p.z < q.z ? [p, q] : [q, p];
    const made = threadRows(
      floor,
      { left: low.z, right: high.z, heights: [side * low.r, side * high.r] },
      { chords, within, most },
    );
    // Two threads in one place cannot be drawn.
    failed ||= made === null || other !== undefined;
    return made && { side, rows: made, lead: floor.hand * floor.lead };
  });
  return failed ? null : rows;
}

/** One row of a side, in the direction of the outline. */
function rowOf({ side, rows }: { readonly side: ThreadSide; readonly rows: ThreadRows }, index: number) {
  const { count, columns } = rows,
    own = side === 1 ? count - 1 - index : index;
  const z = rows.z.subarray(own * columns, (own + 1) * columns);
  return {
    z,
    r: rows.height.subarray(own * columns, (own + 1) * columns).map((h) => side * h),
    crest: rows.crests[own] ?? false,
  };
}

const THREAD = encodedLook({ texture: "thread", turnAt: null, tone: null }, at(0, 0));

const same = (n: number, columns: number) => new Float64Array(columns).fill(n);

/** Sample places of a strip, as shares of its width. */
const LOOKS = [0.15, 0.5, 0.85] as const;

/** Where places of a strip would be in the half plane of the stock, from the first quarter in which it has a width. */
function placesOf({ z, r }: Strip, chords: number, lead: number): readonly Pt[] {
  for (const quarter of [0, 0.25, 0.5, 0.75]) {
    const column = Math.round(quarter * chords),
      [za = 0, zb = 0, ra = 0, rb = 0] = [z[0][column], z[1][column], r[0][column], r[1][column]];
    if (Math.hypot(zb - za, rb - ra) > SAME)
      return LOOKS.map((k) => at(za + (zb - za) * k - lead * quarter, ra + (rb - ra) * k));
  }
  return [];
}

/** The surface swept by an outline, with its grooves; null if they are too many. */
function surfacesOf(profile: Profile, floors: Floors, threading: ThreadTurning): Surfaces | null {
  const { points, sides } = profile,
    columns = threading.chords + 1,
    threaded = rowsOn(profile, floors, threading);
  if (!threaded) return null;
  const ends = threaded.map((each) => each && ([rowOf(each, 0), rowOf(each, each.rows.count - 1)] as const));
  /** A corner is as low as the grooves beside it. */
  const cornerOf = (i: number, p: Pt) =>
    ends[i]?.[0].r ?? ends[(i + sides.length - 1) % sides.length]?.[1].r ?? same(p.r, columns);
  const corners = sides.map(([a], i) => cornerOf(i, points[a]?.p ?? at(0, 0)));
  const threadStrips = new Map<Strip, readonly Pt[]>();
  const strips: Strip[] = [],
    lines: Surfaces["lines"][number][] = [];
  const outlines = sides.map(([a, b], i) => {
    const [from, to] = [points[a], points[b]],
      next = (i + 1) % sides.length,
      each = threaded[i];
    if (!from || !to) return [];
    if (!each) {
      const z = [same(from.p.z, columns), same(to.p.z, columns)] as const;
      const look = profile.looks[i],
        looks = [encodedLook(look, from.p), encodedLook(look, to.p)] as const;
      strips.push({
        z,
        r: [corners[i] as Float64Array, corners[next] as Float64Array],
        smooth: [
          [from.nz, from.nr],
          [to.nz, to.nr],
        ],
        looks,
      });
      return [{ z: z[0], r: corners[i] as Float64Array }];
    }
    const rows = Array.from({ length: each.rows.count }, (_, row) => rowOf(each, row));
    rows.slice(1).forEach((row, k) => {
      const before = rows[k] as (typeof rows)[number],
        after = rows[k + 2];
      const strip: Strip = { z: [before.z, row.z], r: [before.r, row.r], smooth: null, looks: [THREAD, THREAD] };
      strips.push(strip);
      threadStrips.set(strip, placesOf(strip, threading.chords, each.lead));
      const falls = (other: typeof before | undefined, c: number) =>
        other !== undefined && each.side * ((row.r[c] ?? 0) - (other.r[c] ?? 0)) > SAME;
      if (row.crest) lines.push({ ...row, shown: (c) => falls(before, c) || falls(after, c) });
    });
    return rows.slice(0, -1);
  });
  for (const place of profile.sharp) {
    const p = points[place]?.p,
      i = sides.findIndex(([a]) => a === place || a === place + 1);
    const r = corners[i];
    if (p && r) lines.push({ z: same(p.z, columns), r, shown: () => true });
  }
  const outline = (column: number): Pt[] => {
    const all = outlines.flat().map(({ z, r }) => at(Math.fround(z[column] ?? 0), Math.fround(r[column] ?? 0)));
    return all.filter((p, i) => {
      const before = all[(i + all.length - 1) % all.length];
      return !before || p.z !== before.z || p.r !== before.r;
    });
  };
  return { strips, threadStrips, lines, outline };
}

function linesOf(
  all: readonly Surfaces[],
  turning: Turning,
  directions: ReturnType<typeof directionsOf>,
): Float32Array {
  const { first, count } = spanOf(turning),
    { chords } = turning,
    out: number[] = [];
  for (const { lines, outline } of all) {
    for (const { z, r, shown } of lines) {
      for (let c = first; c < first + count; c += 1) {
        const [x0, y0] = directions[c % chords] ?? [1, 0],
          [x1, y1] = directions[(c + 1) % chords] ?? [1, 0];
        const [za = 0, zb = 0, ra = 0, rb = 0] = [z[c], z[c + 1], r[c], r[c + 1]];
        if (ra > 0 && (za !== zb || z[0] === z[1]) && shown(c) && shown(c + 1))
          out.push(ra * x0, ra * y0, za, rb * x1, rb * y1, zb);
      }
    }
    if (!turning.quarterCut) continue;
    for (const column of [chords, first]) {
      const points = outline(column),
        [x, y] = directions[column % chords] ?? [1, 0];
      points.forEach((p, i) => {
        const q = points[(i + 1) % points.length] ?? p;
        out.push(p.r * x, p.r * y, p.z, q.r * x, q.r * y, q.z);
      });
    }
  }
  return Float32Array.from(out);
}

/** Coloured rings are wider by this, mm, so that places on their edge lie in them. */
const EDGE = 0.03;

/** A threaded body, and the part of it in another colour. */
export interface ThreadedBody {
  readonly plain: Solid;
  readonly highlighted: Solid | null;
}

/**
 * Splits off the strips inside `rings`, areas of the half plane of the stock between the grooves; for the screen only.
 */
function splitByRings(
  all: readonly Surfaces[],
  rings: readonly Ring[],
  floors: Floors,
  threading: ThreadTurning,
): ThreadedBody {
  const wide = offset(union(rings), EDGE),
    directions = directionsOf(threading.chords),
    { first } = spanOf(threading);
  const isTold = ({ threadStrips }: Surfaces, strip: Strip) =>
    threadStrips.get(strip)?.some((place) => wide.some((ring) => isInside(ring, place))) ?? false;
  const surface = (which: boolean) =>
    joinedMeshes(
      all.map((each) =>
        stripMesh(
          each.strips.filter((s) => isTold(each, s) === which),
          threading,
          directions,
        ),
      ),
    );
  const [standing, lying] = [
    all.map(({ outline }) => outline(threading.chords)),
    all.map(({ outline }) => outline(first)),
  ];
  const on = rings.map((ring) => {
    const { left, right, low, high } = boxAround([ring]);
    const { lead = 0, hand = 1 } =
      floors.find(({ side, reach }) => {
        const ends = reach(side === 1 ? high : -low);
        return ends && ends[0] < right && ends[1] > left;
      }) ?? {};
    return ring.map((p) => at(p.z + (hand * lead) / 4, p.r));
  });
  const faces = (of: typeof intersection) =>
    threading.quarterCut ? cutFaces(of(standing, rings), of(lying, on)) : NO_MESH;
  return {
    plain: { surface: surface(false), section: faces(difference), edges: linesOf(all, threading, directions) },
    highlighted: { surface: surface(true), section: faces(intersection), edges: new Float32Array() },
  };
}

/**
 * A stock with its threads as helices, as in its section. Null if that is impossible, and the rings of the section
 * serve instead: leads that cross each other, threads along a face, too many turns, or a section that differs from that
 * of the stock.
 */
export function threaded(stock: readonly Ring[], threads: ThreadedStock, threading: ThreadTurning): Solid | null {
  return threadedBody(stock, threads, threading)?.plain ?? null;
}

/** The same, with rings of the half plane that grooves cut through as a separate body. */
export function threadedBody(
  stock: readonly Ring[],
  { base, cuts }: ThreadedStock,
  threading: ThreadTurning,
  rings: readonly Ring[] = [],
): ThreadedBody | null {
  const floors = threadFloors(cuts, threading.hand);
  if (!floors) return null;
  const profiles = base.flatMap((ring) => profileOf(parted(ring, floors, threading.finish), threading.finish) ?? []);
  const surfaces = profiles.map((profile) => surfacesOf(profile, floors, threading));
  const all = surfaces.flatMap((each) => each ?? []);
  if (all.length < surfaces.length || all.length === 0) return null;
  const upright = all.map(({ outline }) => outline(threading.chords)),
    [wanted, full] = [areaOf(stock), areaOf(base)];
  if (isSectionOff(areaOf(upright) - wanted, full - wanted, cuts, threading.within)) return null;
  if (rings.length > 0) return splitByRings(all, rings, floors, threading);
  const directions = directionsOf(threading.chords),
    { first } = spanOf(threading);
  const plain: Solid = {
    surface: joinedMeshes(all.map(({ strips }) => stripMesh(strips, threading, directions))),
    section: threading.quarterCut
      ? cutFaces(
          upright,
          all.map(({ outline }) => outline(first)),
        )
      : NO_MESH,
    edges: linesOf(all, threading, directions),
  };
  return { plain, highlighted: null };
}

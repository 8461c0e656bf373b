import { areaOf } from "../../kernel/area.ts";
import { difference, intersection, isInside, offset, union } from "../../kernel/clip.ts";
import { at, type Pt, type Ring } from "../../kernel/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { joinedMeshes, NO_MESH, type Mesh } from "./mesh.ts";
import { profileOf, type Profile } from "./profile.ts";
import { directionsOf, cutFaces, spanOf, type Solid, type Turning } from "./revolve.ts";
import type { ThreadedStock } from "./thread-cuts.ts";
import { threadFloor, type ThreadFloor, type ThreadSide } from "./thread-floor.ts";
import { threadRows, type ThreadRows } from "./thread-rows.ts";

/** How a body with threads is made. */
export interface ThreadTurning extends Turning {
  /** 1: right-handed, as threads are; −1 where the picture is a mirror image. */
  readonly hand: 1 | -1;
  /** How far a flank may lie from the true one, mm. */
  readonly within: number;
  /** Most corners of the grooves in one piece of the outline. */
  readonly most: number;
}

/** The section of a threaded body may miss that of the stock by this much of the grooves. */
const AMISS = 0.03;

interface Floors {
  readonly 1: ThreadFloor | null;
  readonly "-1": ThreadFloor | null;
}

/** Outside an outline runs to the left, on the wall of a bore to the right; along a face there is no thread. */
const facing = (p: Pt, q: Pt): ThreadSide | null => {
  if (Math.abs(q.z - p.z) <= SAME) return null;
  return q.z < p.z ? 1 : -1;
};

/** The grooves that reach a straight piece of the outline, and between which places. */
function reachOn(p: Pt, q: Pt, floors: Floors) {
  const side = facing(p, q), floor = side && floors[side];
  if (!side || !floor) return null;
  const reach = floor.reach(Math.max(side * p.r, side * q.r));
  if (!reach) return null;
  const left = Math.max(reach[0], Math.min(p.z, q.z)), right = Math.min(reach[1], Math.max(p.z, q.z));
  return right - left > SAME ? { side, floor, left, right } : null;
}

/** An outline with corners where grooves begin and end. */
function parted(ring: Ring, floors: Floors): Ring {
  return ring.flatMap((p, i) => {
    const q = ring[(i + 1) % ring.length] ?? p, found = reachOn(p, q, floors);
    if (!found) return [p];
    const places = q.z > p.z ? [found.left, found.right] : [found.right, found.left];
    const inside = places.filter((z) => Math.abs(z - p.z) > SAME && Math.abs(z - q.z) > SAME);
    return [p, ...inside.map((z) => at(z, p.r + ((q.r - p.r) * (z - p.z)) / (q.z - p.z)))];
  });
}

/** A strip between two rows, each with its own direction: place and radius of both at each column. */
interface Strip {
  readonly z: readonly [Float64Array, Float64Array];
  readonly r: readonly [Float64Array, Float64Array];
  /** Directions out of the material at both rows (z, r), for where the strip has no width; null: always its own. */
  readonly smooth: readonly [readonly [number, number], readonly [number, number]] | null;
}

interface Surfaces {
  readonly strips: readonly Strip[];
  /** Of those the ones between rows of a thread, with places of each in the half plane of the stock. */
  readonly told: ReadonlyMap<Strip, readonly Pt[]>;
  /** Rows that are seen as lines, with the columns between which they are. */
  readonly lines: readonly { readonly z: Float64Array; readonly r: Float64Array; readonly shown: (column: number) => boolean }[];
  /** The outline of a column. */
  readonly outline: (column: number) => Pt[];
}

function rowsOn(profile: Profile, floors: Floors, { chords, hand, within, most }: ThreadTurning) {
  let failed = false;
  const rows = profile.sides.map(([a, b]) => {
    const [p, q] = [profile.points[a]?.p, profile.points[b]?.p], found = p && q && reachOn(p, q, floors);
    if (!p || !q || !found) return null;
    const { side, floor } = found, [low, high] = p.z < q.z ? [p, q] : [q, p];
    const made = threadRows(floor, { left: low.z, right: high.z, heights: [side * low.r, side * high.r] }, hand, { chords, within, most });
    failed ||= made === null;
    return made && { side, rows: made, lead: floor.lead };
  });
  return failed ? null : rows;
}

/** One row of a side, in the direction of the outline. */
function rowOf({ side, rows }: { readonly side: ThreadSide; readonly rows: ThreadRows }, index: number) {
  const { count, columns } = rows, own = side === 1 ? count - 1 - index : index;
  const z = rows.z.subarray(own * columns, (own + 1) * columns);
  return { z, r: rows.height.subarray(own * columns, (own + 1) * columns).map((h) => side * h), crest: rows.crests[own] ?? false };
}

const same = (n: number, columns: number) => new Float64Array(columns).fill(n);

/** Where a strip is looked at, as shares of its width. */
const LOOKS = [0.15, 0.5, 0.85] as const;

/** Where places of a strip would be in the half plane of the stock, from the first quarter in which it has a width. */
function placesOf({ z, r }: Strip, chords: number, lead: number): readonly Pt[] {
  for (const quarter of [0, 0.25, 0.5, 0.75]) {
    const column = Math.round(quarter * chords),
      [za = 0, zb = 0, ra = 0, rb = 0] = [z[0][column], z[1][column], r[0][column], r[1][column]];
    if (Math.hypot(zb - za, rb - ra) > SAME) return LOOKS.map((k) => at(za + (zb - za) * k - lead * quarter, ra + (rb - ra) * k));
  }
  return [];
}

/** What an outline sweeps, with its grooves; null where they are too many. */
function surfacesOf(profile: Profile, floors: Floors, threading: ThreadTurning): Surfaces | null {
  const { points, sides } = profile, columns = threading.chords + 1, threaded = rowsOn(profile, floors, threading);
  if (!threaded) return null;
  const ends = threaded.map((each) => each && [rowOf(each, 0), rowOf(each, each.rows.count - 1)] as const);
  /** A corner is as low as the grooves beside it. */
  const cornerOf = (i: number, p: Pt) => ends[i]?.[0].r ?? ends[(i + sides.length - 1) % sides.length]?.[1].r ?? same(p.r, columns);
  const corners = sides.map(([a], i) => cornerOf(i, points[a]?.p ?? at(0, 0)));
  const told = new Map<Strip, readonly Pt[]>();
  const strips: Strip[] = [], lines: Surfaces["lines"][number][] = [];
  const outlines = sides.map(([a, b], i) => {
    const [from, to] = [points[a], points[b]], next = (i + 1) % sides.length, each = threaded[i];
    if (!from || !to) return [];
    if (!each) {
      const z = [same(from.p.z, columns), same(to.p.z, columns)] as const;
      strips.push({ z, r: [corners[i] as Float64Array, corners[next] as Float64Array], smooth: [[from.nz, from.nr], [to.nz, to.nr]] });
      return [{ z: z[0], r: corners[i] as Float64Array }];
    }
    const rows = Array.from({ length: each.rows.count }, (_, row) => rowOf(each, row));
    rows.slice(1).forEach((row, k) => {
      const before = rows[k] as (typeof rows)[number], after = rows[k + 2];
      const strip: Strip = { z: [before.z, row.z], r: [before.r, row.r], smooth: null };
      strips.push(strip);
      told.set(strip, placesOf(strip, threading.chords, threading.hand * each.lead));
      const falls = (other: typeof before | undefined, c: number) =>
        other !== undefined && each.side * ((row.r[c] ?? 0) - (other.r[c] ?? 0)) > SAME;
      if (row.crest) lines.push({ ...row, shown: (c) => falls(before, c) || falls(after, c) });
    });
    return rows.slice(0, -1);
  });
  for (const place of profile.sharp) {
    const p = points[place]?.p, i = sides.findIndex(([a]) => a === place || a === place + 1);
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
  return { strips, told, lines, outline };
}

function meshOf(strips: readonly Strip[], turning: Turning, directions: ReturnType<typeof directionsOf>): Mesh {
  const { first, count } = spanOf(turning), rows = count + 1, { chords } = turning;
  const positions = new Float32Array(6 * strips.length * rows), normals = new Float32Array(positions.length);
  const index = new Uint32Array(6 * strips.length * count);
  let [place, n] = [0, 0];
  const equal = (a: number, b: number) => [0, 1, 2].every((k) => positions[3 * a + k] === positions[3 * b + k]);
  for (const { z, r, smooth } of strips) {
    const begin = place / 3;
    let [nz, nr] = [0, 1];
    const own = (column: number) => {
      const [dz, dr] = [(z[1][column] ?? 0) - (z[0][column] ?? 0), (r[1][column] ?? 0) - (r[0][column] ?? 0)], long = Math.hypot(dz, dr);
      if (long > SAME) [nz, nr] = [dr / long, -dz / long];
    };
    // A strip that begins without width has the direction that it takes on.
    if (!smooth) { for (let column = first + count; column >= first; column -= 1) own(column); }
    for (const k of [0, 1] as const) {
      for (let row = 0; row < rows; row += 1) {
        const column = first + row, [x, y] = directions[column % chords] ?? [1, 0], radius = Math.fround(r[k][column] ?? 0);
        if (smooth) [nz, nr] = smooth[k];
        else own(column);
        positions[place] = radius * x + 0;
        normals[place++] = nr * x;
        positions[place] = radius * y + 0;
        normals[place++] = nr * y;
        positions[place] = (z[k][column] ?? 0) + 0;
        normals[place++] = nz;
      }
    }
    for (let row = 0; row < count; row += 1) {
      const p = begin + row, q = p + rows, far = q + 1, over = p + 1;
      // Where rows end at one place, and on the axis, a triangle may be none.
      if (!equal(p, q) && !equal(q, far) && !equal(p, far)) {
        index[n++] = p;
        index[n++] = q;
        index[n++] = far;
      }
      if (!equal(p, far) && !equal(far, over) && !equal(p, over)) {
        index[n++] = p;
        index[n++] = far;
        index[n++] = over;
      }
    }
  }
  return { positions, normals, index: index.slice(0, n) };
}

function linesOf(all: readonly Surfaces[], turning: Turning, directions: ReturnType<typeof directionsOf>): Float32Array {
  const { first, count } = spanOf(turning), { chords } = turning, out: number[] = [];
  for (const { lines, outline } of all) {
    for (const { z, r, shown } of lines) {
      for (let c = first; c < first + count; c += 1) {
        const [x0, y0] = directions[c % chords] ?? [1, 0], [x1, y1] = directions[(c + 1) % chords] ?? [1, 0];
        const [za = 0, zb = 0, ra = 0, rb = 0] = [z[c], z[c + 1], r[c], r[c + 1]];
        if (ra > 0 && (za !== zb || z[0] === z[1]) && shown(c) && shown(c + 1)) out.push(ra * x0, ra * y0, za, rb * x1, rb * y1, zb);
      }
    }
    if (!turning.quarterCut) continue;
    for (const column of [chords, first]) {
      const points = outline(column), [x, y] = directions[column % chords] ?? [1, 0];
      points.forEach((p, i) => {
        const q = points[(i + 1) % points.length] ?? p;
        out.push(p.r * x, p.r * y, p.z, q.r * x, q.r * y, q.z);
      });
    }
  }
  return Float32Array.from(out);
}

/** Rings told by colour are this much wider, mm, so that what lies on their edge lies in them. */
const EDGE = 0.03;

/** A threaded body, and what of it is told by colour. */
export interface ThreadedBody {
  readonly plain: Solid;
  readonly told: Solid | null;
}

/** Takes what lies in `rings`, areas of the half plane of the stock between the grooves, apart from the rest; for the screen only. */
function toldApart(all: readonly Surfaces[], rings: readonly Ring[], lead: number, threading: ThreadTurning): ThreadedBody {
  const wide = offset(union(rings), EDGE), directions = directionsOf(threading.chords), { first } = spanOf(threading);
  const isTold = ({ told }: Surfaces, strip: Strip) =>
    told.get(strip)?.some((place) => wide.some((ring) => isInside(ring, place))) ?? false;
  const surface = (which: boolean) =>
    joinedMeshes(all.map((each) => meshOf(each.strips.filter((s) => isTold(each, s) === which), threading, directions)));
  const [standing, lying] = [all.map(({ outline }) => outline(threading.chords)), all.map(({ outline }) => outline(first))];
  const on = rings.map((ring) => ring.map((p) => at(p.z + (threading.hand * lead) / 4, p.r)));
  const faces = (of: typeof intersection) => threading.quarterCut ? cutFaces(of(standing, rings), of(lying, on)) : NO_MESH;
  return {
    plain: { surface: surface(false), section: faces(difference), edges: linesOf(all, threading, directions) },
    told: { surface: surface(true), section: faces(intersection), edges: new Float32Array() },
  };
}

/**
 * A stock with its threads as helices, as they lie in its section. Null where that is not to be had, and the rings of the section have to
 * do: leads that cross each other, threads along a face, too many turns, or a section that would not be that of the stock.
 */
export function threaded(stock: readonly Ring[], threads: ThreadedStock, threading: ThreadTurning): Solid | null {
  return threadedBody(stock, threads, threading)?.plain ?? null;
}

/** The same, in which rings of the half plane that grooves are cut through are a body of their own. */
export function threadedBody(
  stock: readonly Ring[],
  { base, cuts }: ThreadedStock,
  threading: ThreadTurning,
  rings: readonly Ring[] = [],
): ThreadedBody | null {
  const floors: Floors = { 1: threadFloor(cuts, 1, threading.hand), "-1": threadFloor(cuts, -1, threading.hand) };
  const profiles = base.flatMap((ring) => profileOf(parted(ring, floors)) ?? []);
  const surfaces = profiles.map((profile) => surfacesOf(profile, floors, threading));
  const all = surfaces.flatMap((each) => each ?? []);
  if (all.length < surfaces.length || all.length === 0) return null;
  const upright = all.map(({ outline }) => outline(threading.chords)), [wanted, full] = [areaOf(stock), areaOf(base)];
  if (Math.abs(areaOf(upright) - wanted) > AMISS * (full - wanted) + SAME) return null;
  if (rings.length > 0) return toldApart(all, rings, (floors[1] ?? floors["-1"])?.lead ?? 0, threading);
  const directions = directionsOf(threading.chords), { first } = spanOf(threading);
  const plain: Solid = {
    surface: joinedMeshes(all.map(({ strips }) => meshOf(strips, threading, directions))),
    section: threading.quarterCut ? cutFaces(upright, all.map(({ outline }) => outline(first))) : NO_MESH,
    edges: linesOf(all, threading, directions),
  };
  return { plain, told: null };
}

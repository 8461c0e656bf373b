import { NOTHING, SAME } from "../../kernel/tolerance.ts";
import type { ThreadFloor, HelixTrack } from "./thread-floor.ts";

/** A straight piece of an outline that grooves run into, from left to right; heights as in the floor of a thread. */
export interface ThreadedSide {
  readonly left: number;
  readonly right: number;
  /** Height of the surface that was turned, at both ends. */
  readonly heights: readonly [number, number];
}

/**
 * A surface in rows that follow the thread: place along Z and height of each row at each chord of a turn, row by row.
 */
export interface ThreadRows {
  readonly count: number;
  readonly columns: number;
  readonly z: Float64Array;
  readonly height: Float64Array;
  /** Rows along which two flanks, or a flank and a crest, meet in a convex edge. */
  readonly crests: readonly boolean[];
}

/** Resolution of grooves. */
export interface ThreadFineness {
  /** Chords of a turn. */
  readonly chords: number;
  /** How far a flank may lie from the true one, mm. */
  readonly within: number;
  /** Most corners of the surface of one piece. */
  readonly most: number;
}

/** Samples per lead, besides the corners of an insert. */
const LOOKS = 48;
/** A bend of more than this is an edge, radians. */
const EDGE = 0.35;
/** Rows are never nearer than this part of a lead. */
const CLOSEST = 0.002;

interface Place {
  readonly z: number;
  readonly height: number;
}

/** The points of a line that are needed to keep it within `within` of its original. */
function needed(line: readonly Place[], within: number): readonly Place[] {
  const first = line[0],
    last = line.at(-1);
  if (!first || !last || line.length < 3) return line;
  let far = within,
    at = 0;
  const [dz, dh] = [last.z - first.z, last.height - first.height],
    long = Math.hypot(dz, dh) || 1;
  line.forEach((p, i) => {
    const away = Math.abs(dz * (p.height - first.height) - dh * (p.z - first.z)) / long;
    if (away > far) [far, at] = [away, i];
  });
  if (at === 0) return [first, last];
  return [...needed(line.slice(0, at + 1), within), ...needed(line.slice(at), within).slice(1)];
}

type Places = readonly Place[];

/** One lead of a surface from a place on; `floorAt`: the grooves in it. */
function leadFrom(
  floor: ThreadFloor,
  begin: number,
  surface: (z: number) => number,
  floorAt: (z: number) => number,
): Places {
  const { lead } = floor;
  const looks = Array.from({ length: LOOKS }, (_, i) => begin + (i * lead) / LOOKS);
  const all = [...looks, ...floor.bends(begin, surface(begin + lead / 2))]
    .sort((p, q) => p - q)
    .filter((z, i, list) => i === 0 || z - (list[i - 1] ?? 0) > CLOSEST * lead);
  return [...all, begin + lead].map((z): Place => ({ z, height: Math.min(surface(z), floorAt(z)) }));
}

/**
 * One lead of the thread in the surface of a side, as the places needed to show it; the last one is the first of the
 * next lead.
 */
function period(floor: ThreadFloor, { left, right, heights: [a, b] }: ThreadedSide, within: number): Places {
  const { lead } = floor,
    slope = (b - a) / (right - left);
  const begin = Math.min(Math.max(floor.middle, left), Math.max(left, right - lead));
  const surface = (z: number) => a + slope * (z - left),
    over = (p: Place | undefined) => (p ? p.height - surface(p.z) : -Infinity);
  const line = leadFrom(floor, begin, surface, floor.endless);
  // It begins at its highest place, so that no crest is lost between two leads.
  const top = line.slice(0, -1).reduce((best, p, i) => (over(p) > over(line[best]) ? i : best), 0);
  const on = (p: Place): Place => ({ z: p.z + lead, height: p.height + slope * lead });
  const first = needed([...line.slice(top, -1), ...line.slice(0, top + 1).map(on)], within);
  if (floor.slope !== null && Math.abs(floor.slope - slope) * (right - left) < within) return first;
  return extraPlaces(first, floor, { left, right, surface, within });
}

/** Number of leads sampled if no two are alike. */
const WINDOWS = 8;

/** Extra places of a lead: those needed elsewhere in the thread, where grooves are less deep. */
function extraPlaces(
  first: Places,
  floor: ThreadFloor,
  {
    left,
    right,
    surface,
    within,
  }: {
    readonly left: number;
    readonly right: number;
    readonly surface: (z: number) => number;
    readonly within: number;
  },
): Places {
  const { lead } = floor,
    begin = first[0]?.z ?? left,
    count = Math.max(1, Math.min(WINDOWS, Math.floor((right - left) / lead)));
  const more = Array.from(
    { length: count },
    (_, i) => left + ((right - lead - left) * i) / Math.max(1, count - 1),
  ).flatMap((from) =>
    needed(
      leadFrom(floor, from, surface, (z) => floor.at(z, 0)),
      within,
    ).map(({ z }) => z - lead * Math.floor((z - begin) / lead)),
  );
  const own = first.slice(0, -1),
    near = (z: number, list: Places) => list.some((p) => Math.abs(p.z - z) < 2 * CLOSEST * lead);
  const added = more.reduce(
    (list: Places, z) =>
      near(z, list) || near(z, first)
        ? list
        : [
            ...list,
            {
              z,
              height: Math.min(surface(z), floor.endless(z)),
            },
          ],
    [],
  );
  return [...[...own, ...added].sort((p, q) => p.z - q.z), ...first.slice(-1)];
}

/** Which places of a period stand out as edges. */
function crestsOf(line: readonly Place[]): readonly boolean[] {
  const count = line.length - 1,
    way = (i: number) => {
      const [p, q] = [line[(i + count) % count], line[((i + count) % count) + 1]];
      return p && q ? Math.atan2(q.height - p.height, q.z - p.z) : 0;
    };
  return Array.from({ length: count }, (_, i) => way(i - 1) - way(i) > EDGE);
}

function lowest(tracks: readonly HelixTrack[], share: number, most: number): number {
  let least = most;
  for (const t of tracks) {
    if (share < t.from || share > t.to) continue;
    const height = t.height + t.rise * share;
    if (height < least) least = height;
  }
  return least;
}

/** Removes redundant tracks: of those that go all round and rise alike the lowest one is enough. */
function fewer(tracks: readonly HelixTrack[]): readonly HelixTrack[] {
  const whole: HelixTrack[] = [],
    rest: HelixTrack[] = [];
  for (const t of tracks) {
    if (t.from > 0 || t.to < 1) rest.push(t);
    else {
      const i = whole.findIndex((w) => Math.abs(w.rise - t.rise) < NOTHING),
        same = whole[i];
      if (!same) whole.push(t);
      else if (t.height < same.height) whole[i] = t;
    }
  }
  return [...whole, ...rest];
}

/** Fewest rows that are a thread: two crests or roots and what lies between. */
const LEAST_ROWS = 2;

/** The surface of a side with its grooves; null where that would be too many rows. */
export function threadRows(floor: ThreadFloor, side: ThreadedSide, fine: ThreadFineness): ThreadRows | null {
  const {
      left,
      right,
      heights: [a, b],
    } = side,
    { lead, hand } = floor,
    { chords } = fine;
  const slope = (b - a) / (right - left),
    leads = (right - left) / lead + 1;
  let line = period(floor, side, fine.within);
  for (let coarse = fine.within * 2; leads * (line.length - 1) * chords > fine.most; coarse *= 2) {
    const next = period(floor, side, coarse);
    if (next.length - 1 < LEAST_ROWS || coarse > lead) return null;
    line = next;
  }
  const each = line.length - 1,
    crest = crestsOf(line),
    offset = line[0]?.z ?? 0;
  const first = Math.floor((left - offset) / lead) - 2,
    last = Math.ceil((right - offset) / lead) + 1;
  const count = (last - first + 1) * each + 2,
    columns = chords + 1;
  const z = new Float64Array(count * columns),
    height = new Float64Array(count * columns);
  const ends = Array.from(
    { length: chords },
    (_, c) => [Math.min(a, floor.at(left, c / chords)), Math.min(b, floor.at(right, c / chords))] as const,
  );
  const put = (row: number, column: number, place: number, high: number) => {
    z[row * columns + column] = place;
    height[row * columns + column] = high;
  };
  for (let row = 0; row < count; row += 1) {
    const k = first + Math.floor((row - 1) / each),
      own = line[(row - 1 + each) % each]?.z ?? offset;
    const isEnd = row === 0 || row === count - 1,
      flat = own + k * lead;
    const away = Math.max(flat, flat + hand * lead) < left || Math.min(flat, flat + hand * lead) > right;
    const tracks = isEnd || away ? [] : fewer(floor.tracks(flat));
    for (let c = 0; c < chords; c += 1) {
      const share = c / chords,
        there = own + (k + hand * share) * lead,
        [low, high] = ends[c] ?? [a, b];
      if (row === 0 || (row < count - 1 && there <= left + SAME)) put(row, c, left, low);
      else if (row === count - 1 || there >= right - SAME) put(row, c, right, high);
      else {
        const stopped = floor.stopsAt(there);
        put(row, c, there, Math.min(stopped, lowest(tracks, share, a + slope * (there - left))));
      }
    }
  }
  // After a whole turn every row has become the next one of its kind.
  for (let row = 0; row < count; row += 1) {
    const isEnd = row === 0 || row === count - 1,
      next = isEnd ? row : Math.min(count - 1, Math.max(0, row + hand * each));
    put(row, chords, z[next * columns] ?? left, height[next * columns] ?? a);
  }
  return {
    count,
    columns,
    z,
    height,
    crests: Array.from({ length: count }, (_, row) => crest[(row - 1 + each) % each] ?? false),
  };
}

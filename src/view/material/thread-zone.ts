import type { ThreadHand } from "../../kernel/time/thread-turns.ts";
import type { Camera } from "../camera.ts";
import type { Boundary, SurfaceEdge } from "./scan.ts";

/** A stretch of the boundary with the grooves of a thread. */
export interface ThreadZone {
  readonly left: number;
  readonly right: number;
  readonly lead: number;
  readonly hand: ThreadHand;
  /** On a wall of a hollow, or on the outside. */
  readonly isInside: boolean;
  /** The profile in the plane of the cut, from left to right, mm. */
  readonly profile: readonly { readonly z: number; readonly r: number }[];
}

/** The crest between two grooves may be longer than a lead by this factor. */
const LOOSE = 1.2;

const runsLeft = (edges: readonly SurfaceEdge[]) => edges.reduce((sum, e) => sum + e.z1 - e.z0, 0) < 0;

function zoneOf(edges: readonly SurfaceEdge[]): ThreadZone {
  const isOutside = runsLeft(edges);
  const forward = edges.flatMap((e, i) =>
    i === 0
      ? [
          { z: e.z0, r: e.r0 },
          { z: e.z1, r: e.r1 },
        ]
      : [{ z: e.z1, r: e.r1 }],
  );
  const profile = isOutside ? forward.reverse() : forward;
  const lead = Math.max(...edges.map((e) => (e.made.texture === "thread" ? e.made.pitch : 0)));
  const hand = edges.find((e) => e.made.texture === "thread")?.made.hand ?? 1;
  const places = profile.map((p) => p.z);
  return { left: Math.min(...places), right: Math.max(...places), lead, hand, isInside: !isOutside, profile };
}

/** The threads in a boundary: runs of edges in which grooves follow each other within a lead. */
export function threadZones({ edges }: Boundary): readonly ThreadZone[] {
  const out: ThreadZone[] = [];
  let first = -1,
    last = -1;
  const close = () => {
    if (first >= 0) out.push(zoneOf(edges.slice(first, last + 1)));
    first = -1;
  };
  edges.forEach((e, i) => {
    const before = edges[i - 1],
      begun = edges[first];
    const follows = before && before.z1 === e.z0 && before.r1 === e.r0;
    // Round the end of the work another thread may begin.
    const turnsBack = begun && (e.z1 - e.z0) * (begun.z1 - begun.z0) < 0;
    if (!follows || turnsBack) close();
    if (e.made.texture !== "thread") return;
    const groove = first >= 0 ? edges[last] : undefined;
    if (groove && Math.abs(e.z0 - groove.z1) > LOOSE * e.made.pitch) close();
    if (first < 0) first = i;
    last = i;
  });
  close();
  return out;
}

/** Points of a drawn helix per half turn. */
const PIECES = 14;

/** The visible part of the half turn: 0 in the plane of the cut, on the tool's side, 1 opposite to it. */
export type HalfTurn = readonly [from: number, to: number];

/** A place on the screen. */
export type ScreenPoint = readonly [x: number, y: number];

/**
 * The curve of a point of the profile on the body. On a right-handed thread the front, seen from the side, runs to the
 * right on its way down, whichever side the tool is on; the far wall of a hole shows the other half of the turn.
 */
export function helix(
  camera: Camera,
  { lead, hand, isInside }: ThreadZone,
  p: { readonly z: number; readonly r: number },
  [from, to]: HalfTurn,
) {
  const { scale, zero, xUp } = camera,
    side = xUp ? -1 : 1,
    along = ((hand * lead) / 2) * (xUp ? 1 : -1) * (isInside ? -1 : 1);
  return Array.from({ length: PIECES + 1 }, (_, i): ScreenPoint => {
    const turn = from + ((to - from) * i) / PIECES;
    return [zero.x + (p.z + along * turn) * scale, zero.y + side * Math.cos(turn * Math.PI) * p.r * scale];
  });
}

/** A visible flank: facing the free end or away from it. */
export interface Flank {
  readonly looksRight: boolean;
  readonly outline: readonly ScreenPoint[];
}

/** The flanks of a zone over a part of the half turn, and the line of each crest and root between them. */
export function flanksOf(
  camera: Camera,
  zone: ThreadZone,
  seen: HalfTurn,
): { readonly flanks: readonly Flank[]; readonly crests: readonly (readonly ScreenPoint[])[] } {
  const flanks: Flank[] = [],
    crests: (readonly ScreenPoint[])[] = [];
  const { profile, isInside } = zone;
  let i = 0;
  while (i + 1 < profile.length) {
    const sign = directionAt(profile, i);
    let end = i + 1;
    while (end + 1 < profile.length && directionAt(profile, end) === sign) end += 1;
    const [a, b] = [profile[i], profile[end]];
    if (a && b && sign !== 0) {
      const [one, other] = [helix(camera, zone, a, seen), helix(camera, zone, b, seen)];
      flanks.push({ looksRight: sign < 0 !== isInside, outline: [...one, ...[...other].reverse()] });
      crests.push(sign < 0 !== isInside ? one : other);
    }
    i = end;
  }
  return { flanks, crests };
}

function directionAt(profile: ThreadZone["profile"], i: number): number {
  const [a, b] = [profile[i], profile[i + 1]];
  return a && b ? Math.sign(b.r - a.r) : 0;
}

/**
 * The edge of the body at one end of the half turn, as a line from left to right; it continues level beyond the zone.
 */
export function silhouette(camera: Camera, zone: ThreadZone, turn: 0 | 1): readonly ScreenPoint[] {
  const { profile, lead } = zone,
    [first, last] = [profile[0], profile.at(-1)];
  const places = first && last ? [{ z: first.z - lead, r: first.r }, ...profile, { z: last.z + lead, r: last.r }] : [];
  const { scale, zero, xUp } = camera,
    side = xUp ? -1 : 1,
    along = (turn * zone.hand * lead * (xUp ? 1 : -1) * (zone.isInside ? -1 : 1)) / 2;
  return places.map(
    (p) => [zero.x + (p.z + along) * scale, zero.y + (turn === 0 ? side : -side) * p.r * scale] as const,
  );
}

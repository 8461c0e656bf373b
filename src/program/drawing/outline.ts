import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { FULL_TURN } from "../../kernel/geometry/segments.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { edgeIndex, endNode, facesOf, segmentAlong, startNode, turned, type Faces, type Way } from "./faces.ts";
import type { Edge } from "./graph.ts";
import { TOUCHING } from "./halves.ts";

/** Places nearer than this along the axis are in one face of the part, mm. */
const LEVEL = 2 * TOUCHING;

/** A run along the boundary of a piece, and what belongs to it. */
export interface BoundaryRun {
  readonly segments: readonly Segment[];
  readonly sources: ReadonlySet<number>;
  /** Nodes between the segments, the ends included. */
  readonly nodes: readonly number[];
}

/** The boundaries of a piece: its outside from the front face to the rear one, and its bore if it has one. */
export interface Outline {
  readonly outside: BoundaryRun;
  readonly bore: BoundaryRun | null;
  /** Sources of all lines around the piece, the faces at its ends included. */
  readonly around: ReadonlySet<number>;
  /** Place of a face at the rear end that leads to the axis and is left out; null where there is none. */
  readonly rearFace: number | null;
}

const isUpright = (e: Edge) => e.segment.kind === "line" && Math.abs(e.segment.from.z - e.segment.to.z) <= LEVEL;

/** Edges that are seen through a bore: the faces between them and the axis touch the outside at most with a face. */
function withoutHollow(edges: readonly Edge[]): readonly Edge[] {
  const { faces, faceOf, outer } = facesOf(edges);
  const isHollow = faces.map((face, i) => {
    if (i === outer || !face.some((way) => edges[edgeIndex(way)]?.isAxis)) return false;
    return face.every((way) => {
      const e = edges[edgeIndex(way)];
      return e !== undefined && (e.isAxis || faceOf[turned(way)] !== outer || isUpright(e));
    });
  });
  const isSolid = isHollow.some((hollow, i) => !hollow && i !== outer);
  if (!isSolid || !isHollow.includes(true)) return edges;
  return edges.filter((_, i) => {
    const [left, right] = [faceOf[2 * i] ?? outer, faceOf[2 * i + 1] ?? outer],
      isOpen = (f: number) => f === outer || isHollow[f] === true;
    return !(isOpen(left) && isOpen(right) && (isHollow[left] === true || isHollow[right] === true));
  });
}

/** The ways of a walk without those that go and come back, and without the axis. */
function withoutSpurs(edges: readonly Edge[], walk: readonly Way[]): Way[] {
  const out: Way[] = [];
  for (const way of walk) {
    if (edges[edgeIndex(way)]?.isAxis) continue;
    if (out.at(-1) === turned(way)) out.pop();
    else out.push(way);
  }
  return out;
}

/** Segments of a run in order: what was divided is whole again. */
function runOf(edges: readonly Edge[], ways: readonly Way[]): BoundaryRun {
  const segments: Segment[] = [],
    nodes: number[] = [],
    sources = new Set<number>();
  let last = -1;
  for (const way of ways) {
    const s = segmentAlong(edges, way),
      source = edges[edgeIndex(way)]?.source ?? -1,
      before = segments.at(-1);
    if (!s) continue;
    sources.add(source);
    if (nodes.length === 0) nodes.push(startNode(edges, way));
    const whole = before && source === last ? continued(before, s) : null;
    if (whole) {
      segments[segments.length - 1] = whole;
      nodes[nodes.length - 1] = endNode(edges, way);
    } else {
      segments.push(s);
      nodes.push(endNode(edges, way));
    }
    last = source;
  }
  return { segments, sources, nodes };
}

/** Two parts of one line or arc as one; null where they turn back or leave no end. */
function continued(a: Segment, b: Segment): Segment | null {
  if (part.apart(a.to, b.from) > TOUCHING) return null;
  if (a.kind === "line" && b.kind === "line")
    return part.dot(part.difference(a.to, a.from), part.difference(b.to, b.from)) > 0 ? part.line(a.from, b.to) : null;
  if (a.kind !== "arc" || b.kind !== "arc" || a.turn !== b.turn || part.apart(a.centre, b.centre) > SAME) return null;
  return part.sweepOf(a) + part.sweepOf(b) < FULL_TURN - 0.1 ? { ...a, to: b.to } : null;
}

/** The node at the right end: of those, the nearest to the axis; or at the left end, by `sign` −1. */
function lastNode(nodes: readonly number[], place: (n: number) => Pt, sign: 1 | -1): number {
  const far = nodes.reduce((most, n) => Math.max(most, sign * place(n).z), -Infinity);
  return nodes
    .filter((n) => sign * place(n).z >= far - LEVEL)
    .reduce((best, n) => (place(n).r < place(best).r ? n : best));
}

/** The walk around a piece counter-clockwise: along its outside from right to left. */
function walkOf({ edges, faces, outer }: Faces): Way[] {
  const around = (faces[outer] ?? []).map(turned).toReversed();
  return around.filter((way) => edges[edgeIndex(way)] !== undefined);
}

/** The ways from a node on, until a place is reached. */
function until(edges: readonly Edge[], walk: readonly Way[], start: number, isEnd: (node: number) => boolean): Way[] {
  const first = walk.findIndex((way) => startNode(edges, way) === start),
    out: Way[] = [];
  for (let i = 0; i < walk.length; i += 1) {
    const way = walk[(first + i) % walk.length];
    if (way === undefined) break;
    out.push(way);
    if (isEnd(endNode(edges, way))) break;
  }
  return out;
}

/** Leaves out the face at the end of a run that leads down to the axis. */
function withoutRearFace(ways: readonly Way[], edges: readonly Edge[], place: (n: number) => Pt) {
  let count = ways.length;
  const last = ways[count - 1];
  if (last === undefined || place(endNode(edges, last)).r > TOUCHING) return { ways, face: null };
  const rear = place(endNode(edges, last)).z;
  for (; count > 1; count -= 1) {
    const way = ways[count - 1] ?? 0,
      e = edges[edgeIndex(way)];
    const falls = place(endNode(edges, way)).r < place(startNode(edges, way)).r;
    if (!e || !isUpright(e) || !falls || Math.abs(place(endNode(edges, way)).z - rear) > LEVEL) break;
  }
  return count === ways.length ? { ways, face: null } : { ways: ways.slice(0, count), face: rear };
}

/** The walk around connected edges, and where it begins and ends. */
interface Boundary {
  readonly edges: readonly Edge[];
  readonly walk: readonly Way[];
  readonly start: number;
  readonly isEnd: (node: number) => boolean;
  readonly closed: boolean;
}

function boundaryOf(edges: readonly Edge[], place: (n: number) => Pt): Boundary | null {
  const drawn = edges.filter((e) => !e.isAxis);
  if (drawn.length === 0) return null;
  const faces = facesOf(edges),
    walk = walkOf(faces),
    closed = faces.faces.length > 1;
  const ways = walk.filter((way) => !edges[edgeIndex(way)]?.isAxis),
    met = [...new Set(ways.flatMap((way) => [startNode(edges, way), endNode(edges, way)]))],
    degree = new Map<number, number>();
  for (const e of drawn) for (const n of [e.from, e.to]) degree.set(n, (degree.get(n) ?? 0) + 1);
  const leaves = met.filter((n) => degree.get(n) === 1);
  if (met.length === 0) return null;
  const start = lastNode(closed || leaves.length === 0 ? met : leaves, place, 1),
    rear = place(lastNode(met, place, -1)).z,
    other = leaves.find((n) => n !== start);
  const isChain = !closed && leaves.length === 2;
  const isEnd = (n: number) => (isChain ? n === other : place(n).z <= rear + LEVEL);
  return { edges, walk, start, isEnd, closed };
}

const sourcesAround = ({ edges, walk }: Boundary): number[] =>
  withoutSpurs(edges, walk).flatMap((way) => edges[edgeIndex(way)]?.source ?? []);

/**
 * The outside and the bore of a connected piece of a half: what is inside of it (shoulders, edges seen through a bore,
 * threads) is not part of them. Runs begin at the right end, nearest to the axis; the outside of a part without a
 * through bore begins on the axis where it has a face there. Null for no lines at all.
 */
export function outlineOf(all: readonly Edge[], nodes: readonly Pt[]): Outline | null {
  const place = (n: number) => nodes[n] ?? at(0, 0);
  const edges = withoutHollow(all),
    isThrough = edges.every((e) => place(e.from).r > TOUCHING && place(e.to).r > TOUCHING);
  const solid = boundaryOf(edges, place),
    outer = isThrough ? solid : boundaryOf(all, place);
  if (!solid || !outer) return null;
  const whole = until(outer.edges, outer.walk, outer.start, outer.isEnd),
    { ways, face } = withoutRearFace(withoutSpurs(outer.edges, whole), outer.edges, place);
  const isInside = (n: number) => solid.isEnd(n) || place(n).r <= TOUCHING,
    back = solid.walk.map(turned).toReversed(),
    inside =
      solid.closed && place(solid.start).r > TOUCHING
        ? withoutSpurs(edges, until(edges, back, solid.start, isInside))
        : [];
  const outside = runOf(outer.edges, ways),
    bore = inside.length > 0 ? runOf(edges, inside) : null;
  return {
    outside,
    bore,
    // The walk around an open run only goes and comes back.
    around: new Set([...outside.sources, ...(bore?.sources ?? []), ...[outer, solid].flatMap(sourcesAround)]),
    rearFace: face,
  };
}

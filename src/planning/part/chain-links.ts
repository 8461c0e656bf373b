import { areaOf } from "../../kernel/area/area.ts";
import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { CHORD, SAME } from "../../kernel/tolerance.ts";
import type { Chain, ElementMark } from "../types.ts";

/** An element of a side with its mark. */
export interface Link {
  readonly segment: Segment;
  readonly mark: ElementMark;
}
export type Links = readonly Link[];

export const segmentsOf = (links: Links): readonly Segment[] => links.map((l) => l.segment);
const hasRoughness = ({ roughness, rz }: ElementMark) => roughness !== undefined || rz !== undefined;
/** A chain of links; `general` is the roughness of elements without their own. */
export const chainOf = (links: Links, general: Omit<ElementMark, "row"> = {}): Chain => ({
  segments: segmentsOf(links),
  marks: links.map(({ mark }) => (hasRoughness(mark) ? mark : { ...general, ...mark })),
});
export const pointsOf = (links: Links): Pt[] => part.flattenedChain(segmentsOf(links), CHORD);
export const firstPoint = (links: Links): Pt | undefined => links[0]?.segment.from;
export const lastPoint = (links: Links): Pt | undefined => links.at(-1)?.segment.to;

export const reversed = (links: Links): Links =>
  links.map(({ segment, mark }) => ({ segment: part.reversed(segment), mark })).toReversed();

const near = (a: number, b: number) => Math.abs(a - b) <= SAME;
const hasLength = ({ segment }: Link) => part.apart(segment.from, segment.to) > SAME || segment.kind === "arc";
/** Whether an element runs along the axis. */
const onAxis = ({ segment: { kind, from, to } }: Link) => kind === "line" && from.r <= SAME && to.r <= SAME;
const inPlane = ({ segment: { kind, from, to } }: Link, z: number) =>
  kind === "line" && near(from.z, z) && near(to.z, z);
const rearOf = (links: Links) => links.reduce((least, { segment: s }) => Math.min(least, part.boxOf(s).left), Infinity);

/** A straight element that no row states. It has no marks but the row of its neighbour. */
export const lineTo = (from: Pt, to: Pt, { mark: { row } }: Link): Link => ({
  segment: part.line(from, to),
  mark: { row },
});

/** Runs of elements from the front face to the rear. */
const fromFront = (links: Links): Links => {
  const [first, last] = [firstPoint(links), lastPoint(links)];
  return first && last && first.z < last.z - SAME ? reversed(links) : links;
};

/** Without elements along the axis at its ends. */
function withoutAxis(links: Links): Links {
  const begin = links.findIndex((l) => !onAxis(l)),
    end = links.findLastIndex((l) => !onAxis(l));
  return begin < 0 ? [] : links.slice(begin, end + 1);
}

/** Whether an outline is closed, or returns to the plane of its beginning unless it is open: it has the bore, too. */
const returns = (links: Links, isOpen: boolean): boolean => {
  const [first, last] = [firstPoint(links), lastPoint(links)];
  if (!first || !last || links.length < 3) return false;
  return (
    part.apart(first, last) <= SAME ||
    (!isOpen && near(first.z, last.z) && rearOf(links) < first.z - SAME && last.r > SAME)
  );
};

/** A closed outline as its outside and its bore, both from the front face. */
function divided(links: Links): { readonly outside: Links; readonly inside: Links } {
  const [first, last] = [firstPoint(links), lastPoint(links)],
    [begin] = links;
  if (!first || !last || !begin) return { outside: links, inside: [] };
  const closed = part.apart(first, last) > SAME ? [...links, lineTo(last, first, begin)] : links;
  const round = (areaOf([pointsOf(closed)]) < 0 ? reversed(closed) : closed).filter((l) => !onAxis(l));
  const start = round.reduce((best, { segment: { from } }, i) => {
    const now = round[best]?.segment.from ?? from;
    return from.z > now.z + SAME || (near(from.z, now.z) && from.r < now.r - SAME) ? i : best;
  }, 0);
  const loop = [...round.slice(start), ...round.slice(0, start)],
    rear = rearOf(loop),
    end = loop.findIndex(({ segment: { to } }) => to.z <= rear + SAME);
  const behind = loop.slice(end + 1),
    face = behind.findIndex((l) => !inPlane(l, rear));
  return { outside: loop.slice(0, end + 1), inside: face < 0 ? [] : reversed(behind.slice(face)) };
}

/** Without the rear face that leads to the axis or to the bore. */
function withoutRearFace(links: Links): Links {
  const rear = rearOf(links);
  const end = links.findLastIndex((l) => !(inPlane(l, rear) && l.segment.to.r < l.segment.from.r));
  return links.slice(0, Math.max(end, 0) + 1);
}

/**
 * Outside and bore as typed, from the front face to the rear; faces may be missing. `isOpen`: the outside ends in the
 * blank, not at a rear face.
 */
export function orientedSides(
  outside: Links,
  inside: Links,
  isOpen: boolean,
): { readonly outside: Links; readonly inside: Links } {
  if (inside.length === 0 && returns(withoutAxis(outside), isOpen)) return divided(withoutAxis(outside));
  return { outside: withoutRearFace(withoutAxis(fromFront(outside))), inside: withoutAxis(fromFront(inside)) };
}

/** The links of a chain from a point on it. */
const since = (links: Links, p: Pt, i: number): Links =>
  links
    .slice(i)
    .map((l, k) => (k === 0 ? { ...l, segment: { ...l.segment, from: p } } : l))
    .filter(hasLength);
const until = (links: Links, p: Pt, i: number): Links =>
  links
    .slice(0, i + 1)
    .map((l, k) => (k === i ? { ...l, segment: { ...l.segment, to: p } } : l))
    .filter(hasLength);

const isOn = (s: Segment, p: Pt) => part.distanceTo(s, p) <= SAME;
const indexAt = (links: Links, p: Pt) => links.findIndex(({ segment }) => isOn(segment, p));

/** Where two chains cross or touch first, seen from the beginning of the first one. */
function meeting(a: Links, b: Links): { readonly p: Pt; readonly i: number; readonly k: number } | null {
  for (const [i, { segment: one }] of a.entries())
    for (const [k, { segment: other }] of b.entries()) {
      const [p] = part
        .meetings(one, other)
        .filter((q) => isOn(one, q) && isOn(other, q))
        .toSorted((q, r) => part.along(one, q) - part.along(one, r));
      if (p) return { p, i, k };
    }
  return null;
}

/** An outside and a bore that meet at the front face; null where they do not. `outside` begins on the axis. */
export function joinedAtFront(outside: Links, bore: Links): { readonly outside: Links; readonly inside: Links } | null {
  const [face] = outside;
  // A bore whose rows begin with the front face.
  const begin = face
    ? bore.findIndex((l) => !(isOn(face.segment, l.segment.from) && isOn(face.segment, l.segment.to)))
    : 0;
  const inside = bore.slice(Math.max(begin, 0)),
    first = firstPoint(inside);
  if (!first) return null;
  const i = indexAt(outside, first);
  if (i >= 0) return { outside: since(outside, first, i), inside };
  const met = meeting(inside, outside);
  return met && { outside: since(outside, met.p, met.k), inside: since(inside, met.p, met.i) };
}

/** A bore that ends in the rear face: without what is behind it, and without the face itself. */
export function endedAt(bore: Links, rear: Link): Links {
  const z = rear.segment.from.z;
  const end = bore.findLastIndex((l) => !(inPlane(l, z) && l.segment.to.r > l.segment.from.r)),
    inside = bore.slice(0, end + 1);
  const met = meeting(inside, [rear]);
  return met ? until(inside, met.p, met.i) : inside;
}

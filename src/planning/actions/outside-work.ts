import { boxAround, boxOf, inBox } from "../../kernel/area/box.ts";
import { difference, intersection, insideOf, offset, opened } from "../../kernel/area/clip.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import { CHORD, SAME, SLIVER } from "../../kernel/tolerance.ts";
import { perSide, diameter } from "../../kernel/units.ts";
import { hasRoomFor } from "../../sim/extent.ts";
import { regionsOf } from "../../sim/region.ts";
import { LEAST_REGION, type OpenRegion } from "../open-regions.ts";
import { perObject, perText, type PerText } from "../../nc/per-object.ts";
import { thickestOf } from "../apply-action.ts";
import { withoutEdge, withoutFront } from "./front.ts";
import { isValley, pocketsOf, type Pocket } from "./pockets.ts";
import { ofPieces } from "../stock-key.ts";
import type { Chain, ElementMark, PlannedPart, PlanRequest, PlanState } from "../types.ts";

/** A piece of material to remove, with the section of the chain that bounds it, from the front to the rear. */
export interface Piece extends OpenRegion {
  readonly section: Chain;
  /** True where no part of the chain stands in front of it: a tool comes in along Z. */
  readonly opensAhead: boolean;
  /** Indices of the first and the last element of the chain that it touches. */
  readonly borders: readonly [first: number, last: number];
  /** The same of its section. */
  readonly span: readonly [first: number, last: number];
}

/** Distance from jaws and other bodies of the clamping, mm. */
const BESIDE_JAWS = 1;
/** Length that is turned behind the rear face, mm: the next clamping or the blade begins on a clean surface. */
const BEHIND_REAR = 2;
/** Thinner material is left to finishing, mm. */
const THIN = 1;
/** Height that a nose leaves in the corner beside a piece, mm: it does not open the piece ahead. */
const IN_CORNER = 0.25;
/** Farther than any stock, mm. */
const FAR = 10_000;

const inFrontOf = (area: readonly Ring[], left: number): Ring[] =>
  intersection(area, [[at(left, -1), at(FAR, -1), at(FAR, FAR), at(left, FAR)]]);

/** Z of the rear end of the outside. */
const rearOfPart = ({ part: { outside } }: PlanRequest): number =>
  boxOf(part.flattenedChain(outside.segments, CHORD)).left;

/** The finished part under a chain, up to the rearmost cut where one is given, without its bore. */
export function solidOf({ segments }: Chain, rear = Infinity): Ring {
  const points = part.flattenedChain(segments, CHORD);
  const [first, last] = [points[0], points.at(-1)];
  if (!first || !last) return [];
  const end = Math.min(last.z, rear);
  return [at(end, 0), at(first.z, 0), ...points, at(end, last.r)];
}

/** Z of the rearmost cut outside: behind the rear face of the part, in front of jaws and stated limits. */
export function rearOf(request: PlanRequest, stock: readonly Ring[]): number {
  const {
    part: { rings },
    clamping,
  } = request;
  const end = rearOfPart(request);
  // A part that goes on in the unmachined stock has no rear face.
  const rear = boxAround(rings).left < end - SAME ? end : end - BEHIND_REAR;
  const jaws = (clamping?.bodies ?? [])
    .filter((body) => body.part !== "tailstock")
    .map(({ rings }) => boxAround(rings).right + BESIDE_JAWS);
  return Math.max(rear, boxAround(stock).left, ...jaws);
}

const QUARTER = Math.PI / 2;

/** An arc as pieces that only rise or only fall, along both axes; a line as it is. */
function oneWay(s: Segment): readonly Segment[] {
  if (s.kind === "line") return [s];
  const { start, sweep, startRadius } = part.polarOf(s);
  const [low, high] = [Math.min(start, start + sweep), Math.max(start, start + sweep)];
  const first = Math.floor(low / QUARTER) + 1;
  const angles = Array.from({ length: Math.max(0, Math.ceil(high / QUARTER) - first) }, (_, i) => (first + i) * QUARTER)
    .filter((a) => Math.min(a - low, high - a) * startRadius > SAME)
    .toSorted((a, b) => (a - b) * Math.sign(sweep));
  const points = [s.from, ...angles.map((a) => part.onCircle(s.centre, startRadius, a)), s.to];
  return points.slice(1).map((to, i) => ({ ...s, from: points[i] ?? s.from, to }));
}

/** The chain up to the rearmost cut. */
function upTo({ outside }: PlannedPart, rear: number): Chain {
  const segments: Segment[] = [];
  const marks: ElementMark[] = [];
  const pieces = outside.segments.flatMap((s, i) => oneWay(s).map((piece) => [piece, outside.marks[i]] as const));
  pieces.forEach(([s, of]) => {
    const mark = of ?? { row: "" };
    if (s.from.z < rear - SAME && s.to.z < rear - SAME) return;
    const cut = s.kind === "line" && s.to.z < rear - SAME ? part.line(s.from, onLine(s, rear)) : s;
    segments.push(cut);
    marks.push(mark);
  });
  return { segments, marks };
}

/** A chain continued along Z to the rearmost cut, with the shoulder of the stock that stays there. */
function continued({ segments, marks }: Chain, rear: number, shoulder: number): Chain {
  const end = segments.at(-1)?.to;
  if (!end) return { segments, marks };
  const points = [end, at(rear, end.r), at(rear, Math.max(end.r, shoulder))];
  const added = points.slice(1).flatMap((to, i) => {
    const from = points[i] ?? end;
    return part.apart(from, to) < SAME ? [] : [part.line(from, to)];
  });
  return { segments: [...segments, ...added], marks: [...marks, ...added.map(() => ({ row: "" }))] };
}

/** Highest radius of the stock from a Z on to a Z, mm; 0 where none is. */
export function highest(stock: readonly Ring[], left: number, right: number): number {
  let most = 0;
  for (const ring of stock)
    ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length] ?? a;
      const [low, high] = a.z < b.z ? [a, b] : [b, a];
      if (high.z < left || low.z > right) return;
      const on = (z: number) => low.r + ((high.r - low.r) * (z - low.z)) / (high.z - low.z);
      const ends = high.z > low.z + SAME ? [on(Math.max(left, low.z)), on(Math.min(right, high.z))] : [a.r, b.r];
      most = Math.max(most, ...ends);
    });
  return most;
}

/** The point of a line at a Z. */
const onLine = ({ from, to }: Segment, z: number): Pt =>
  Math.abs(to.z - from.z) < SAME ? to : at(z, from.r + ((to.r - from.r) * (z - from.z)) / (to.z - from.z));

/** The outside of the stock that is no part of the finished part, up to the rearmost cut. */
export interface OutsideWork {
  readonly chain: Chain;
  /** Connected pieces to the finished size, the largest first. */
  readonly pieces: readonly Piece[];
  /** The same beyond the oversize for finishing, without thin remains. */
  readonly rough: readonly Piece[];
  /** Grooves and valleys of the chain. */
  readonly pockets: readonly Pocket[];
  /** Oversize that stays for finishing, mm: above the mouth of a pocket, too. */
  readonly over: number;
}

/**
 * What all stocks with the same rearmost cut have in common: the chain, its solid, and what roughing leaves: that with
 * the oversize and the edge at its front.
 */
interface Reached {
  readonly chain: Chain;
  readonly solid: readonly Ring[];
  readonly grown: readonly Ring[];
  readonly pockets: readonly Pocket[];
}

const worksOf = perObject((request: PlanRequest) => {
  const reached = perText<Reached>();
  return perObject((stock: readonly Ring[]) => workIn(stock, request, reached));
});

/** What is left to turn outside in a state. */
export const outsideWork = ({ stock }: Pick<PlanState, "stock">, request: PlanRequest): OutsideWork =>
  worksOf(request)(stock);

/** Oversize for finishing, mm. */
const oversizeOf = ({ rules: { allowance } }: PlanRequest): number =>
  Math.max(perSide(diameter(allowance.diameter)), allowance.z);

function reachedTo(rear: number, stock: readonly Ring[], request: PlanRequest, reached: PerText<Reached>): Reached {
  const front = upTo(request.part, rear);
  const end = front.segments.at(-1)?.to;
  const shoulder = highest(stock, rear - SAME, rear);
  // A face up to the surface of the stock ends there: its hollow may be deeper.
  const goesOn = end !== undefined && highest(stock, rear - SAME, end.z) > end.r + SAME;
  return reached([rear, shoulder, goesOn].join(" "), () => {
    const chain = goesOn ? continued(front, rear, shoulder) : front;
    const solid = [solidOf(chain, rear)];
    const plain = withoutEdge(withoutFront(chain).segments);
    return {
      chain,
      solid,
      grown: offset(plain ? [solidOf({ ...chain, segments: plain }, rear)] : solid, oversizeOf(request)),
      pockets: [...pocketsOf(chain, "r"), ...pocketsOf(chain, "z")],
    };
  });
}

function workIn(stock: readonly Ring[], request: PlanRequest, reached: PerText<Reached>): OutsideWork {
  const rear = rearOf(request, stock);
  const { chain, solid, grown, pockets } = reachedTo(rear, stock, request, reached);
  const left = inFrontOf(difference(stock, solid), rear);
  const over = oversizeOf(request);
  return {
    chain,
    pockets,
    pieces: piecesOf(inFrontOf(left, rearOfPart(request)), SLIVER, chain, [SLIVER, 0], request),
    rough: roughOf(left, { chain, solid, grown, over }, request).map(inFront(chain)),
    over,
  };
}

/** Whether some of an area is thicker than a width, mm. */
const isThicker = (area: readonly Ring[], width: number): boolean =>
  hasRoomFor(area, width) && offset(area, -width / 2).length > 0;

/** What is roughed; the edge at the front, too, where finishing would take more with it than it can. */
function roughOf(
  left: readonly Ring[],
  { chain, solid, grown, over }: Pick<Reached & OutsideWork, "chain" | "solid" | "grown" | "over">,
  request: PlanRequest,
): readonly Piece[] {
  const beyond = (area: readonly Ring[]) =>
    piecesOf(difference(left, area), THIN, chain, [over + SLIVER, IN_CORNER], request);
  const rough = beyond(grown);
  return rough.length === 0 && isThicker(left, thickestOf(request) + SLIVER) ? beyond(offset(solid, over)) : rough;
}

/** Pieces of roughing as they are in front of a chain: most are the same objects in many stocks. */
const inFront = perObject((chain: Chain) =>
  perObject((piece: Piece): Piece => ({ ...piece, opensAhead: piece.opensAhead && standsOver(piece, chain) })),
);

/** Whether more than remains of a piece stands over all of the chain in front of it: else it lies in a valley. */
function standsOver({ rings, box, borders: [first] }: Piece, { segments }: Chain): boolean {
  const front = Math.max(0, ...segments.slice(0, first).map(({ to }) => to.r));
  return front < box.high && isThicker(inBox(rings, { ...box, low: front }), THIN);
}

/** The innermost pocket that a piece lies in; null for none. */
export function pocketOf(
  piece: Pick<Piece, "borders" | "box">,
  { pockets, over }: Pick<OutsideWork, "pockets" | "over">,
): Pocket | null {
  const [from, to] = piece.borders;
  const around = pockets.find((p) => (p.first <= from && to <= p.last) || isWithin(piece.box, p, over));
  return around ? (pocketOf(piece, { pockets: around.inner, over }) ?? around) : null;
}

/** Whether a piece lies in a groove, which is left to blades. */
export function isInGroove(piece: Piece, work: OutsideWork): boolean {
  const pocket = pocketOf(piece, work);
  return pocket !== null && !isValley(pocket);
}

/**
 * Whether a box lies in that of a pocket, up to `over` mm above its mouth, and a little more in the corner of a nose:
 * oversize may stand there, and on its walls.
 */
function isWithin({ left, right, low, high }: Box, { segments, axis }: Pocket, over: number): boolean {
  const around = boxOf(part.flattenedChain(segments, CHORD));
  const most = over + IN_CORNER;
  const [ahead, above] = axis === "z" ? [most, 0] : [0, most];
  return (
    left > around.left - SAME &&
    right < around.right + ahead + SAME &&
    low > around.low - SAME &&
    high < around.high + above + SAME
  );
}

/** The pieces of an area that are thicker than `thick` mm, the largest first. */
function piecesOf(
  area: readonly Ring[],
  thick: number,
  chain: Chain,
  beside: readonly [near: number, corner: number],
  request: PlanRequest,
): readonly Piece[] {
  const made = (piece: readonly Ring[]) =>
    regionsOf(opened(piece, thick), LEAST_REGION).flatMap(({ outline, holes, area: size }): readonly Piece[] => {
      const region = { rings: [outline, ...holes], box: boxOf(outline), area: size };
      const found = sectionAt(chain, region, beside);
      return found ? [{ ...region, ...found }] : [];
    });
  const name = `pieces ${thick} ${beside.join(" ")} ${request.shop.memory?.labelOf(chain) ?? ""}`;
  return ofPieces(area, LEAST_REGION, name, made, request).toSorted((a, b) => b.area - a.area);
}

/** Distance of the points at which an element is compared with a region, mm. */
const STEP = 0.25;
/** Finished cylinder beside a piece that its section keeps, mm. */
const BESIDE = 1;

/**
 * The section of a chain that bounds a region at most `near` mm away. It goes on to both sides until the part is as
 * high as the region, but for `corner` mm, so that a cycle knows what stands beside it.
 */
function sectionAt(
  { segments, marks }: Chain,
  { rings, box }: OpenRegion,
  [near, corner]: readonly [number, number],
): Pick<Piece, "section" | "opensAhead" | "borders" | "span"> | null {
  const isNear = insideOf(offset(rings, near + 2 * SLIVER));
  const borders = (s: Segment) => {
    if (!meets(part.boxOf(s), box, near + 2 * SLIVER)) return false;
    const count = Math.ceil(part.lengthOf(s) / STEP);
    return Array.from({ length: count }, (_, i) => part.pointOn(s, (i + 0.5) / count)).some(isNear);
  };
  const hit = segments.flatMap((s, i) => (borders(s) ? [i] : []));
  const touched = [hit[0] ?? -1, hit.at(-1) ?? -1] as const;
  let [first, last] = touched;
  if (first < 0) return null;
  const level = box.high - near - corner - 2 * SLIVER;
  while (first > 0 && (segments[first]?.from.r ?? 0) < level) first -= 1;
  while (last < segments.length - 1 && (segments[last]?.to.r ?? 0) < level) last += 1;
  const section = segments.slice(first, last + 1);
  const [a, b] = [section[0] as Segment, section.at(-1) as Segment];
  const opensAhead = a.from.r < level;
  // Of a cylinder or a face that was turned already only the end beside the piece is needed.
  const [front, rear] = [box.right + BESIDE, box.left - BESIDE];
  if (!opensAhead && a.kind === "line" && a.from.z > front + SAME && a.to.z < front)
    section[0] = part.line(onLine(a, front), a.to);
  const end = section.at(-1) as Segment;
  if (end.kind === "line" && b.to.z < rear - SAME && end.from.z > rear)
    section[section.length - 1] = part.line(end.from, onLine(end, rear));
  return {
    section: { segments: section, marks: marks.slice(first, last + 1) },
    opensAhead,
    borders: touched,
    span: [first, last],
  };
}

const meets = (a: Box, b: Box, by: number): boolean =>
  a.left <= b.right + by && b.left <= a.right + by && a.low <= b.high + by && b.low <= a.high + by;

/** Chains up to an element, which a cut of it ends: the same object for each stock. */
const beginnings = perObject(({ segments, marks }: Chain) => {
  const known = perText<Chain>();
  return (last: number, cut: Segment | undefined): Chain =>
    known(JSON.stringify([last, cut]), () => ({
      segments: [...segments.slice(0, last), ...(cut ? [cut] : [])],
      marks: marks.slice(0, last + 1),
    }));
});

/** The chain from its front to the end of the section of a piece, and of its hollow, with what lies along it. */
export function workUpTo(
  { chain, pieces, rough, pockets, over }: OutsideWork,
  { section, span: [, end] }: Piece,
): OutsideWork {
  const hollow = pockets.find((pocket) => pocket.axis === "z" && pocket.first <= end && pocket.last > end);
  const last = hollow?.last ?? end;
  const cut = hollow ? chain.segments[last] : section.segments.at(-1);
  return {
    chain: beginnings(chain)(last, cut),
    pieces,
    rough,
    pockets: pockets.filter((pocket) => pocket.last <= last),
    over,
  };
}

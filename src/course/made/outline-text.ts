import { boxAround } from "../../kernel/area/box.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { simplified } from "../../kernel/area/clip.ts";
import { part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { inDegrees, rounded, toDiameter } from "../../kernel/units.ts";
import { traced } from "./traced.ts";

/** Outlines as lines of a contour subprogram, from the free end; absent where nothing was turned. */
export interface OutlineLines {
  readonly outside?: readonly string[];
  readonly bore?: readonly string[];
}

/** Greatest deviation of the simplified chain from the shape, mm. */
const NEAR = 0.001;
/** A point this near to the blank or the axis is on it, mm. */
const ON = 0.01;
const number = (value: number): string => {
  const text = String(rounded(value) + 0);
  return text.startsWith("-") ? text : `+${text}`;
};
/** Sizes and radii are usually round numbers: a hundredth that is near enough is preferred, mm. */
const HUNDREDTHS = 100,
  AS_NEAR = 0.003;
const size = (value: number): string => {
  const round = Math.round(value * HUNDREDTHS) / HUNDREDTHS;
  return number(Math.abs(round - value) < AS_NEAR ? round : value);
};
/** An angle is a usual one, a multiple of 0.5°, within this, degrees. */
const USUAL = 0.005;
/** A cone of a usual angle ends where its angle takes it: its diameter there is no round number. Chamfers of 45° have round ends. */
const isCone = (s: Segment | undefined): boolean => {
  if (s?.kind !== "line") return false;
  const [along, across] = [Math.abs(s.from.z - s.to.z), Math.abs(s.from.r - s.to.r)];
  if (along < ON || across < ON || Math.abs(along - across) < ON) return false;
  const angle = inDegrees(Math.atan2(across, along));
  return Math.abs(angle - Math.round(2 * angle) / 2) < USUAL;
};
const at = (p: Pt, ...beside: readonly (Segment | undefined)[]): string =>
  `X${beside.some(isCone) ? number(toDiameter(p.r)) : size(toDiameter(p.r))} Z${size(p.z)}`;

function linesOf(segments: readonly Segment[]): readonly string[] | undefined {
  const [first] = segments;
  if (!first) return undefined;
  return [
    `L ${at(first.from, first)}`,
    ...segments.map((s, i) =>
      s.kind === "line"
        ? `L ${at(s.to, s, segments[i + 1])}`
        : `CR ${at(s.to, segments[i + 1])} R${size(part.radiusOf(s))} ${s.turn === "ccw" ? "DR+" : "DR-"}`,
    ),
  ];
}

/** Whether a segment is part of the blank or on the axis. */
function isLeft(a: Pt, b: Pt, blank: readonly Ring[]): boolean {
  if (Math.abs(a.r) < ON && Math.abs(b.r) < ON) return true;
  const middle = part.pointOn(part.line(a, b), 1 / 2);
  return blank.some((ring) =>
    ring.some((p, i) => {
      const side = part.line(p, ring[(i + 1) % ring.length] ?? p);
      return [a, middle, b].every((q) => part.distanceTo(side, q) < ON);
    }),
  );
}

/** A chain without the unmachined segments at its end. */
function turnedPart(chain: readonly Pt[], blank: readonly Ring[]): readonly Pt[] {
  let last = chain.length - 1;
  while (last > 0) {
    const [a, b] = [chain[last - 1], chain[last]];
    if (!a || !b || !isLeft(a, b, blank)) break;
    last -= 1;
  }
  return last > 0 ? chain.slice(0, last + 1) : [];
}

/**
 * Outlines of a part as chains of points, from the free end to the unmachined blank; empty where nothing was turned.
 */
export interface OutlineChains {
  readonly outside: readonly Pt[];
  readonly bore: readonly Pt[];
}

/** The outlines of a part turned from a blank; of several pieces, the largest. */
export function outlineChains(finished: readonly Ring[], blank: readonly Ring[]): OutlineChains {
  const [body] = simplified(finished, NEAR)
    .map((ring) => ({ ring, area: areaOf([ring]) }))
    .sort((a, b) => b.area - a.area);
  if (!body || body.ring.length < 3) return { outside: [], bore: [] };
  const { ring } = body,
    { left, right } = boxAround([ring]);
  // Counter-clockwise: from the back along bore or axis to the free end, and back along the outside.
  const back = ring.findIndex(
    (p, i) => Math.abs(p.z - left) < ON && !(Math.abs((ring[(i + 1) % ring.length]?.z ?? left) - left) < ON),
  );
  const chain = [...ring.slice(back), ...ring.slice(0, back)];
  const front = chain.reduce((best, p, i) => {
    const now = chain[best];
    return !now || (p.z > right - ON && (now.z <= right - ON || p.r < now.r)) ? i : best;
  }, 0);
  return {
    outside: turnedPart(chain.slice(front), blank),
    bore: turnedPart(chain.slice(0, front + 1).toReversed(), blank),
  };
}

/**
 * The outlines of a part turned from a blank, as the control reads them: the elements of the contours that they come
 * from (`sources`), the rest simplified to lines and arcs.
 */
export function outlineText(
  finished: readonly Ring[],
  blank: readonly Ring[],
  sources: readonly Segment[] = [],
): OutlineLines {
  const chains = outlineChains(finished, blank);
  const [outside, bore] = [linesOf(traced(chains.outside, sources)), linesOf(traced(chains.bore, sources))];
  return { ...(outside && { outside }), ...(bore && { bore }) };
}

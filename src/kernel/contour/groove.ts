import { edgeElement, type RecessWord, type RecessWords } from "./undercut.ts";
import type { CornerElement } from "./corner.ts";
import { part, type Segment } from "../geometry/point.ts";
import { ROUND, SAME } from "../tolerance.ts";
import { radians } from "../units.ts";

/** GRV: a recess in the element before it, a cylinder (radial) or a face (axial). */
export interface Groove {
  readonly kind: "groove";
  readonly direction: "radial" | "axial";
  readonly words: RecessWords;
}

/**
 * The words of a recess in the order of the control: printed for the TNC7, 81762x-19, topic "Recesses and undercuts".
 */
export const GROOVE_WORDS: readonly RecessWord[] = [
  "CENTER",
  "R",
  "DEPTH",
  "DIAM",
  "BREADTH",
  "ANGLE",
  "ANG_WIDTH",
  "RND",
  "CHF",
  "FAR_RND",
  "FAR_CHF",
];
/** Alternative words for the same dimension: a recess has one of each pair. */
const EITHER: readonly (readonly [RecessWord, RecessWord])[] = [
  ["DEPTH", "DIAM"],
  ["ANGLE", "ANG_WIDTH"],
  ["RND", "CHF"],
  ["FAR_RND", "FAR_CHF"],
];
/** Words of a recess that a program states as diameters: CENTER only on a face. */
export const grooveDiameters = (direction: Groove["direction"]): readonly RecessWord[] =>
  direction === "axial" ? ["CENTER", "DIAM"] : ["DIAM"];

/** A corner of a recess, mm: distance along its element from the element's start, and across it (towards +X or +Z). */
export interface GrooveVertex {
  readonly along: number;
  readonly across: number;
  readonly corner: CornerElement | null;
}

export type GrooveShape =
  | { readonly vertices: readonly GrooveVertex[] }
  | { readonly word: RecessWord }
  /** Two words that exclude each other. */
  | { readonly word: RecessWord; readonly other: RecessWord }
  /** The recess is wider than its element. */
  | { readonly breadth: number; readonly room: number }
  /** The element does not run in the direction this recess needs. */
  | "wrongElement";

/**
 * Inclination of each flank against the perpendicular to its element, degrees: ANGLE, or half the opening angle
 * ANG_WIDTH. Returns the word where the flank would lie along the element.
 */
function flankOf(w: RecessWords): number | { readonly word: RecessWord } {
  const [angle, opening] = [w.ANGLE ?? 0, w.ANG_WIDTH ?? 0];
  if (angle < 0 || angle >= 90) return { word: "ANGLE" };
  if (opening < 0 || opening >= 180) return { word: "ANG_WIDTH" };
  return angle + opening / 2;
}

/** The corners of a recess in the order of the contour. BREADTH is the opening. */
export function grooveShape({ direction, words: w }: Groove, on: Segment): GrooveShape {
  const twice = EITHER.find(([one, other]) => w[one] !== undefined && w[other] !== undefined);
  if (twice) return { word: twice[1], other: twice[0] };
  const radial = direction === "radial";
  const [dz, dr] = [on.to.z - on.from.z, on.to.r - on.from.r];
  if (on.kind === "arc" || Math.abs(radial ? dr : dz) > SAME) return "wrongElement";
  const size = part.lengthOf(on);
  const depth = w.DEPTH ?? (radial && w.DIAM !== undefined ? w.DIAM - on.from.r : 0);
  const [B, R, flank] = [w.BREADTH ?? 0, w.R ?? 0, flankOf(w)];
  if (Math.abs(depth) <= ROUND || (radial && on.from.r + depth < -ROUND))
    return { word: w.DIAM !== undefined && w.DEPTH === undefined && radial ? "DIAM" : "DEPTH" };
  if (!(B > ROUND)) return { word: "BREADTH" };
  if (R < 0) return { word: "R" };
  if (w.CENTER === undefined) return { word: "CENTER" };
  const middle = radial ? (w.CENTER - on.from.z) * Math.sign(dz) : (w.CENTER - on.from.r) * Math.sign(dr);
  if (middle <= ROUND || middle >= size - ROUND) return { word: "CENTER" };
  const [near, far] = [middle - B / 2, middle + B / 2];
  if (near < -ROUND || far > size + ROUND) return { breadth: B, room: Math.min(middle, size - middle) * 2 };
  if (typeof flank !== "number") return flank;
  const lean = Math.abs(depth) * Math.tan(radians(flank));
  if (near + lean >= far - lean) return { word: w.ANG_WIDTH === undefined ? "ANGLE" : "ANG_WIDTH" };
  const floor: CornerElement | null = R > 0 ? { kind: "round", size: R } : null;
  return {
    vertices: [
      { along: near, across: 0, corner: edgeElement(w.RND, w.CHF) },
      { along: near + lean, across: depth, corner: floor },
      {
        along: far - lean,
        across: depth,
        corner: floor,
      },
      { along: far, across: 0, corner: edgeElement(w.FAR_RND, w.FAR_CHF) },
    ],
  };
}

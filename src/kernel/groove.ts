import { edgeElement, type RecessWord, type RecessWords } from "./undercut.ts";
import type { CornerElement } from "./corner.ts";
import { part, type Segment } from "./point.ts";
import { ROUND, SAME } from "./tolerance.ts";
import { radians } from "./units.ts";

/** GRV: a recess in the element before it, a cylinder (radial) or a face (axial). */
export interface Groove {
  readonly kind: "groove";
  readonly direction: "radial" | "axial";
  readonly words: RecessWords;
}

/** The words of a recess in the order of the control. */
export const GROOVE_WORDS: readonly RecessWord[] = ["CENTER", "R", "DEPTH", "DIAM", "BREADTH", "ANGLE", "RND", "CHF", "FAR_RND", "FAR_CHF"];
/** Words of a recess that a program measures as diameters: CENTER only where it stands on a face. */
export const grooveDiameters =
  (direction: Groove["direction"]): readonly RecessWord[] => (direction === "axial" ? ["CENTER", "DIAM"] : ["DIAM"]);

/** A corner of a recess, mm: how far along its element from the element's start, and how far across it (towards +X or +Z). */
export interface GrooveVertex {
  readonly along: number;
  readonly across: number;
  readonly corner: CornerElement | null;
}

export type GrooveShape =
  | { readonly vertices: readonly GrooveVertex[] }
  | { readonly word: RecessWord }
  /** The recess is wider than its element leaves room for. */
  | { readonly breadth: number; readonly room: number }
  /** The element does not run in the direction this recess needs. */
  | "wrongElement";

/** The corners of a recess in the order of the contour. BREADTH is the opening; ANGLE stands between the two walls. */
export function grooveShape({ direction, words: w }: Groove, on: Segment): GrooveShape {
  const radial = direction === "radial";
  const [dz, dr] = [on.to.z - on.from.z, on.to.r - on.from.r];
  if (on.kind === "arc" || Math.abs(radial ? dr : dz) > SAME) return "wrongElement";
  const size = part.lengthOf(on);
  const depth = w.DEPTH ?? (radial && w.DIAM !== undefined ? w.DIAM - on.from.r : 0);
  const [B, R, angle] = [w.BREADTH ?? 0, w.R ?? 0, w.ANGLE ?? 0];
  if (Math.abs(depth) <= ROUND || (radial && on.from.r + depth < -ROUND))
    return { word: w.DIAM !== undefined && w.DEPTH === undefined && radial ? "DIAM" : "DEPTH" };
  if (!(B > ROUND)) return { word: "BREADTH" };
  if (R < 0) return { word: "R" };
  if (w.CENTER === undefined) return { word: "CENTER" };
  const middle = radial ? (w.CENTER - on.from.z) * Math.sign(dz) : (w.CENTER - on.from.r) * Math.sign(dr);
  if (middle <= ROUND || middle >= size - ROUND) return { word: "CENTER" };
  const [near, far] = [middle - B / 2, middle + B / 2];
  if (near < -ROUND || far > size + ROUND) return { breadth: B, room: Math.min(middle, size - middle) * 2 };
  const lean = Math.abs(depth) * Math.tan(radians(angle / 2));
  if (angle < 0 || angle >= 180 || near + lean >= far - lean) return { word: "ANGLE" };
  const floor: CornerElement | null = R > 0 ? { kind: "round", size: R } : null;
  return {
    vertices: [{ along: near, across: 0, corner: edgeElement(w.RND, w.CHF) }, { along: near + lean, across: depth, corner: floor }, {
      along: far - lean,
      across: depth,
      corner: floor,
    }, { along: far, across: 0, corner: edgeElement(w.FAR_RND, w.FAR_CHF) }],
  };
}

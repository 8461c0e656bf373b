import { turnOf } from "./axis-of-body.ts";
import type { SurfacedFace } from "./half-section.ts";
import { isSameAxis, meridianNormal, sectionPoint, type Axis3 } from "./meridian.ts";
import { pointsOfFace } from "./step-body.ts";
import { cross3, size3 } from "../space.ts";

/** What of a part is not turned, by kind. */
export interface LeftOut {
  /** Plane faces along or oblique to the axis: flats, keyways, hexagons, slots. */
  readonly flats: number;
  /** Holes beside the axis and along it. */
  readonly holes: number;
  /** Holes across the axis or oblique to it. */
  readonly crossHoles: number;
  /** All other faces. */
  readonly others: number;
}

/** Directions that differ by more are not parallel for a reader of the note, radians. */
const ASLANT = 1e-3;
/** Part of a full turn from which a round face is a hole. */
const HOLE = 0.9 * 2 * Math.PI;

/** Sorts faces that are not of revolution about the axis; faces of one hole are one. */
export function leftOutOf(faces: readonly SurfacedFace[], axis: Axis3): LeftOut {
  const bores: { axis: Axis3; turn: number; faces: number }[] = [];
  let flats = 0,
    others = 0;
  for (const f of faces) {
    const { kind, axis: own } = f.surface;
    if (kind === "plane") {
      // A plane across the axis is the floor or wall of something that is counted by its other faces.
      if (own && size3(cross3(own.direction, axis.direction)) > ASLANT) flats += 1;
      continue;
    }
    const m = kind === "cylinder" && own ? f.surface.meridian(own) : null;
    const isHollow = m !== null && meridianNormal(m, 0).r > 0 !== f.face.outward;
    if (!own || !isHollow) {
      others += 1;
      continue;
    }
    const turn = turnOf(own, pointsOfFace(f.face)),
      known = bores.find((b) => isSameAxis(b.axis, own));
    if (known) {
      known.turn += turn;
      known.faces += 1;
    } else bores.push({ axis: own, turn, faces: 1 });
  }
  const holes = bores.filter((b) => b.turn > HOLE),
    isAlong = (b: Axis3) => size3(cross3(b.direction, axis.direction)) < ASLANT;
  const along = holes.filter((b) => isAlong(b.axis) && sectionPoint(axis, b.axis.origin).r > 0).length;
  return {
    flats,
    holes: along,
    crossHoles: holes.length - along,
    others: others + bores.filter((b) => b.turn <= HOLE).reduce((sum, b) => sum + b.faces, 0),
  };
}

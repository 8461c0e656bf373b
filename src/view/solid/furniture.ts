import { areaOfRing } from "../../kernel/area.ts";
import { intersection, union } from "../../kernel/clip.ts";
import { isDrill } from "../../kernel/drill.ts";
import { holderOutlines, shankAxis } from "../../kernel/holder.ts";
import { insertOutline } from "../../kernel/insert.ts";
import { at, part, type Ring, type Segment } from "../../kernel/point.ts";
import { boxAround, boxOf } from "../../kernel/box.ts";
import type { Step } from "../../kernel/step.ts";
import type { Tool } from "../../kernel/tool.ts";
import { boundsOf, joined } from "../bounds.ts";
import type { Bounds } from "../camera.ts";
import { chuckDrawing } from "../material/chuck.ts";
import { tipWays, workingBox } from "../scene.ts";
import { extruded, plateEdges } from "./extrude.ts";
import { jawOf } from "./jaw.ts";
import type { Mesh } from "./mesh.ts";
import { chordsFor, revolved, wholeMesh } from "./revolve.ts";

/** What stands round the work: bodies with their edges as lines. */
export interface DrawnPart {
  readonly role: "chuck" | "jaw" | "insert" | "holder";
  readonly mesh: Mesh;
  readonly edges: Float32Array;
}

/** Outlines of tools are drawn with chords within this, mm. */
const FINE = 0.02;
/** A holder lies so much lower than the face of its insert, as a part of the thickness of the insert. */
const LOWER = 0.25;
/** Thickness of an insert as a part of its size, and between which it stays, mm. */
const THICK = { share: 0.3, least: 1.5, most: 6 } as const;

/** Coordinates turned round the spindle axis by an angle in radians. */
function turnedRound(list: Float32Array, angle: number): Float32Array {
  const [c, s] = [Math.cos(angle), Math.sin(angle)], out = new Float32Array(list);
  for (let i = 0; i < out.length; i += 3) {
    const [x, y] = [list[i] ?? 0, list[i + 1] ?? 0];
    out[i] = c * x - s * y;
    out[i + 1] = s * x + c * y;
  }
  return out;
}

const turnedMesh = ({ positions, normals, index }: Mesh, angle: number): Mesh => ({
  positions: turnedRound(positions, angle),
  normals: turnedRound(normals, angle),
  index,
});

/** Where the three jaws stand, from X up over the operator: none in the quarter that may be cut away. Radians. */
export const JAWS = [-15, 105, 225].map((degrees) => (degrees * Math.PI) / 180);
/** How much of the body of a chuck is shown, in its radii, and the width of a base jaw in that of its jaw. */
const SHOWN = 0.4;
const BASE = 0.76;

/** The chuck in which a blank is held, with three jaws, and what of it and the blank should be seen; null where there is no blank. */
export function chuckParts(
  blank: readonly Ring[],
  steps: readonly Step[],
  contours: readonly (readonly Segment[])[],
): { readonly parts: readonly DrawnPart[]; readonly seen: Bounds } | null {
  const material = boundsOf(blank.flat());
  if (!material) return null;
  const outline = contours.flat().map(part.boxOf).reduce((box: Bounds | null, each) => joined(box, each), null);
  const { body, jaw, base, seen } = chuckDrawing(material, joined(workingBox(tipWays(steps)), outline));
  const { face, radius, chamfer } = body, back = face - SHOWN * radius;
  const shell = [at(back, 0), at(face, 0), at(face, radius - chamfer), at(face - chamfer, radius), at(back, radius)];
  const solid = revolved([shell], { chords: chordsFor(radius), quarterCut: false });
  const half = halfJaw(material);
  const plates = ([[jaw, half], [base, BASE * half]] as const).map(([corners, side]) => {
    const ring = corners.map(([z, r]) => at(z, r));
    return jawOf(areaOfRing(ring) < 0 ? ring.reverse() : ring, side);
  });
  const jaws = JAWS.flatMap((angle) =>
    plates.map(({ mesh, edges }): DrawnPart => ({ role: "jaw", mesh: turnedMesh(mesh, angle), edges: turnedRound(edges, angle) }))
  );
  return { parts: [{ role: "chuck", mesh: wholeMesh(solid), edges: solid.edges }, ...jaws], seen: joined(material, seen) ?? material };
}

/** Half the width of a jaw, mm, as in the drawing of the chuck. */
const halfJaw = ({ high }: Bounds) => Math.min(60, Math.max(8, high * 0.42)) / 2;

/** One side of a drill, which is drawn as a body of revolution. */
function upperHalf(ring: Ring): readonly Ring[] {
  const { left, right, high } = boxAround([ring]);
  return intersection([ring], [[at(left, 0), at(right, 0), at(right, high), at(left, high)]]);
}

/**
 * A tool with its tip in the zero point: the insert as a plate whose face lies in the plane of the spindle, the holder below it; a drill
 * as a body of revolution. The outlines are those that the simulation cuts and checks with; how thick they are is not known and for the
 * eye only.
 */
export function toolParts(tool: Tool): DrawnPart[] {
  const insert = insertOutline(tool, FINE), holders = union(holderOutlines(tool));
  if (isDrill(tool)) {
    const solid = (rings: readonly Ring[]) => revolved(rings, { chords: chordsFor(boxAround(rings).high), quarterCut: false });
    const body = solid(upperHalf(insert));
    return [{ role: "insert", mesh: wholeMesh(body), edges: body.edges }];
  }
  const box = boxOf(insert), size = Math.min(box.right - box.left, box.high - box.low);
  const thick = Math.min(THICK.most, Math.max(THICK.least, THICK.share * size));
  const plate = (role: DrawnPart["role"], ring: Ring, back: number, front: number): DrawnPart => ({
    role,
    mesh: extruded(ring, back, front),
    edges: plateEdges(ring, back, front),
  });
  const wide = tool.holder?.width ?? 0, lies = tool.holder ? shankAxis(tool.TO, tool.holder.axis) : "X";
  // A bar along the spindle works in bores: its middle is as high as the spindle. A shank across it lies below.
  const deep = Math.max(2 * thick, lies === "Z" ? 0.5 * wide : wide);
  return [plate("insert", insert, -thick, 0), ...holders.map((ring) => plate("holder", ring, -deep, -LOWER * thick))];
}

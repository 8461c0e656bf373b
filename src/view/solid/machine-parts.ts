import { jawWidth, type Clamped } from "../../kernel/area/clamping.ts";
import { intersection, union } from "../../kernel/area/clip.ts";
import { isDrill } from "../../kernel/cutter/drill.ts";
import { holderOutlines, shankAxis } from "../../kernel/cutter/holder.ts";
import { insertOutline } from "../../kernel/cutter/insert.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { boxAround, boxOf } from "../../kernel/area/box.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { Bounds } from "../camera.ts";
import { brokenOutlines, brokenSolid } from "./broken.ts";
import { extruded, plateEdges } from "./extrude.ts";
import { jawOf } from "./jaw.ts";
import type { Mesh } from "./mesh.ts";
import { chordsFor, revolved, wholeMesh } from "./revolve.ts";

/** A body near the work, with its edges as lines. */
export interface DrawnPart {
  readonly role: "chuck" | "jaw" | "insert" | "holder";
  readonly mesh: Mesh;
  readonly edges: Float32Array;
}

/** Chord tolerance of tool outlines, mm. */
const FINE = 0.02;
/** How much lower a holder is than the face of its insert, as a share of the insert's thickness. */
const LOWER = 0.25;
/** Thickness of an insert as a share of its size, and its limits, mm. */
const THICK = { share: 0.3, least: 1.5, most: 6 } as const;

/** Coordinates turned round the spindle axis by an angle in radians. */
function turnedRound(list: Float32Array, angle: number): Float32Array {
  const [c, s] = [Math.cos(angle), Math.sin(angle)],
    out = new Float32Array(list);
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
/** The bodies of a clamping, three jaws or others, as far as the break lines that cut it off. */
export function chuckParts({ clamping, bodies }: Clamped, cut: Bounds): readonly DrawnPart[] {
  const half = jawWidth(clamping.size ?? 0) / 2;
  return bodies.flatMap(({ part, rings }): readonly DrawnPart[] => {
    if (part === "limit") return [];
    if (part !== "jaws") return [{ role: "chuck", ...brokenSolid(rings, cut) }];
    return brokenOutlines(rings, cut)
      .map((ring) => jawOf(ring, half))
      .flatMap(({ mesh, edges }) =>
        JAWS.map((angle): DrawnPart => ({
          role: "jaw",
          mesh: turnedMesh(mesh, angle),
          edges: turnedRound(edges, angle),
        })),
      );
  });
}

/** One side of a drill, which is drawn as a body of revolution. */
function upperHalf(ring: Ring): readonly Ring[] {
  const { left, right, high } = boxAround([ring]);
  return intersection([ring], [[at(left, 0), at(right, 0), at(right, high), at(left, high)]]);
}

/**
 * A tool with its tip at the zero point: the insert as a plate whose face lies in the plane of the spindle, the holder
 * below it; a drill as a body of revolution. The outlines are those of simulation and checks; thicknesses are unknown
 * and for display only.
 */
export function toolParts(tool: Tool): DrawnPart[] {
  const insert = insertOutline(tool, FINE),
    holders = union(holderOutlines(tool));
  if (isDrill(tool)) {
    const solid = (rings: readonly Ring[]) =>
      revolved(rings, { chords: chordsFor(boxAround(rings).high), quarterCut: false });
    const body = solid(upperHalf(insert));
    return [{ role: "insert", mesh: wholeMesh(body), edges: body.edges }];
  }
  const box = boxOf(insert),
    size = Math.min(box.right - box.left, box.high - box.low);
  const thick = Math.min(THICK.most, Math.max(THICK.least, THICK.share * size));
  const plate = (role: DrawnPart["role"], ring: Ring, back: number, front: number): DrawnPart => ({
    role,
    mesh: extruded(ring, back, front),
    edges: plateEdges(ring, back, front),
  });
  const wide = tool.holder?.width ?? 0,
    lies = tool.holder ? shankAxis(tool.TO, tool.holder.axis) : "X";
  // A bar along the spindle works in bores: its middle is as high as the spindle. A shank across it lies below.
  const deep = Math.max(2 * thick, lies === "Z" ? 0.5 * wide : wide);
  return [plate("insert", insert, -thick, 0), ...holders.map((ring) => plate("holder", ring, -deep, -LOWER * thick))];
}

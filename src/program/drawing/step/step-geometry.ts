import type { Part21Entity, Part21File, Part21Value } from "../../files/part21.ts";
import { listIn, numberIn, referenceIn } from "../../files/part21-values.ts";
import { unit3, type Placing, type V3 } from "../space.ts";
import { uprightFrame } from "./frame.ts";

/** Sizes of the units of a representation: mm and radians for 1 of the file. */
export interface StepUnits {
  readonly length: number;
  readonly angle: number;
  /** The file names its unit of length. */
  readonly known: boolean;
}

/** Coordinates beyond this are no part: mm. */
const FAR = 1e6;

/** Access to the entities of a file: points in mm, directions of length 1, placements. Nothing throws: null is unreadable. */
export class StepGeometry {
  readonly file: Part21File;
  readonly units: StepUnits;
  private readonly points = new Map<number, V3 | null>();
  private splinePoints = 500_000;

  constructor(file: Part21File, units: StepUnits) {
    this.file = file;
    this.units = units;
  }

  /** Whether a spline surface of so many control points is still looked at: all of them together have a limit. */
  spend(points: number): boolean {
    this.splinePoints -= points;
    return this.splinePoints >= 0;
  }

  /** The entity that a value refers to. */
  entity(v: Part21Value): Part21Entity | undefined {
    const id = referenceIn(v);
    return id === null ? undefined : this.file.entities.get(id);
  }

  /** Parameters of the first of these types that the entity has. */
  values(v: Part21Value, ...types: readonly string[]): readonly Part21Value[] | null {
    const entity = this.entity(v);
    return entity?.find((r) => types.includes(r.type))?.values ?? null;
  }

  /** A length of the file in mm. */
  length(v: Part21Value): number | null {
    const n = numberIn(v);
    return n === null || Math.abs(n * this.units.length) > FAR ? null : n * this.units.length;
  }

  private coordinates(list: Part21Value, scale: number): V3 | null {
    const [x, y, z = 0] = listIn(list).map(numberIn);
    if (typeof x !== "number" || typeof y !== "number" || typeof z !== "number") return null;
    return Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) * scale > FAR ? null : [x * scale, y * scale, z * scale];
  }

  point(v: Part21Value): V3 | null {
    const id = referenceIn(v);
    if (id === null) return null;
    const known = this.points.get(id);
    if (known !== undefined) return known;
    const vertex = this.values(v, "VERTEX_POINT"),
      p = vertex ? null : this.values(v, "CARTESIAN_POINT");
    const made = p ? this.coordinates(p[1], this.units.length) : null;
    // A vertex names its point; nothing else nests here.
    const inner = vertex ? this.values(vertex[1], "CARTESIAN_POINT") : null,
      found = made ?? (inner ? this.coordinates(inner[1], this.units.length) : null);
    this.points.set(id, found);
    return found;
  }

  direction(v: Part21Value): V3 | null {
    const d = this.values(v, "DIRECTION"),
      c = d && this.coordinates(d[1], 1);
    return c && unit3(c);
  }

  /** AXIS1_PLACEMENT or AXIS2_PLACEMENT_3D; missing directions are those of the file's axes. */
  frame(v: Part21Value): Placing | null {
    const p = this.values(v, "AXIS2_PLACEMENT_3D", "AXIS1_PLACEMENT"),
      origin = p && this.point(p[1]);
    return p && origin ? uprightFrame(origin, this.direction(p[2]) ?? [0, 0, 1], this.direction(p[3])) : null;
  }
}

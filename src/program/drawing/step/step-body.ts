import type { Part21Entity, Part21File, Part21Value } from "../../files/part21.ts";
import { enumerationIn, listIn, recordOf, referenceIn } from "../../files/part21-values.ts";
import { stepCurve, turnBetween } from "./step-curve.ts";
import { StepGeometry, type StepUnits } from "./step-geometry.ts";
import { productNames } from "./step-names.ts";
import { stepUnits } from "./step-units.ts";
import { type V3 } from "../space.ts";
import { JOINED } from "../../../kernel/tolerance.ts";
import { apart3 } from "./frame.ts";

/** Points of an edge in the direction of its loop; a vertex alone is one point. */
export interface StepEdge {
  readonly points: readonly V3[];
  /** Neither line nor of an unknown kind. */
  readonly isCurved: boolean;
}

/** A face with its edges. */
export interface StepFace {
  readonly surface: Part21Value;
  /** The normal of the face is that of its surface; the loops run counter-clockwise about it. */
  readonly sense: boolean;
  /** The normal of the surface leaves the solid. */
  readonly outward: boolean;
  readonly bounds: readonly (readonly StepEdge[])[];
}

/** A solid, or the faces of shells that make none. */
export interface StepBody {
  readonly name: string;
  readonly units: StepUnits;
  readonly geometry: StepGeometry;
  readonly faces: readonly StepFace[];
  /** Its faces enclose a volume, so that their normals leave it. */
  readonly isSolid: boolean;
  /** Faces without readable edges. */
  readonly broken: number;
}

/** Limits: bodies of a file, faces of a body. A turned part has some hundred faces. */
export const STEP_LIMITS = { bodies: 200, faces: 5000 };
/** Points of a curved edge; those of a full circle are 7.5° apart. */
const POINTS = 48;

const straight = (from: V3, to: V3): StepEdge => ({ points: [from, to], isCurved: false });
const backwards = (e: StepEdge): StepEdge => ({ ...e, points: e.points.toReversed() });
/** Points of all edges of a face. */
export const pointsOfFace = (face: StepFace): V3[] => face.bounds.flatMap((b) => b.flatMap((e) => [...e.points]));
const isTrue = (v: Part21Value) => enumerationIn(v) !== "F";

class Shells {
  private readonly g: StepGeometry;
  private readonly edges = new Map<number, StepEdge | null>();
  broken = 0;

  constructor(g: StepGeometry) {
    this.g = g;
  }

  /** Points of an EDGE_CURVE from its first vertex to its last. */
  private edge(v: Part21Value): StepEdge | null {
    const id = referenceIn(v);
    if (id === null) return null;
    const known = this.edges.get(id);
    if (known !== undefined) return known;
    const values = this.g.values(v, "EDGE_CURVE"),
      from = values && this.g.point(values[1]),
      to = values && this.g.point(values[2]);
    const edge = values && from && to ? this.along(values, from, to) : null;
    this.edges.set(id, edge);
    return edge;
  }

  private along(values: readonly Part21Value[], from: V3, to: V3): StepEdge {
    const curve = stepCurve(this.g, values[3]);
    if (!curve) return straight(from, to);
    const forward = isTrue(values[4]),
      [a, b] = [curve.parameterOf(from), curve.parameterOf(to)];
    const isClosed = apart3(from, to) < JOINED;
    let range: readonly [number, number] = [a, b];
    if (curve.period !== null) range = isClosed ? turnBetween(a, a, forward) : turnBetween(a, b, forward);
    else if (isClosed && curve.range) range = forward ? curve.range : [curve.range[1], curve.range[0]];
    const n = curve.kind === "line" ? 4 : POINTS;
    const points = Array.from({ length: n + 1 }, (_, i) => {
      if (i === 0) return from;
      return i === n ? to : curve.at(range[0] + ((range[1] - range[0]) * i) / n);
    });
    return { points, isCurved: curve.kind !== "line" };
  }

  private loop(v: Part21Value): readonly StepEdge[] {
    const vertex = this.g.values(v, "VERTEX_LOOP");
    if (vertex) {
      const p = this.g.point(vertex[1]);
      return p ? [{ points: [p], isCurved: false }] : [];
    }
    const poly = this.g.values(v, "POLY_LOOP");
    if (poly) {
      const points = listIn(poly[1]).flatMap((one) => {
        const p = this.g.point(one);
        return p ? [p] : [];
      });
      return points.map((p, i) => straight(p, points[(i + 1) % points.length] ?? p));
    }
    return listIn(this.g.values(v, "EDGE_LOOP")?.[1]).flatMap((e) => {
      const oriented = this.g.values(e, "ORIENTED_EDGE"),
        edge = oriented && this.edge(oriented[3]);
      if (!edge) return [];
      return [isTrue(oriented[4]) ? edge : backwards(edge)];
    });
  }

  face(v: Part21Value, outward: boolean): StepFace | null {
    const oriented = this.g.values(v, "ORIENTED_FACE");
    if (oriented) return null;
    const values = this.g.values(v, "ADVANCED_FACE", "FACE_SURFACE");
    if (!values) return null;
    const bounds = listIn(values[1]).flatMap((b) => {
      const bound = this.g.values(b, "FACE_OUTER_BOUND", "FACE_BOUND"),
        loop = bound ? this.loop(bound[1]) : [];
      if (loop.length === 0) return [];
      return [bound && !isTrue(bound[2]) ? loop.map(backwards).reverse() : loop];
    });
    const sense = isTrue(values[3]);
    if (bounds.length === 0 && listIn(values[1]).length > 0) this.broken += 1;
    return { surface: values[2], sense, outward: sense === outward, bounds };
  }

  /** Faces of a shell; an oriented shell may turn another inside out. */
  shell(v: Part21Value, outward = true): readonly StepFace[] {
    const oriented = this.g.values(v, "ORIENTED_CLOSED_SHELL", "ORIENTED_OPEN_SHELL");
    if (oriented) {
      const inner = this.g.values(oriented[2], "CLOSED_SHELL", "OPEN_SHELL");
      return inner ? this.faces(inner[1], isTrue(oriented[3]) === outward) : [];
    }
    return this.faces(this.g.values(v, "CLOSED_SHELL", "OPEN_SHELL", "CONNECTED_FACE_SET")?.[1], outward);
  }

  private faces(list: Part21Value, outward: boolean): readonly StepFace[] {
    return listIn(list)
      .slice(0, STEP_LIMITS.faces + 1)
      .flatMap((f) => {
        const face = this.face(f, outward);
        if (!face) this.broken += 1;
        return face ?? [];
      });
  }
}

/** Shells of a body: the outer one, and its voids. */
function shellsOf(entity: Part21Entity): readonly Part21Value[] {
  const brep = recordOf(entity, "MANIFOLD_SOLID_BREP") ?? recordOf(entity, "FACETED_BREP"),
    withVoids = recordOf(entity, "BREP_WITH_VOIDS"),
    surfaces = recordOf(entity, "SHELL_BASED_SURFACE_MODEL") ?? recordOf(entity, "FACE_BASED_SURFACE_MODEL");
  if (withVoids)
    return withVoids.values.length > 2
      ? [withVoids.values[1], ...listIn(withVoids.values[2])]
      : [...(brep ? [brep.values.at(-1)] : []), ...listIn(withVoids.values[0])];
  if (brep) return [brep.values.at(-1)];
  return surfaces ? listIn(surfaces.values.at(-1)) : [];
}

const nameOf = (entity: Part21Entity) => {
  const first = (recordOf(entity, "REPRESENTATION_ITEM") ?? entity[0])?.values[0];
  return typeof first === "string" ? first : "";
};

/** Bodies of a file, and the number of those above the limit. */
export function stepBodies(file: Part21File): { readonly bodies: readonly StepBody[]; readonly more: number } {
  const units = stepUnits(file),
    names = productNames(file),
    found: { id: number; entity: Part21Entity; shells: readonly Part21Value[] }[] = [];
  for (const [id, entity] of file.entities) {
    const shells = shellsOf(entity);
    if (shells.length > 0) found.push({ id, entity, shells });
  }
  const bodies = found.slice(0, STEP_LIMITS.bodies).map(({ id, entity, shells }) => {
    const geometry = new StepGeometry(file, units(id)),
      reader = new Shells(geometry);
    const faces = shells.flatMap((s) => reader.shell(s));
    const isSolid = entity.some((r) => /(^|_)BREP(_|$)/.test(r.type));
    return { name: names(id, nameOf(entity)), units: units(id), geometry, faces, isSolid, broken: reader.broken };
  });
  return { bodies, more: found.length - bodies.length };
}

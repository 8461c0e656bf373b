import { part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { IN_MM, inDegrees, toDiameter, type LengthUnit } from "../../kernel/units.ts";

/** Lines and arcs of a drawing, on a layer of their own. */
export interface DxfLayer {
  readonly name: string;
  readonly segments: readonly Segment[];
}

/** Chord tolerance, mm, where X is drawn as a diameter, which turns an arc into an elliptical one. */
export const DXF_CHORD = 0.005;
/** Longer arcs are written as two, radians: the ends of a full circle would coincide. */
const FAR = 1.9 * Math.PI;

type Group = readonly [code: number, value: string | number];

/** Numbers without exponent, precise enough for the angles of large arcs. */
const written = (n: number) => String(Number(n.toFixed(9)) || 0);
const line = (value: string | number) => (typeof value === "number" ? written(value) : value);
const text = (groups: readonly Group[]) =>
  groups.map(([code, value]) => `${String(code).padStart(3)}\r\n${line(value)}\r\n`).join("");

/** Splits an arc into parts of less than a full turn. */
function partsOf(s: Segment): readonly Segment[] {
  if (s.kind === "line" || part.sweepOf(s) < FAR) return [s];
  const middle = part.pointOn(s, 0.5);
  return [
    { ...s, to: middle },
    { ...s, from: middle },
  ];
}

/** Unit codes of the header. */
const CODES: Readonly<Record<LengthUnit, number>> = { mm: 4, inch: 1 };

function lineGroups(
  layer: string,
  from: Pt,
  to: Pt,
  { up, per }: { readonly up: (p: Pt) => number; readonly per: number },
): Group[] {
  return [
    [0, "LINE"],
    [8, layer],
    [10, from.z / per],
    [20, up(from) / per],
    [30, 0],
    [11, to.z / per],
    [21, up(to) / per],
    [31, 0],
  ];
}

/** DXF knows arcs that run counter-clockwise only, by their angles in degrees. */
function arcGroups(layer: string, s: Extract<Segment, { kind: "arc" }>, per: number): Group[] {
  const angle = (p: Pt) => (inDegrees(Math.atan2(p.r - s.centre.r, p.z - s.centre.z)) + 360) % 360;
  const [from, to] = s.turn === "ccw" ? [s.from, s.to] : [s.to, s.from];
  const round: Group[] = [
    [10, s.centre.z / per],
    [20, s.centre.r / per],
    [30, 0],
    [40, part.radiusOf(s) / per],
  ];
  return [[0, "ARC"], [8, layer], ...round, [50, angle(from)], [51, angle(to)]];
}

/**
 * A drawing in the ASCII form of release 12, which every CAD reads: mm or inches, Z to the right, X up. X is a radius,
 * and arcs are true arcs; or it is a diameter, and arcs become chords within DXF_CHORD. Layer names: capital letters,
 * digits and underscores.
 */
export function writeDxf(layers: readonly DxfLayer[], diameters: boolean, unit: LengthUnit): string {
  const up = (p: Pt) => (diameters ? toDiameter(p.r) : p.r),
    per = IN_MM[unit];
  const entities = layers.flatMap(({ name, segments }) =>
    segments.flatMap((s): Group[] => {
      if (s.kind === "arc" && !diameters)
        return partsOf(s).flatMap((piece) => (piece.kind === "arc" ? arcGroups(name, piece, per) : []));
      const points = part.flattened(s, DXF_CHORD);
      return points.slice(1).flatMap((to, i) => lineGroups(name, points[i] ?? to, to, { up, per }));
    }),
  );
  const layerTable = layers.flatMap(({ name }): Group[] => [
    [0, "LAYER"],
    [2, name],
    [70, 0],
    [62, 7],
    [6, "CONTINUOUS"],
  ]);
  const section = (name: string, groups: readonly Group[]): Group[] => [
    [0, "SECTION"],
    [2, name],
    ...groups,
    [0, "ENDSEC"],
  ];
  const table = (name: string, count: number, groups: readonly Group[]): Group[] => [
    [0, "TABLE"],
    [2, name],
    [70, count],
    ...groups,
    [0, "ENDTAB"],
  ];
  const solid: Group[] = [
    [0, "LTYPE"],
    [2, "CONTINUOUS"],
    [70, 0],
    [3, "Solid line"],
    [72, 65],
    [73, 0],
    [40, 0],
  ];
  return text([
    ...section("HEADER", [
      [9, "$ACADVER"],
      [1, "AC1009"],
      [9, "$INSUNITS"],
      [70, CODES[unit]],
    ]),
    ...section("TABLES", [...table("LTYPE", 1, solid), ...table("LAYER", layers.length, layerTable)]),
    ...section("ENTITIES", entities),
    [0, "EOF"],
  ]);
}

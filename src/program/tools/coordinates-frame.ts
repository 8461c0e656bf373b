import { radians } from "../../kernel/units.ts";

type Axis = "x" | "y" | "z";
type Each<T> = Readonly<Record<Axis, T>>;
const AXES: readonly Axis[] = ["x", "y", "z"];

/** A position, mm; null while unknown. X is a distance, as for a mill. */
type Place = Each<number | null>;

/** Transform of the program coordinates besides the datum shift. */
export interface Transform {
  /** Mirrored axes. */
  readonly mirror: Each<boolean>;
  /** Rotation of the X/Y plane, degrees from X towards Y. */
  readonly rotation: number;
  /** Factors, and their fixed point. */
  readonly scale: Each<number>;
  readonly centre: Each<number>;
}

export const NO_TRANSFORM: Transform = {
  mirror: { x: false, y: false, z: false },
  rotation: 0,
  scale: { x: 1, y: 1, z: 1 },
  centre: { x: 0, y: 0, z: 0 },
};

/**
 * Conversion from program to workpiece coordinates: scaled about the centre, rotated, mirrored, shifted. In reverse
 * this is the order of a control: datum, mirror, rotation, scale.
 */
export interface CoordinateFrame {
  readonly shift: Each<number>;
  readonly transform: Transform;
}

/** An angle reduced to one turn. */
const withinATurn = (degrees: number) => degrees - 360 * Math.floor(degrees / 360);

/** Normalizes a transform, so that one without effect equals none. */
export function settledTransform(t: Transform): Transform {
  const rotation = withinATurn(t.rotation);
  const neutral = rotation === 0 && AXES.every((a) => !t.mirror[a] && t.scale[a] === 1);
  return neutral ? NO_TRANSFORM : rotation === t.rotation ? t : { ...t, rotation };
}

/** Cosine and sine; quarter turns without a remainder. */
function waysOf(degrees: number): readonly [number, number] {
  const quarters = withinATurn(degrees) / 90;
  if (!Number.isInteger(quarters)) return [Math.cos(radians(degrees)), Math.sin(radians(degrees))];
  return (
    [
      [1, 0],
      [0, 1],
      [-1, 0],
      [0, -1],
    ] as const
  )[quarters as 0 | 1 | 2 | 3];
}

function turned(p: Place, degrees: number): Place {
  if (withinATurn(degrees) === 0) return p;
  if (p.x === null || p.y === null) return { ...p, x: null, y: null };
  const [cos, sin] = waysOf(degrees);
  return { ...p, x: p.x * cos - p.y * sin, y: p.x * sin + p.y * cos };
}

const eachOf = (p: Place, change: (n: number, axis: Axis) => number): Place => ({
  x: p.x === null ? null : change(p.x, "x"),
  y: p.y === null ? null : change(p.y, "y"),
  z: p.z === null ? null : change(p.z, "z"),
});

/** Converts a program position to the workpiece. */
export function toWorkpiece({ shift, transform: t }: CoordinateFrame, p: Place): Place {
  const scaled = eachOf(p, (n, a) => t.centre[a] + t.scale[a] * (n - t.centre[a]));
  return eachOf(turned(scaled, t.rotation), (n, a) => shift[a] + (t.mirror[a] ? -n : n));
}

/** Converts a workpiece position to the program. */
export function toProgram({ shift, transform: t }: CoordinateFrame, p: Place): Place {
  const unmirrored = eachOf(p, (n, a) => (t.mirror[a] ? shift[a] - n : n - shift[a]));
  return eachOf(turned(unmirrored, -t.rotation), (n, a) => t.centre[a] + (n - t.centre[a]) / t.scale[a]);
}

const AXES_OF = { XY: ["x", "y"], YZ: ["y", "z"], ZX: ["z", "x"] } as const;
type FramePlane = keyof typeof AXES_OF;

/**
 * True when left turns in a plane of the program become right turns on the workpiece: sides and arc directions change.
 */
export function isFlipped(t: Transform, plane: FramePlane): boolean {
  const [a, b] = AXES_OF[plane];
  return t.mirror[a] !== t.mirror[b];
}

/** Scale factor of lengths in a plane; null where circles become ellipses or leave the plane. */
export function growthIn(t: Transform, plane: FramePlane): number | null {
  const [a, b] = AXES_OF[plane];
  return t.scale[a] === t.scale[b] && (plane === "XY" || t.rotation === 0) ? t.scale[a] : null;
}

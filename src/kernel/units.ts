import { SAME_STEP } from "./tolerance.ts";

/**
 * Lengths and angles as types, so that a diameter can never stand where a radius is meant.
 * The casts live here and in the cycle parameters; every other file receives typed values.
 */
declare const unit: unique symbol;
type Of<U extends string> = number & { readonly [unit]: U };

/** X as programs and prompts write it: a diameter, mm. */
export type Diameter = Of<"diameter">;
/** X as the kernel works with it: distance from the spindle axis, mm. */
export type Radius = Of<"radius">;
/** Position along the spindle axis, mm, positive away from the chuck. */
export type Axial = Of<"axial">;
/** A length without a direction: clearance, chamfer leg, corner radius, infeed, mm. */
export type Length = Of<"length">;
/** An angle in degrees. */
export type Degrees = Of<"degrees">;
/** A feed; its unit (mm/rev or mm/min) is stored separately. */
export type Feed = Of<"feed">;

export const diameter = (n: number) => n as Diameter;
export const radius = (n: number) => n as Radius;
export const axial = (n: number) => n as Axial;
export const length = (n: number) => n as Length;
export const degrees = (n: number) => n as Degrees;
export const feed = (n: number) => n as Feed;

/** The only place where X is halved. */
export const toRadius = (d: Diameter) => (d / 2) as Radius;
/** The only place where X is doubled. */
export const toDiameter = (r: Radius) => (r * 2) as Diameter;
/** The length per side of an oversize given as a diameter. */
export const perSide = (d: Diameter) => (d / 2) as Length;

/** Degrees to radians, for trigonometry inside the kernel. */
export const radians = (a: number) => (a * Math.PI) / 180;
/** Radians to degrees. */
export const inDegrees = (a: number) => degrees((a * 180) / Math.PI);

/** Steps per mm of a size that a control displays. */
const STEPS = 1000;
/** The finest step of a size, mm. */
export const STEP = 1 / STEPS;
/**
 * A size rounded to that grid: nearest, down and up. A rounding error of doubles moves no size to the neighbouring
 * step.
 */
export const rounded = (size: number) => Math.round(size * STEPS) / STEPS;
export const roundedDown = (size: number) => Math.floor(size * STEPS + SAME_STEP) / STEPS;
export const roundedUp = (size: number) => Math.ceil(size * STEPS - SAME_STEP) / STEPS;
/** Rounds up or down to a coarser grid, as an operator types it. */
export const roundedUpTo = (step: number, size: number) => rounded(Math.ceil(size / step - SAME_STEP) * step);
export const roundedDownTo = (step: number, size: number) => rounded(Math.floor(size / step + SAME_STEP) * step);

/** Steps per degree of an angle that a control displays. */
const ANGLE_STEPS = 10_000;
/** An angle rounded to that grid, and the next smaller one that is strictly below it. */
export const roundedAngle = (angle: number) => Math.round(angle * ANGLE_STEPS) / ANGLE_STEPS;
export const angleUnder = (angle: number) => (Math.ceil(angle * ANGLE_STEPS - SAME_STEP) - 1) / ANGLE_STEPS;

/** An inch in mm. */
export const INCH = 25.4;
/** The unit of a feed in an inch program, mm: inches per revolution, or tenths of an inch per minute. */
export const inchFeedUnit = (perRevolution: boolean): number => (perRevolution ? INCH : INCH / 10);
/** Unit of the numbers of a program, and its length in mm. */
export type LengthUnit = "mm" | "inch";
export const IN_MM: Readonly<Record<LengthUnit, number>> = { mm: 1, inch: INCH };
/** A length in inches on the grid of a control: one decimal more than in millimetres. */
export const roundedInch = (inches: number) => Math.round(inches * STEPS * 10) / (STEPS * 10);

/** The radius of a ⌀ stored as a plain number, mm. */
export const radiusOf = (across: number): Radius => toRadius(diameter(across));

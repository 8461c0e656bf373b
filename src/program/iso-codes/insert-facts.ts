/*
 * Facts of ISO 1832, the designation of indexable inserts, and of ANSI B212.4, in fractions of an inch. Sources, and
 * where they differ: docs/decisions, the reading of tool codes.
 */

/** Shape of an insert from above. */
export type InsertForm =
  | "rhombic"
  | "parallelogram"
  | "rectangle"
  | "square"
  | "triangle"
  | "trigon"
  | "polygon"
  | "round";

/** Shape by its letter: the included angle at the tip in degrees (0: round), and the form. */
export const INSERT_SHAPES: Readonly<
  Record<string, { readonly angle: number; readonly form: InsertForm; readonly corners?: number }>
> = {
  A: { angle: 85, form: "parallelogram" },
  B: { angle: 82, form: "parallelogram" },
  C: { angle: 80, form: "rhombic" },
  D: { angle: 55, form: "rhombic" },
  E: { angle: 75, form: "rhombic" },
  H: { angle: 120, form: "polygon", corners: 6 },
  K: { angle: 55, form: "parallelogram" },
  L: { angle: 90, form: "rectangle" },
  M: { angle: 86, form: "rhombic" },
  O: { angle: 135, form: "polygon", corners: 8 },
  P: { angle: 108, form: "polygon", corners: 5 },
  R: { angle: 0, form: "round" },
  S: { angle: 90, form: "square" },
  T: { angle: 60, form: "triangle" },
  V: { angle: 35, form: "rhombic" },
  W: { angle: 80, form: "trigon" },
};

/** Normal clearance by its letter, degrees; O is any other. */
export const CLEARANCES: Readonly<Record<string, number>> = {
  A: 3,
  B: 5,
  C: 7,
  D: 15,
  E: 20,
  F: 25,
  G: 30,
  N: 0,
  P: 11,
};

/** Tolerance class: range for the inscribed circle, and for the thickness, each ± mm. */
export const TOLERANCES: Readonly<Record<string, readonly [from: number, to: number, thickness: number]>> = {
  A: [0.025, 0.025, 0.025],
  F: [0.013, 0.013, 0.025],
  C: [0.025, 0.025, 0.025],
  H: [0.013, 0.013, 0.025],
  E: [0.025, 0.025, 0.025],
  G: [0.025, 0.025, 0.13],
  J: [0.05, 0.15, 0.025],
  K: [0.05, 0.15, 0.025],
  L: [0.05, 0.15, 0.025],
  M: [0.05, 0.15, 0.13],
  N: [0.05, 0.15, 0.025],
  U: [0.08, 0.25, 0.13],
};

export type Hole = "none" | "plain" | "sunkOne" | "sunkBoth";
export type Breaker = "none" | "one" | "both";
/** Hole and chip breaker by the letter of the type; X is special. */
export const INSERT_TYPES: Readonly<Record<string, readonly [Hole, Breaker]>> = {
  N: ["none", "none"],
  R: ["none", "one"],
  F: ["none", "both"],
  A: ["plain", "none"],
  M: ["plain", "one"],
  G: ["plain", "both"],
  W: ["sunkOne", "none"],
  T: ["sunkOne", "one"],
  Q: ["sunkBoth", "none"],
  U: ["sunkBoth", "both"],
  B: ["sunkOne", "none"],
  H: ["sunkOne", "one"],
  C: ["sunkBoth", "none"],
  J: ["sunkBoth", "both"],
};

/** Thickness by its two characters, mm. */
export const THICKNESSES: Readonly<Record<string, number>> = {
  "01": 1.59,
  T1: 1.98,
  "02": 2.38,
  T2: 2.78,
  "03": 3.18,
  T3: 3.97,
  "04": 4.76,
  T4: 4.96,
  "05": 5.56,
  T5: 5.95,
  "06": 6.35,
  T6: 6.75,
  "07": 7.94,
  "09": 9.52,
  T9: 9.72,
  "11": 11.11,
  "12": 12.7,
};

/** Sizes of the inscribed circle in use, mm. */
const CIRCLES = [3.97, 4.76, 5.56, 6.35, 7.94, 9.525, 12.7, 15.875, 19.05, 22.225, 25.4, 31.75] as const;

/** Wiper letters instead of the corner radius: the angle of its main edge, and its clearance; Z is any other. */
export const WIPER_EDGES: Readonly<Record<string, number | null>> = { A: 45, D: 60, E: 75, F: 85, P: 90, Z: null };

/** Condition of the edge. */
export const EDGE_FINISHES = ["F", "E", "T", "S", "K", "P"] as const;
export type EdgeFinish = (typeof EDGE_FINISHES)[number];

const sine = (angle: number) => Math.sin((angle * Math.PI) / 180);
const cotangent = (angle: number) => 1 / Math.tan((angle * Math.PI) / 180);

/** Edge length of a shape for an inscribed circle, mm; null where the circle does not define it. */
export function edgeOf(shape: string, circle: number): number | null {
  const known = INSERT_SHAPES[shape];
  switch (known?.form) {
    case "rhombic":
      return circle / sine(known.angle);
    case "square":
    case "round":
      return circle;
    case "triangle":
      return circle * cotangent(30);
    case "trigon":
      // Three corners of 80° and three of 160° around the same circle: an edge connects one of each.
      return (circle * (cotangent(40) + cotangent(80))) / 2;
    case "polygon":
      return circle * Math.tan(Math.PI / (known.corners ?? 6));
    default:
      return null;
  }
}

/**
 * Inscribed circle of a shape from the two digits of its size, the whole millimetres of its edge. Null unless exactly
 * one usual circle matches.
 */
export function circleOf(shape: string, digits: number): number | null {
  const found = CIRCLES.filter((circle) => Math.floor(edgeOf(shape, circle) ?? NaN) === digits);
  return found.length === 1 ? (found[0] ?? null) : null;
}

/** Inscribed circle of an inch code, mm: eighths of an inch from 1/4 on, and the three smaller sizes. */
export function inchCircle(text: string): number | null {
  const small: Readonly<Record<string, number>> = { "1.2": 3.97, "1.5": 4.76, "1.8": 5.56 };
  if (small[text] !== undefined) return small[text];
  const eighths = Number(text);
  return eighths >= 2 && eighths <= 10 && (eighths % 1 === 0 || eighths === 2.5) ? eighths * 3.175 : null;
}

/** Thickness of an inch code, mm: sixteenths of an inch. */
export const inchThickness = (text: string): number | null =>
  Number(text) > 0 ? Math.round(Number(text) * 158.75) / 100 : null;

/** Corner radius of an inch code, mm: 64ths of an inch by the name they have in millimetres (2 is 0.8). */
export const inchCorner = (text: string): number | null =>
  ["0", "0.5", "1", "2", "3", "4", "5", "6", "7", "8"].includes(text) ? Math.round(Number(text) * 4) / 10 : null;

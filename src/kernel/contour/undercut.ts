import type { CornerElement } from "./corner.ts";
import { ROUND } from "../tolerance.ts";
import { undercutOfDiameter, undercutOfPitch } from "./undercut-table.ts";
import { radians, type Diameter } from "../units.ts";

export const UNDERCUT_FORMS = ["E", "F", "H", "K", "U", "THREAD"] as const;
export type UndercutForm = (typeof UNDERCUT_FORMS)[number];
/** Words of undercuts and recesses: lengths in mm, angles in degrees; DIAM and an axial CENTER are radii here. */
export type RecessWord =
  | "R"
  | "DEPTH"
  | "BREADTH"
  | "ANGLE"
  | "ANG_WIDTH"
  | "FACEDEPTH"
  | "FACEANGLE"
  | "ROT"
  | "PITCH"
  | "RND"
  | "CHF"
  | "CENTER"
  | "DIAM"
  | "FAR_RND"
  | "FAR_CHF";
export type RecessWords = { readonly [W in RecessWord]?: number };

/** UDC: an undercut in the corner between a cylinder and a face. Missing words come from the standard. */
export interface Undercut {
  readonly kind: "undercut";
  readonly form: UndercutForm;
  readonly words: RecessWords;
}

/**
 * A corner of the undercut, mm, in its own frame: u along the cylinder away from the face, v along the face away from
 * the cylinder. The cylinder is v = 0, the face u = 0, and the material lies below and behind.
 */
export interface Vertex {
  readonly u: number;
  readonly v: number;
  readonly corner: CornerElement | null;
}

/**
 * An undercut as its corners from the cylinder to the face, with the words taken from the standard; or the word that
 * makes it impossible; or the missing words if the standard does not list the pitch.
 */
export type UndercutShape =
  | { readonly vertices: readonly Vertex[]; readonly defaults: RecessWords }
  | { readonly word: RecessWord }
  | {
      readonly pitch: number;
      readonly missing: readonly RecessWord[];
    };

/** The words of each form in the order of the control; only form E is printed with its words. */
export const UNDERCUT_WORDS: Readonly<Record<UndercutForm, readonly RecessWord[]>> = {
  E: ["R", "DEPTH", "BREADTH", "ANGLE"],
  F: ["R", "DEPTH", "BREADTH", "ANGLE", "FACEDEPTH", "FACEANGLE"],
  H: ["R", "BREADTH", "ANGLE"],
  K: ["R", "DEPTH", "ROT", "ANGLE"],
  U: ["R", "DEPTH", "BREADTH", "RND", "CHF"],
  THREAD: ["PITCH", "R", "DEPTH", "BREADTH", "ANGLE"],
};
/** Words that are angles in degrees; the others are lengths. */
export const ANGLE_WORDS: ReadonlySet<RecessWord> = new Set(["ANGLE", "ANG_WIDTH", "FACEANGLE", "ROT"]);
/** Optional words. */
const SPARE: ReadonlySet<RecessWord> = new Set(["R", "PITCH", "RND", "CHF"]);
/**
 * Forms with tables in a standard; the angles are the same for all. Those of E, F and THREAD are printed for HEIDENHAIN
 * lathes (tag L).
 */
const LISTED: ReadonlySet<UndercutForm> = new Set(["E", "F", "H", "THREAD"]);
const DEFAULT_ANGLES: Readonly<Record<UndercutForm, RecessWords>> = {
  E: { ANGLE: 15 },
  F: { ANGLE: 15, FACEANGLE: 8 },
  H: { ANGLE: 15 },
  K: { ROT: 45 },
  U: {},
  THREAD: { ANGLE: 30 },
};

const vertex = (u: number, v: number, R = 0): Vertex => ({ u, v, corner: R > 0 ? { kind: "round", size: R } : null });
/** The corner element for RND or CHF of an outer edge. */
export const edgeElement = (round: number | undefined, chamfer: number | undefined): CornerElement | null =>
  round !== undefined && round > 0
    ? { kind: "round", size: round }
    : chamfer !== undefined && chamfer > 0
      ? { kind: "chamfer", size: chamfer }
      : null;

/** Standard values for the missing words. */
function defaultsOf({ form, words }: Undercut, diameter: Diameter, inside: boolean): RecessWords {
  const table =
    form === "THREAD"
      ? undercutOfPitch(words.PITCH ?? 0, inside ? { bore: diameter } : "shaft")
      : undercutOfDiameter(diameter);
  const measures: RecessWords = (LISTED.has(form) && table) || {};
  const missing = UNDERCUT_WORDS[form].flatMap((w) =>
    words[w] === undefined && measures[w] !== undefined ? [[w, measures[w]] as const] : [],
  );
  const angles = Object.entries(DEFAULT_ANGLES[form]).filter(([w]) => words[w as RecessWord] === undefined);
  return Object.fromEntries([...missing, ...angles]);
}

/** The shape of an undercut on a cylinder of this diameter. */
export function undercutShape(undercut: Undercut, diameter: Diameter, inside: boolean): UndercutShape {
  const defaults = defaultsOf(undercut, diameter, inside);
  const w: RecessWords = { ...defaults, ...undercut.words };
  const { PITCH } = w;
  const missing = UNDERCUT_WORDS[undercut.form].filter((word) => !SPARE.has(word) && w[word] === undefined);
  if (undercut.form === "THREAD" && PITCH !== undefined && PITCH > ROUND && missing.length > 0)
    return { pitch: PITCH, missing };
  const wrong = impossible(undercut.form, w);
  if (wrong) return { word: wrong };
  const made = verticesOf(undercut.form, w);
  return "word" in made ? made : { vertices: made, defaults };
}

/** The first word that is missing, not positive, or an angle of 90° or more. */
function impossible(form: UndercutForm, w: RecessWords): RecessWord | null {
  const bad = UNDERCUT_WORDS[form].find((name) => {
    const n = w[name];
    return !SPARE.has(name) && (n === undefined || !(n > ROUND) || (ANGLE_WORDS.has(name) && n >= 90));
  });
  return bad ?? ((w.R ?? 0) < 0 ? "R" : null);
}

function verticesOf(form: UndercutForm, w: RecessWords): readonly Vertex[] | { readonly word: RecessWord } {
  const [R, D, B, tan] = [w.R ?? 0, w.DEPTH ?? 0, w.BREADTH ?? 0, Math.tan(radians(w.ANGLE ?? 0))];
  if (form === "H") return [vertex(B, 0), vertex(0, -B * tan, R)];
  if (form === "K") return wedge(R, D, w.ANGLE ?? 0, w.ROT ?? 0);
  if (form === "U") return [{ u: B, v: 0, corner: edgeElement(w.RND, w.CHF) }, vertex(B, -D, R), vertex(0, -D, R)];
  const floor = B - D / tan;
  if (floor <= ROUND) return { word: "BREADTH" };
  const into = [vertex(B, 0), vertex(floor, -D, R)];
  return form === "F" ? intoFace(into, R, D, w.FACEDEPTH ?? 0, radians(w.FACEANGLE ?? 0)) : [...into, vertex(0, -D, R)];
}

/** Form F: behind the floor the arc reaches FACEDEPTH into the face and leaves it on a line inclined by FACEANGLE. */
function intoFace(
  into: readonly Vertex[],
  R: number,
  D: number,
  depth: number,
  lean: number,
): readonly Vertex[] | { readonly word: RecessWord } {
  // The tangent point of arc and line, from the centre of the arc, whose farthest point lies FACEDEPTH behind the face.
  const touch = { u: R - depth - R * Math.cos(lean), v: R - D + R * Math.sin(lean) };
  if (touch.u >= -ROUND) return { word: "FACEDEPTH" };
  const foot = -D - touch.v;
  return [...into, vertex(touch.u + foot * Math.tan(lean), -D, R), vertex(0, touch.v - touch.u / Math.tan(lean))];
}

/**
 * Form K: a wedge into the corner, its axis at ROT to the cylinder; DEPTH is the distance of its round bottom below the
 * cylinder.
 */
function wedge(
  R: number,
  D: number,
  opening: number,
  rotation: number,
): readonly Vertex[] | { readonly word: RecessWord } {
  const half = opening / 2;
  if (half >= rotation || rotation + half >= 90) return { word: "ANGLE" };
  if (D <= R) return { word: "DEPTH" };
  const axis = radians(rotation);
  const back = (D - R) / Math.sin(axis);
  const centre = { u: -back * Math.cos(axis), v: -back * Math.sin(axis) };
  const [low, high] = [radians(rotation - half), radians(rotation + half)];
  // Both flanks touch the bottom circle; they meet behind its centre, on the axis.
  const apex = R / Math.sin(radians(half));
  const tip = { u: centre.u - apex * Math.cos(axis), v: centre.v - apex * Math.sin(axis) };
  const onCylinder = tip.u - tip.v / Math.tan(low);
  const onFace = tip.v - tip.u * Math.tan(high);
  if (onCylinder <= ROUND || onFace <= ROUND) return { word: "DEPTH" };
  return [vertex(onCylinder, 0), vertex(tip.u, tip.v, R), vertex(0, onFace)];
}

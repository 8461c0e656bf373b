import { SAME } from "../tolerance.ts";
import type { Diameter } from "../units.ts";
import type { UndercutForm } from "./undercut.ts";

/** Forms of DIN 509 and ISO 18388. G has no form of UDC. */
export const GROOVE_FORMS = ["E", "F", "G", "H"] as const;
export type GrooveForm = (typeof GROOVE_FORMS)[number];
/** Load that a size is assigned to: usual, or one with increased fatigue strength. */
export type GrooveLoad = "usual" | "fatigue";

/** A relief groove of DIN 509, mm: radius, depth below the cylinder, breadth, and depth into the face (F, H). */
export interface ReliefGroove {
  readonly form: GrooveForm;
  readonly r: number;
  readonly t1: number;
  readonly f: number;
  readonly t2: number;
  /** Diameters that it is assigned to: above the first, up to the second. */
  readonly over: number;
  readonly upTo: number;
  readonly load: GrooveLoad;
  /** Radius of series 1, which the standard prefers. */
  readonly preferred: boolean;
}

type Row = readonly [r: number, t1: number, f: number, t2: number, over: number, upTo: number, load: GrooveLoad];

/**
 * Sizes of forms E and F, of which only F has t2, then of G and H. DIN 509:1998-06 and :2006-12 as three public
 * transcriptions have them (tag S; decision 0052); ISO 18388:2016 has the same forms and designation. The smallest one is
 * of the edition before and of the tables of HEIDENHAIN lathes. f of H 1.2 × 0.3 is 2.5 in one transcription: 2.4 is the
 * value that its radius and the slope of 15° give.
 */
const EF: readonly Row[] = [
  [0.1, 0.1, 0.5, 0.1, 0, 1.6, "usual"],
  [0.2, 0.1, 1, 0.1, 1.6, 3, "usual"],
  [0.4, 0.2, 2, 0.1, 3, 18, "usual"],
  [0.6, 0.2, 2, 0.1, 10, 18, "usual"],
  [0.6, 0.3, 2.5, 0.2, 18, 80, "usual"],
  [0.8, 0.3, 2.5, 0.2, 18, 80, "usual"],
  [1, 0.2, 2.5, 0.1, 18, 50, "fatigue"],
  [1, 0.4, 4, 0.3, 80, Infinity, "usual"],
  [1.2, 0.2, 2.5, 0.1, 18, 50, "fatigue"],
  [1.2, 0.4, 4, 0.3, 80, Infinity, "usual"],
  [1.6, 0.3, 4, 0.2, 50, 80, "fatigue"],
  [2.5, 0.4, 5, 0.3, 80, 125, "fatigue"],
  [4, 0.5, 7, 0.3, 125, Infinity, "fatigue"],
];
const G: readonly Row[] = [[0.4, 0.2, 1, 0.2, 3, 18, "usual"]];
const H: readonly Row[] = [
  [0.8, 0.3, 2, 0.05, 18, 80, "usual"],
  [1.2, 0.3, 2.4, 0.05, 18, 50, "fatigue"],
];
const ROWS: Readonly<Record<GrooveForm, readonly Row[]>> = { E: EF, F: EF, G, H };

/** Radii of series 1. */
const SERIES_1: ReadonlySet<number> = new Set([0.1, 0.2, 0.4, 0.6, 1, 1.6, 2.5, 4]);

/** The sizes of a form, by radius. */
export const groovesOf = (form: GrooveForm): readonly ReliefGroove[] =>
  ROWS[form].map(([r, t1, f, t2, over, upTo, load]) => ({
    form,
    r,
    t1,
    f,
    t2: form === "E" ? 0 : t2,
    over,
    upTo,
    load,
    preferred: SERIES_1.has(r),
  }));

/** The size r × t1 of a form; null if the standard has none. */
export const grooveNamed = (form: GrooveForm, r: number, t1: number): ReliefGroove | null =>
  groovesOf(form).find((g) => Math.abs(g.r - r) <= SAME && Math.abs(g.t1 - t1) <= SAME) ?? null;

/** The size of a form nearest to r × t1; the radius counts first. */
export function nearestGroove(form: GrooveForm, r: number, t1: number): ReliefGroove | null {
  const off = (g: ReliefGroove) => Math.abs(g.r - r) * 10 + Math.abs(g.t1 - t1);
  return groovesOf(form).reduce<ReliefGroove | null>((best, g) => (!best || off(g) < off(best) ? g : best), null);
}

export const isAssigned = (g: ReliefGroove, diameter: Diameter): boolean =>
  diameter > g.over && diameter <= g.upTo + SAME;

/** The sizes of a form for a diameter: those for usual load and of series 1 first. */
export function groovesFor(form: GrooveForm, diameter: Diameter): readonly ReliefGroove[] {
  const rank = (g: ReliefGroove) => (g.load === "usual" ? 0 : 2) + (g.preferred ? 0 : 1);
  return groovesOf(form)
    .filter((g) => isAssigned(g, diameter))
    .sort((a, b) => rank(a) - rank(b));
}

/** The form of UDC that makes a form of the standard. */
export const udcForm = (form: GrooveForm): UndercutForm | null => (form === "G" ? null : form);

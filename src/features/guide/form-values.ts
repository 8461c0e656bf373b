import { approach, type Approach, type ApproachRequest } from "../../kernel/plane/approach.ts";
import { plane, type PlanePoint, type PlaneSegment } from "../../kernel/plane/plane.ts";
import { rounded } from "../../kernel/units.ts";
import type { ApproachForm } from "../../nc/words.ts";
import { readApproach, type ApproachDraft } from "../../program/edits/approach-draft.ts";
import { readyApproach, type ApproachContext } from "../../program/edits/approach-request.ts";

/** Words of APPR and DEP that are shown at three values. */
export type SizedWord = "LEN" | "R" | "CCA" | PolarPlace;
/** Words that name a point from the pole. */
export type PolarPlace = "PR" | "PA";
const FIELD = { LEN: "length", R: "radius", CCA: "centreAngle" } as const;

/** A form with one value of a word. With another point PA the contour begins at another point. */
export interface FormAtValue {
  readonly value: number;
  readonly isUsual: boolean;
  readonly request: ApproachRequest;
  readonly result: Approach;
  readonly contour: readonly PlaneSegment[];
}

/** Shares of the default value: a small and a large one. */
const LESS = 0.4;
const MORE = 2.2;
/** Largest angle of a drawn arc, degrees. */
const MOST_ANGLE = 270;

/** Variation of the point: factors of its distance from the pole, degrees about it. */
const NEARER_FARTHER = [0.7, 1.3];
const ROUND_POLE = [-20, 20];

/** The words of a form with a size; those of a polar point first. */
export const sizedWords = (
  { shape, departing }: Pick<ApproachRequest, "shape" | "departing">,
  polar = false,
): readonly SizedWord[] => [
  ...(polar && (!departing || shape === "LCT") ? (["PR", "PA"] as const) : []),
  ...(shape === "LCT" ? (["R"] as const) : shape === "CT" ? (["R", "CCA"] as const) : (["LEN"] as const)),
];

const isPolarPlace = (word: SizedWord): word is PolarPlace => word === "PR" || word === "PA";
const shown = (value: number) => rounded(Number(value.toFixed(1)));

/** A form with its point at other distances and angles from the pole. */
function atPolarPlaces({ form, draft, context, request }: FormAt, word: PolarPlace): readonly FormAtValue[] {
  const text = draft[word] ?? "",
    sign = /^I/i.exec(text)?.[0] ?? "",
    usual = Number(text.slice(sign.length));
  if (text === "" || !Number.isFinite(usual)) return [];
  const others = word === "PR" ? NEARER_FARTHER.map((by) => usual * by) : ROUND_POLE.map((by) => usual + by);
  const values = [...new Set([usual, ...others.map(shown)])].toSorted((a, b) => a - b);
  return values.flatMap((value) => {
    const typed = { ...draft, [word]: `${sign}${value}` };
    const { departing } = request,
      reading = readApproach({ form, departing }, context.plane, typed, context.parameters);
    const ready = readyApproach(form, departing, reading, context);
    if (!ready) return [];
    // Sizes that the words lack come from the shown form.
    const changed = { ...request, ...ready.request };
    return [{ value, isUsual: value === usual, request: changed, result: approach(changed), contour: ready.contour }];
  });
}

/** The shown form: its request and contour, and the words and context they were read from. */
export interface FormAt {
  readonly form: ApproachForm;
  readonly draft: ApproachDraft;
  readonly context: ApproachContext;
  readonly request: ApproachRequest;
  readonly contour: readonly PlaneSegment[];
}

/** A form at a small, the default and a large value of a word. */
export function formAtValues(at: FormAt, word: SizedWord): readonly FormAtValue[] {
  if (isPolarPlace(word)) return atPolarPlaces(at, word);
  const { request, contour } = at,
    usual = request[FIELD[word]];
  if (usual === undefined) return [];
  const most = word === "CCA" ? MOST_ANGLE : Infinity;
  const values = [usual * LESS, usual, Math.min(most, usual * MORE)].map(shown);
  return [...new Set(values)].map((value) => {
    const changed: ApproachRequest = { ...request, [FIELD[word]]: value };
    return { value, isUsual: value === usual, request: changed, result: approach(changed), contour };
  });
}

/** The programmed point of a form's block: PA, or PN of a departure; null if it names none. */
export const namedAt = (
  { request: { departing, outside }, contour }: FormAtValue,
  { tip }: Pick<ApproachContext, "tip">,
): PlanePoint | null => (departing ? outside && plane.sum(outside, tip) : (contour[0]?.from ?? null));

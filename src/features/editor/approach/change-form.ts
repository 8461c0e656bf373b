import { plane } from "../../../kernel/plane/plane.ts";
import type { ApproachForm } from "../../../nc/words.ts";
import { isPolar } from "../../../program/motion/approach-fields.ts";
import {
  approachDraft,
  approachStatement,
  readApproach,
  type ApproachDraft,
  type ApproachStatement,
} from "../../../program/edits/approach-draft.ts";
import { namedPoint, wordsOfPoint, type ApproachContext } from "../../../program/edits/approach-request.ts";
import { positionAsTyped } from "../../../program/values/typed-value.ts";
import type { SuggestedForm } from "../../../view/approach/forms.ts";

const text = (n: number | undefined, unit: number) => (n === undefined ? "" : positionAsTyped(n / unit));

/** Words of the point of a block. */
const POINT = { XY: ["X", "Y", "PR", "PA"], ZX: ["X", "Z", "PR", "PA"] } as const;

type Form = Pick<SuggestedForm, "shape" | "departing">;

/** An approach names PA; of the departures only LCT names a point. */
const namesPoint = ({ shape, departing }: Form): boolean => !departing || shape === "LCT";

/** A form as its word: polar where it names a point. */
export const formOf = (form: Form, polar: boolean): ApproachForm =>
  polar && namesPoint(form) ? `P${form.shape}` : form.shape;

/**
 * The block with another form. Values common to both forms stay as typed; new ones get values that fit the contour. A
 * point stays where it is when its coordinates become polar or Cartesian.
 */
export function withForm(
  statement: ApproachStatement,
  taken: SuggestedForm,
  context: ApproachContext,
  polar = isPolar(statement.form),
): ApproachStatement {
  const form = formOf(taken, polar && context.pole !== null);
  const old = approachDraft(statement);
  const { request } = taken;
  const fresh: ApproachDraft = {
    LEN: text(request.length, context.unit),
    R: text(request.radius, context.unit),
    CCA: text(request.centreAngle, 1),
  };
  const turnedOver = taken.departing !== statement.departing,
    typed = turnedOver ? {} : readApproach(statement, context.plane, old, context.parameters);
  const suggested = taken.departing ? request.outside && plane.sum(request.outside, context.tip) : request.element.from;
  const point = namedPoint(statement.form, taken.departing, typed, context) ?? suggested;
  const isNew =
    turnedOver ||
    isPolar(form) !== isPolar(statement.form) ||
    (taken.departing && namesPoint(taken) && (old.X ?? "") === "" && (old.PR ?? "") === "");
  const dropped: readonly string[] = isNew || !namesPoint(taken) ? POINT[context.plane] : [];
  const kept = Object.fromEntries(
    Object.entries(old).filter(([word, value]) => value !== "" && !dropped.includes(word)),
  );
  const words = { ...statement.words, axes: statement.words.axes.filter(({ axis }) => !dropped.includes(axis)) };
  const side =
    taken.shape === "CT" && old.SIDE !== "RL" && old.SIDE !== "RR"
      ? { SIDE: request.side === "right" ? "RR" : "RL" }
      : {};
  return approachStatement(
    { ...statement, words, form, departing: taken.departing },
    context.plane,
    { ...fresh, ...(isNew && point ? wordsOfPoint(form, point, context) : {}), ...kept, ...side },
    context.parameters,
  );
}

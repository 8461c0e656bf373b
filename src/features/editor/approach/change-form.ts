import {
  approachDraft,
  approachStatement,
  type ApproachDraft,
  type ApproachStatement,
} from "../../../program/edits/approach-draft.ts";
import { wordsOfPoint, type ApproachContext } from "../../../program/edits/approach-request.ts";
import { positionAsTyped } from "../../../program/values/typed-value.ts";
import type { SuggestedForm } from "../../../view/approach/forms.ts";

const text = (n: number | undefined, unit: number) => (n === undefined ? "" : positionAsTyped(n / unit));

/** The block with another form. Values common to both forms stay as typed; new ones get values that fit the contour. */
export function withForm(
  statement: ApproachStatement,
  taken: SuggestedForm,
  context: ApproachContext,
): ApproachStatement {
  const polar =
    statement.form.startsWith("P") &&
    context.pole !== null &&
    taken.departing === statement.departing &&
    (!taken.departing || taken.shape === "LCT");
  const form = polar ? (`P${taken.shape}` as const) : taken.shape;
  const old = approachDraft(statement);
  const { request } = taken;
  const fresh: ApproachDraft = {
    LEN: text(request.length, context.unit),
    R: text(request.radius, context.unit),
    CCA: text(request.centreAngle, 1),
  };
  const turnedOver = taken.departing !== statement.departing;
  const named =
    turnedOver || (taken.departing && taken.shape === "LCT" && (old.X ?? "") === "" && (old.PR ?? "") === "");
  const point = taken.departing ? request.outside : request.element.from;
  const kept = Object.fromEntries(
    Object.entries(old).filter(([word, typed]) => typed !== "" && !(named && ["X", "Y", "PR", "PA"].includes(word))),
  );
  const side =
    taken.shape === "CT" && old.SIDE !== "RL" && old.SIDE !== "RR"
      ? { SIDE: request.side === "right" ? "RR" : "RL" }
      : {};
  return approachStatement(
    { ...statement, form, departing: taken.departing },
    context.plane,
    {
      ...fresh,
      ...(named && point ? wordsOfPoint(form, point, context) : {}),
      ...kept,
      ...side,
    },
    context.parameters,
  );
}

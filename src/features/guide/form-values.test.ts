import { expect, test } from "vitest";
import { plane, type PlaneSegment } from "../../kernel/plane/plane.ts";
import type { ApproachForm } from "../../nc/words.ts";
import { isPolar, shapeOf } from "../../program/motion/approach-fields.ts";
import { wordsOfPoint, type ApproachContext } from "../../program/edits/approach-request.ts";
import { suggestedForms } from "../../view/approach/forms.ts";
import { formAtValues, namedAt, sizedWords, type FormAt } from "./form-values.ts";

const contour: readonly PlaneSegment[] = [
  { kind: "line", from: { x: 3, y: 71 }, to: { x: 3, y: 5 } },
  {
    kind: "line",
    from: { x: 3, y: 5 },
    to: { x: 67, y: 5 },
  },
];
const pole = { x: 41.3, y: 33.7 };
const context: ApproachContext = {
  plane: "XY",
  before: null,
  contour,
  side: "right",
  toolRadius: 3.7,
  tip: { x: 0, y: 0 },
  pole,
  feedBefore: null,
  unit: 1,
  parameters: {},
};
const forms: readonly FormAt[] = [false, true].flatMap((departing) =>
  suggestedForms({ contour, side: "right", toolRadius: 3.7, outside: null }, departing).flatMap(({ request }) =>
    [request.shape, `P${request.shape}` as const].map((form: ApproachForm) => {
      const at = { ...context, before: departing ? null : request.outside };
      const named = departing ? request.outside : request.element.from;
      return {
        form,
        request,
        contour,
        context: at,
        draft: { ...(named && wordsOfPoint(form, named, at)), SIDE: "RR" },
      };
    }),
  ),
);
const nameOf = ({ form, request: { departing } }: FormAt) => `${departing ? "DEP" : "APPR"} ${form}`;

test("each of the eight forms is drawn at three values of each of its sizes, and each draws another path", () => {
  expect(forms).toHaveLength(16);
  for (const at of forms) {
    const name = nameOf(at),
      polar = isPolar(at.form) && (!at.request.departing || shapeOf(at.form) === "LCT");
    expect(sizedWords(at.request, isPolar(at.form)).length, name).toBe(
      (at.request.shape === "CT" ? 2 : 1) + (polar ? 2 : 0),
    );
    for (const word of sizedWords(at.request, isPolar(at.form))) {
      const three = formAtValues(at, word);
      expect(
        three.map(({ isUsual }) => isUsual),
        `${name} ${word}`,
      ).toEqual([false, true, false]);
      expect(new Set(three.map(({ result }) => JSON.stringify(result.legs))).size, `${name} ${word}`).toBe(3);
    }
  }
});

test("a point from the pole has the shown distance and angle", () => {
  for (const at of forms.filter(({ form, draft }) => isPolar(form) && draft.PR !== undefined)) {
    for (const form of formAtValues(at, "PR")) {
      const { value } = form,
        point = namedAt(form, at.context) ?? { x: NaN, y: NaN };
      expect(Math.hypot(point.x - pole.x, point.y - pole.y), nameOf(at)).toBeCloseTo(value, 6);
    }
    for (const form of formAtValues(at, "PA")) {
      const { value } = form,
        point = namedAt(form, at.context) ?? { x: NaN, y: NaN };
      const turned = (Math.atan2(point.y - pole.y, point.x - pole.x) * 180) / Math.PI - value;
      expect(Math.abs(Math.sin((turned * Math.PI) / 360)), nameOf(at)).toBeCloseTo(0, 6);
    }
  }
});

test("a longer straight piece is longer by what LEN says", () => {
  const straight = forms.find(({ request: { shape, departing } }) => shape === "LT" && departing);
  const lengths =
    straight &&
    formAtValues(straight, "LEN").map(
      ({ value, result }) => result.legs.reduce((sum, { segment }) => sum + plane.lengthOf(segment), 0) - value,
    );
  for (const beyond of lengths ?? [NaN]) expect(beyond).toBeCloseTo(0, 9);
});

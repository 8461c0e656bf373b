import { expect, test } from "vitest";
import { plane, type PlaneSegment } from "../../kernel/plane.ts";
import { suggestedForms } from "../../view/approach/forms.ts";
import { formAtValues, sizedWords } from "./form-values.ts";

const contour: readonly PlaneSegment[] = [{ kind: "line", from: { x: 3, y: 71 }, to: { x: 3, y: 5 } }, {
  kind: "line",
  from: { x: 3, y: 5 },
  to: { x: 67, y: 5 },
}];
const forms = [false, true].flatMap((departing) => suggestedForms({ contour, side: "right", toolRadius: 3.7, outside: null }, departing));

test("each of the eight forms is drawn at three values of each of its sizes, and each draws another way", () => {
  expect(forms).toHaveLength(8);
  for (const { request, departing, shape } of forms) {
    const name = `${departing ? "DEP" : "APPR"} ${shape}`;
    expect(sizedWords(request).length, name).toBe(shape === "CT" ? 2 : 1);
    for (const word of sizedWords(request)) {
      const three = formAtValues(request, word);
      expect(three.map(({ isUsual }) => isUsual), `${name} ${word}`).toEqual([false, true, false]);
      expect(new Set(three.map(({ result }) => JSON.stringify(result.legs))).size, `${name} ${word}`).toBe(3);
    }
  }
});

test("a longer straight piece is longer by what LEN says", () => {
  const straight = forms.find(({ shape, departing }) => shape === "LT" && departing);
  const lengths = straight
    && formAtValues(straight.request, "LEN").map(({ value, result }) =>
      result.legs.reduce((sum, { segment }) => sum + plane.lengthOf(segment), 0) - value
    );
  for (const beyond of lengths ?? [NaN]) expect(beyond).toBeCloseTo(0, 9);
});

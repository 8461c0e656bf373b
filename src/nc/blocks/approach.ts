import { APPROACH_FORMS, noWords, type ApproachForm, type Words } from "../words.ts";
import { defineBlock } from "./define.ts";
import {
  axisFields,
  centreAngleField,
  lineLengthField,
  pathWords,
  polarFields,
  radiusField,
  tailFields,
} from "./path-words.ts";
import { choice, property } from "./words.ts";

type Form = { readonly form: ApproachForm };

/** Approach to a contour and departure from it. */
export const approach = defineBlock({
  kind: "approach",
  keyword: ["APPR", "DEP"],
  words: [
    property<boolean>()("departing", { compareAs: (departing, said) => void said.put("", departing ? "DEP" : "APPR") }),
    choice("form", APPROACH_FORMS, { compared: true }),
    pathWords(
      (words: Words, { form }: Form) => [
        ...(form.startsWith("P") ? polarFields : axisFields(words)),
        lineLengthField,
        centreAngleField,
        radiusField,
        ...tailFields,
      ],
      {
        wide: false,
        // R of the CT forms and LEN of the LN forms carry a sign; the others are bare.
        signs: ({ form }: Form) => ({ length: form.endsWith("LN"), radius: form === "CT" || form === "PCT" }),
      },
    ),
  ],
  found: ({ head }) => ({ departing: head.toUpperCase() === "DEP" }),
  lead: (s) => (s.departing ? "DEP" : "APPR"),
  pairKey: (s) => `approach ${s.departing}`,
  nameKey: (s) => `approach ${s.departing}`,
  part: "operations",
  nameOf: (s) => (s.departing ? "departure" : "approach"),
  names: {
    approach: {
      offered: {
        group: "path",
        begins: {
          kind: "approach",
          departing: false,
          form: "LT",
          words: {
            ...noWords,
            axes: [
              { axis: "X", value: 0, incremental: false },
              { axis: "Y", value: 0, incremental: false },
            ],
            length: 15,
            compensation: "RR",
            feed: { value: 100, unit: "F" },
          },
        },
      },
    },
    departure: {
      offered: {
        group: "path",
        begins: { kind: "approach", departing: true, form: "LT", words: { ...noWords, length: 15 } },
      },
    },
  },
});

import { defineBlock } from "./define.ts";
import { CONE, program } from "./sample.ts";
import { measured, toolAxis, value } from "./words.ts";

/** A bar or disc as blank: outside, length, distance of its face from Z0, and a bore. */
export const blankCylinder = defineBlock({
  kind: "blankCylinder",
  keyword: "BLK FORM CYLINDER",
  words: [
    toolAxis("axis"),
    measured("outside", "outsideMeasure", ["D", "R"], {
      needed: true,
      spread: { times: [0.85, 1.25] },
      setup: "blank.outside",
    }),
    value("length", "L", {
      unit: "mm",
      plain: true,
      needed: true,
      spread: { times: [0.7, 1.4] },
      setup: "blank.length",
    }),
    value("distance", "DIST", { unit: "mm", spread: { plus: [2, 5] }, setup: "blank.allowance" }),
    measured("inside", "insideMeasure", ["DI", "RI"], { spread: { times: [0.6, 1.4] }, setup: "blank.bore" }),
  ],
  tags: ["blank", "opening"],
  part: "labels",
  offered: {
    group: "frame",
    begins: {
      kind: "blankCylinder",
      axis: "Z",
      outside: { measure: "D", value: 80 },
      length: 100,
      distance: 1,
      inside: null,
    },
  },
  sample: program("> BLK FORM CYLINDER Z D50 L60 DIST+1 DI20", CONE),
});

import { defineBlock } from "./define.ts";
import { namedWords } from "./named-words.ts";
import { choice } from "./words.ts";

const WORDS = [
  "CENTER",
  "R",
  "DEPTH",
  "DIAM",
  "BREADTH",
  "ANGLE",
  "ANG_WIDTH",
  "RND",
  "CHF",
  "FAR_RND",
  "FAR_CHF",
] as const;
const GROOVE = "> GRV RADIAL CENTER-15";

/** A recess in the element of a contour before it. */
export const groove = defineBlock({
  kind: "groove",
  keyword: "GRV",
  words: [
    choice("form", ["RADIAL", "AXIAL"], { compared: true, noPicture: "choice" }),
    namedWords(() => WORDS, { spreads: { ANGLE: { plus: [-15, 15] }, ANG_WIDTH: { plus: [-30, 30] } } }),
  ],
  offered: {
    group: "contour",
    begins: {
      kind: "groove",
      form: "RADIAL",
      words: [
        { name: "DEPTH", value: 2 },
        { name: "BREADTH", value: 5 },
      ],
    },
  },
  sample: `${GROOVE} R0.4 DEPTH-2 BREADTH8 ANGLE45 CHF0.5`,
  samples: {
    DIAM: `${GROOVE} DIAM+16 BREADTH8 ANGLE45`,
    ANG_WIDTH: `${GROOVE} DEPTH-2 BREADTH8 ANG_WIDTH60`,
    RND: `${GROOVE} DEPTH-2 BREADTH8 ANGLE45 RND0.5`,
    FAR_RND: `${GROOVE} DEPTH-2 BREADTH8 ANGLE45 RND0.2 FAR_RND0.8`,
    FAR_CHF: `${GROOVE} DEPTH-2 BREADTH8 ANGLE45 CHF0.2 FAR_CHF0.8`,
  },
});

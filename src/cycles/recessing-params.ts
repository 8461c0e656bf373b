import { axialDepth, choice, factorParam, percentParam, radial, revolutionsParam, whenRoughing } from "./params.ts";

/** The parameters of the recessing cycles after the limit of a plunge, in the order of their lists. */
const side = {
  Q510: factorParam("recessingOverlap", [0.001, 1], 0.8, { shown: "overlap", counts: whenRoughing, filledIn: 0.8 }),
  Q511: percentParam("solidFeed", [0.001, 150], 100, { shown: "solidFeed", counts: whenRoughing, filledIn: 100 }),
  Q462: choice("retraction", [0, 1], 0, { shown: "retraction", counts: whenRoughing, filledIn: 0 }),
  Q211: revolutionsParam("dwellTurns", [0, 999.99], 3, {
    decimals: 2,
    shown: "dwell",
    counts: whenRoughing,
    filledIn: 0,
  }),
  Q562: choice("combRecessing", [0, 1], 0, { shown: "comb", counts: whenRoughing, filledIn: 0 }),
};

/** The end of every recessing list: the limit of a plunge is on the radius, or along Z. */
export const radialPlunges = {
  Q463: radial("plungeLimit", [0, 99.999], 0, { shown: "depthLimit", filledIn: 0 }),
  ...side,
};
export const axialPlunges = {
  Q463: axialDepth("plungeLimit", [0, 99.999], 0, { shown: "depthLimit", filledIn: 0 }),
  ...side,
};

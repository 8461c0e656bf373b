import type { Measuring } from "../measure/measuring.ts";

const nothing = () => undefined;

/** The plane view has no ruler: what the shared keys and gestures would do with one is nothing. */
export const noMeasuring: Measuring = {
  on: false,
  kind: "distance",
  choose: nothing,
  toggle: nothing,
  serve: nothing,
  key: () => false,
  tap: nothing,
  hover: nothing,
  drag: nothing,
};

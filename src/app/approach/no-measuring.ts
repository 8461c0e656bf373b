import type { Measuring } from "../lathe/measuring.ts";

const nothing = () => undefined;

/** The plane view has no ruler: what the shared keys and gestures would do with one is nothing. */
export const noMeasuring: Measuring = {
  on: false,
  cross: null,
  first: null,
  second: null,
  toggle: nothing,
  key: () => false,
  tap: nothing,
  hover: nothing,
  drag: nothing,
};

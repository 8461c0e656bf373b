/** Fields of the set-up that are proposed until set. */
export const SETUP_PLACES = [
  "tool",
  "blank.outside",
  "blank.bore",
  "blank.length",
  "blank.allowance",
  "start.x",
  "start.z",
] as const;
export type SetupPlace = (typeof SETUP_PLACES)[number];

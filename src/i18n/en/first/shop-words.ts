import type { ShopWords } from "../../shop-words.ts";

export const shopWords: ShopWords = {
  groups: {
    special: ["set up", "coordinate system", "reset"],
    longitudinal: ["turn", "bore", "boring", "outside diameter", "inside diameter", "along the axis"],
    transverse: ["face", "facing", "across the axis"],
    recessTurning: ["groove", "recess", "slot", "side turning"],
    recessing: ["groove", "recess", "slot", "part off", "parting", "cut off", "plunge"],
    thread: ["thread", "threading", "screw", "pitch", "tap"],
  },
  free: ["profile", "shape", "undercut", "contour"],
  same: [
    ["shoulder", "step"],
    ["groove", "recess", "slot"],
    ["face", "facing"],
    ["contour", "profile"],
  ],
};

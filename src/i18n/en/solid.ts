import type { Shape } from "../shape.ts";

/** The view of the turned body in 3D. */
export const solid = {
  title: "3D view",
  picture: (cut: boolean, state: string) =>
    `The turned body in 3D${cut ? ", a quarter cut away" : ""}, Z to the right. ${state}`,
  keys:
    "Arrow keys turn the view, with Shift they slide it; plus and minus zoom, 0 shows everything; " +
    "1, 2 and 3 are the views at an angle, from the front and at the face.",
  views: "Views",
  quarter: "Cut a quarter away",
  quarterShort: "Quarter",
  iso: "At an angle",
  front: "From the front",
  end: "At the face",
  threads: "The threads here are drawn as rings, without their lead.",
  left: "Left-handed threads: M4, or a feed away from the chuck.",
  milled: "What is milled is not in this body: see the working plane.",
  noBlank: "No blank is stated: only the path is shown.",
  surfaces: "Surfaces",
  textures: { raw: "as delivered", rough: "rough", thread: "thread", finished: "finished" },
  marked: { residual: "residual material", gouge: "gouge, collision" },
  missing: "This browser shows no 3D here: it has no WebGL to give. The section is shown in its place.",
  lost: "The graphics card was taken away. The section is shown until 3D is back.",
  again: "Try 3D again",
};

export type SolidTexts = Shape<typeof solid>;

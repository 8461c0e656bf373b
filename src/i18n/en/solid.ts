import type { Shape } from "../shape.ts";

/** The view of the turned body in 3D. */
export const solid = {
  title: "3D view",
  picture: (cut: boolean, state: string) =>
    `The turned part in 3D${cut ? ", quarter section" : ""}, Z to the right. ${state}`,
  keys: "Arrow keys rotate the view, with Shift they move it; plus and minus zoom, 0 shows everything; 1, 2 and 3 are the views isometric, front and face.",
  views: "Views",
  quarter: "Quarter section",
  quarterShort: "Section",
  iso: "Isometric",
  front: "Front",
  end: "Face",
  threads: "Threads are drawn as rings, without lead.",
  left: "Left-hand threads: M4, or a feed away from the chuck.",
  milled: "Milling is not shown in this body: see the working plane.",
  noBlank: "No blank defined: only the path is shown.",
  surfaces: "Surfaces",
  textures: { raw: "unmachined", rough: "rough", thread: "thread", finished: "finished" },
  marked: { residual: "residual material", gouge: "contour damage, collision" },
  missing: "This browser cannot show 3D here (no WebGL). The section is shown instead.",
  lost: "The connection to the graphics card was lost. The section is shown until 3D is back.",
  again: "Try 3D again",
};

export type SolidTexts = Shape<typeof solid>;

import type { SomeParamTexts } from "../../../param-text.ts";

export const turning = {
  reverseAlong: {
    prompt: "Reverse contour (0-2)?",
    printed: false,
    label: "Reverse contour",
    explanation: "Direction in which the contour is machined.",
    choices: {
      0: "as programmed",
      1: "against the programmed direction",
      2: "against the programmed direction, with the tip mirrored in the feed direction (orientation 1 cuts as 3)",
    },
  },
  flankAngleRadial: {
    prompt: "Angle of flank?",
    printed: false,
    label: "Flank angle",
    explanation:
      "Angle between the flank at the contour start and a perpendicular to the rotary axis. The recess gets " +
      "narrower towards the floor.",
  },
  secondFlankAngleRadial: {
    prompt: "Angle of second flank?",
    printed: false,
    label: "Second flank angle",
    explanation: "Angle between the flank at the contour end and a perpendicular to the rotary axis.",
  },
  infeedFace: {
    prompt: "Maximum cutting depth?",
    printed: false,
    label: "Max. infeed",
    explanation:
      "Largest infeed per pass, along Z. The depth is divided evenly, so the actual infeed is often smaller, " +
      "without a thin last cut.",
  },
  infeedContour: {
    prompt: "Maximum cutting depth?",
    printed: false,
    label: "Max. infeed",
    explanation:
      "Largest infeed per pass, on the radius. The depth is divided evenly, so the actual infeed is often " +
      "smaller, without a thin last cut. 0: one pass.",
  },
  plungeAngle: {
    prompt: "Angle of flank?",
    printed: false,
    label: "Flank angle",
    explanation:
      "Angle between the flank at the contour start and a perpendicular to the rotary axis. The flank descends " +
      "from the contour start into the area to be machined, never behind the edge.",
  },
  plungeAngleFace: {
    prompt: "Angle of flank?",
    printed: false,
    label: "Flank angle",
    explanation:
      "Angle between the flank at the contour start and a parallel to the rotary axis. The flank descends from " +
      "the contour start into the area to be machined, never behind the edge.",
  },
} satisfies SomeParamTexts;

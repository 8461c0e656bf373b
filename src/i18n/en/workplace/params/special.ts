import type { SomeParamTexts } from "../../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "Allowance on the blank?",
    printed: false,
    label: "Blank allowance",
    explanation: "Allowance on the contour before the cycle, measured perpendicular to the contour, on faces too.",
  },
  cuttingLines: {
    prompt: "Type of cutting lines (0/1)?",
    printed: false,
    label: "Cutting lines",
    explanation: "How the allowance is divided into passes.",
    choices: {
      0: "constant chip cross-section: longer passes are thinner, each removes the same area",
      1: "equidistant: all passes have the same thickness",
    },
  },
  infeedParallel: {
    prompt: "Maximum cutting depth?",
    printed: false,
    label: "Max. infeed",
    explanation: "Maximum infeed per pass, measured perpendicular to the contour. 0: one pass.",
  },
  precessionAngle: {
    prompt: "Precession angle?",
    printed: false,
    label: "Precession angle",
    explanation:
      "Rotates the coordinate system about the spindle axis Z. If both spindles are parallel, any angle is " +
      "possible; otherwise only two angles make sense.",
  },
  reverseTool: {
    prompt: "Reverse tool (0=no/1=yes)?",
    printed: false,
    label: "Reverse tool",
    explanation: "Rotates the tool by 180° about its axis, which mirrors the cutting edge.",
    choices: { 0: "not reversed", 1: "rotated by 180°" },
  },
  inclinedMachining: {
    prompt: "Inclined machining (0/1/2/3)?",
    printed: false,
    label: "Inclined machining",
    explanation: "How the tilting axes reach the angle of incidence.",
    choices: {
      0: "axes already positioned: the coordinate system follows them; the control asks for M144 or M128/TCPM",
      1: "position the axes, with compensating movement of the tip",
      2: "position the axes, without compensating movement",
      3: "only calculate the axis angles (Q120, Q121, Q122), without movement; position the axes afterwards",
    },
  },
  incidenceAngle: {
    prompt: "Angle of incidence?",
    printed: false,
    label: "Angle of incidence",
    explanation: "Angle by which the tool is inclined to the workpiece.",
  },
  tiltingFeed: {
    prompt: "Feed rate for positioning?",
    printed: false,
    label: "Positioning feed",
    explanation: "Feed of the tilting axes, mm/min.",
  },
  preferredDirection: {
    prompt: "Preferred dir. of incid. angle?",
    printed: false,
    label: "Preferred direction",
    explanation: "Which of several possible positions the tilting axes take.",
    choices: {
      0: "the nearest",
      1: "between 0° and +180°",
      2: "between +90° and +180°",
      [-2]: "between −90° and −180°",
      [-1]: "between 0° and −180°",
    },
  },
  eccentricTurning: {
    prompt: "Eccentric turning (0-3)?",
    printed: false,
    label: "Eccentric turning",
    explanation:
      "Couples the axes for turning off the table centre. Values other than 0 and 3 are kept but not verified.",
    choices: {
      0: "switch couplings off",
      1: "switch couplings on, rotate about the preset",
      2: "switch couplings on, rotate about the datum",
      3: "leave couplings as they are",
    },
  },
  eccentricWithoutStop: {
    prompt: "Eccentric turning without stop (0/1)?",
    printed: false,
    label: "Eccentric without stop",
    explanation: "Whether the program stops before eccentric turning begins.",
    choices: { 0: "stop first", 1: "no stop" },
  },
} satisfies SomeParamTexts;

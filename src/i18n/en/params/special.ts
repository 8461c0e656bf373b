import type { SomeParamTexts } from "../../param-text.ts";

export const special = {
  blankAllowance: {
    prompt: "Allowance on the blank?",
    printed: false,
    label: "Blank allowance",
    explanation:
      "What stands on the contour before the cycle, measured square to it everywhere, also on faces. Our reading; verify on your control.",
  },
  cuttingLines: {
    prompt: "Type of cutting lines (0/1)?",
    printed: false,
    label: "Cutting lines",
    explanation: "How the allowance is divided into passes.",
    choices: {
      0: "constant chip cross-section: longer passes are thinner, each takes the same area",
      1: "equidistant: each pass as thick as the others",
    },
  },
  infeedParallel: {
    prompt: "Maximum cutting depth?",
    printed: false,
    label: "Max. infeed",
    explanation: "The most that one pass takes, measured square to the contour. 0: everything in one pass.",
  },
} satisfies SomeParamTexts;

import type { SomeParamTexts } from "../../../param-text.ts";

export const recessing = {
  plungeLimit: {
    prompt: "Limit of the recessing depth?",
    printed: false,
    label: "Depth limit",
    explanation:
      "Maximum depth of one plunging step. A deeper plunge is divided evenly; between steps the tool retracts by " +
      "0.5 mm to break the chip. 0: each plunge in one step.",
  },
  recessingOverlap: {
    prompt: "Overlap when recessing?",
    printed: false,
    label: "Overlap",
    explanation:
      "Lateral step from one plunge to the next, as a factor of CUTWIDTH. The steps are divided evenly, so the " +
      "last plunge is at the other wall. In comb recessing: the width of a web.",
  },
  solidFeed: {
    prompt: "Feed factor for the full cut?",
    printed: false,
    label: "Feed in solid",
    explanation:
      "Feed of a plunge into solid material, in percent of the roughing feed Q478. A plunge that overlaps a " +
      "previous one runs at the full feed.",
  },
  retraction: {
    prompt: "Retraction (0/1)?",
    printed: false,
    label: "Retraction",
    explanation: "How the tool leaves a plunge.",
    choices: { 0: "straight out, along the contour", 1: "first at an angle away from the flank, then out" },
  },
  dwellTurns: {
    prompt: "Dwell in revolutions?",
    printed: false,
    label: "Dwell",
    explanation: "Spindle revolutions during which the tool dwells on the floor of a plunge before it retracts.",
  },
  combRecessing: {
    prompt: "Comb recessing (0/1)?",
    printed: false,
    label: "Comb",
    explanation: "Order of the plunges.",
    choices: { 0: "each next to the previous one, overlapping", 1: "first full cuts, then the webs between them" },
  },
} satisfies SomeParamTexts;

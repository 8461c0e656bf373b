import type { SomeParamTexts } from "../../../param-text.ts";

export const recessing = {
  plungeLimit: {
    prompt: "Limit of the recessing depth?",
    printed: false,
    label: "Depth limit",
    explanation:
      "Largest depth of one bite. A deeper plunge is divided evenly, and between two bites the tool goes back by 0.5 " +
      "mm to break the chip. 0: each plunge in one go. Our reading; verify on your control.",
  },
  recessingOverlap: {
    prompt: "Overlap when recessing?",
    printed: false,
    label: "Overlap",
    explanation:
      "Side step from one plunge to the next, as a share of CUTWIDTH. The steps are divided evenly, so that the last " +
      "plunge stands at the other wall. In a comb it is the width of a web.",
  },
  solidFeed: {
    prompt: "Feed factor for the full cut?",
    printed: false,
    label: "Feed in solid",
    explanation:
      "Feed of a plunge into solid material, in percent of the roughing feed Q478. A plunge beside one that overlaps " +
      "it runs at the full feed.",
  },
  retraction: {
    prompt: "Retraction (0/1)?",
    printed: false,
    label: "Retraction",
    explanation: "How the tool leaves a plunge. Our reading; verify on your control.",
    choices: { 0: "straight out, along the contour", 1: "first aslant, clear of the flank, then out" },
  },
  dwellTurns: {
    prompt: "Dwell in revolutions?",
    printed: false,
    label: "Dwell",
    explanation: "How many turns the spindle makes while the tool stands on the floor of a plunge, before it retracts.",
  },
  combRecessing: {
    prompt: "Comb recessing (0/1)?",
    printed: false,
    label: "Comb",
    explanation: "The order of the plunges.",
    choices: { 0: "each beside the one before, overlapping", 1: "first full cuts, then the webs between them" },
  },
} satisfies SomeParamTexts;

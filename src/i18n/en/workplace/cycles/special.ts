import type { CycleTexts } from "../../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "Adjust the coordinate system",
    summary: "Adapts the turning coordinate system to an inclined or rotated tool.",
    description: [
      "Describes the tool relative to the workpiece: rotated about its axis, reversed, inclined. The cycle is " +
        "effective from its definition and needs no call.",
      "Program the cycle before turning and after every tool change.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "With all angles 0, without a reversed tool and with Q535 = 0 or 3 the cycle changes nothing. With any " +
        "other values the block is kept but not simulated, and the program is unverified from here.",
      "Newer software adds the retraction parameter Q599; the parameter is kept.",
    ],
  },
  801: {
    name: "Reset the coordinate system",
    summary: "Cancels the adaptation by cycle 800.",
    description: [
      "Resets the turning coordinate system. The cycle has no parameters, is effective from its definition and " +
        "needs no call.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "A program unverified after cycle 800 remains unverified: the position of the machine is not known here.",
    ],
  },
} satisfies CycleTexts;

import type { CycleTexts } from "../../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "Adjust the coordinate system",
    summary: "Fits the coordinate system of turning to a tilted or rotated tool.",
    description: [
      "Says how the tool stands to the workpiece: turned about its axis, upside down, tilted. It acts where it stands in the " +
        "program and needs no call.",
      "Call it before turning and after every tool change.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "With all angles 0, without a reversed tool and with Q535 = 0 or 3 it changes nothing, and the program is run on. With " +
        "anything else the block is kept, and nothing behind it is proved.",
      "Newer software adds a retraction parameter Q599; it is kept.",
    ],
  },
  801: {
    name: "Reset the coordinate system",
    summary: "Takes back what cycle 800 has fitted.",
    description: [
      "Puts the coordinate system of turning back. It has no parameters, acts where it stands in the program and needs no call.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Whatever cycle 800 has left unproved stays so: where the machine stands then, nobody here knows.",
    ],
  },
} satisfies CycleTexts;

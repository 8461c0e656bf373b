import type { Shape } from "../shape.ts";

/** Settings of the program text for one machine. */
export const output = {
  title: "NC output",
  lead: "How the program is written for your machine. The settings are saved and shared with the program.",
  leadProgram: "Applies to operations that you insert. The existing text is not changed.",
  preset: "Preset",
  presets: {
    manual: "As in the manual's examples: M303, M305",
    mainSpindle: "Main spindle drives the workpiece: M3, M5",
    transfer: "Older file transfer: M3, M5, CR LF, no block numbers, capitals",
    own: "Machine-specific",
  },
  spindleOn: "Spindle on",
  spindleOff: "Spindle off at the end",
  spindleOffHint: "Empty: M30 or M2 stops the spindle.",
  functionWrong: "A number from 0 to 999",
  retract: "Retract at the end",
  retracts: { position: "Safe position above the blank", limit: "Traverse limit in the tool axis (M140 MB MAX)" },
  end: "End of program",
  ends: { 30: "M30", 2: "M2" },
  numbered: "Block numbers",
  newLine: "Line end",
  newLines: { "\n": "LF", "\r\n": "CR LF" },
  name: "Program name",
  names: { typed: "As typed", capitals: "Capitals" },
  makeDefault: "Use for new programs",
  isDefault: "Used for new programs.",
  unverified: "Which M functions drive the spindle depends on the machine: see the machine manual.",
};

export type OutputTexts = Shape<typeof output>;

import type { Shape } from "../shape.ts";

/** Files of the device: what stands in the way of saving, and several programs at once. */
export const files = {
  changed: {
    title: (file: string) => `${file} has changed on the device`,
    text: "It holds something else than what was read or saved here. Nothing has been written.",
  },
  gone: {
    title: (file: string) => `${file} is no longer there`,
    text: "It was moved, renamed or deleted. Nothing has been written.",
  },
  refused: {
    title: (file: string) => `${file} may not be written`,
    text: "The browser was not given the right to write it.",
  },
  failed: {
    title: (file: string) => `${file} could not be written`,
    text: "The device did not take it. The program is still here.",
  },
  compare: "Compare with it",
  overwrite: "Write over it",
  elsewhere: "Save as another file",
  download: "Download",
  cancel: "Cancel",
  choose: {
    title: "Which program?",
    lead: (programs: number) =>
      `${programs} programs that no other calls. Each becomes a work of its own, with the files that it calls.`,
    open: (file: string) => `Open ${file}`,
    with: (count: number) => (count === 1 ? "with 1 file" : `with ${count} files`),
    alone: "calls nothing",
    all: (count: number) => `Open all ${count}`,
    together: "Open all as one work",
    skipped: (count: number) =>
      count === 1
        ? "1 file is no program text and was left out."
        : `${count} files are no program texts and were left out.`,
    cut: "The folder holds more than is opened at once. The rest was left out.",
  },
} as const;

export type FilesTexts = Shape<typeof files>;

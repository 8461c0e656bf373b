import type { Shape } from "../shape.ts";

/** Files of the device: obstacles to saving, and several programs at once. */
export const files = {
  changed: {
    title: (file: string) => `${file} has changed on the device`,
    text: "The file differs from the version that was opened or saved here. Nothing has been written.",
  },
  gone: {
    title: (file: string) => `${file} is no longer there`,
    text: "The file was moved, renamed or deleted. Nothing has been written.",
  },
  refused: {
    title: (file: string) => `No permission to write ${file}`,
    text: "The browser was not given permission to write the file.",
  },
  failed: {
    title: (file: string) => `${file} could not be written`,
    text: "The device rejected the file. The program is still open here.",
  },
  compare: "Compare",
  overwrite: "Overwrite",
  elsewhere: "Save as another file",
  download: "Download",
  cancel: "Cancel",
  choose: {
    title: "Which program?",
    lead: (programs: number) =>
      `${programs} programs are not called by any other. Each opens as a separate program, with the files it calls.`,
    open: (file: string) => `Open ${file}`,
    with: (count: number) => (count === 1 ? "with 1 file" : `with ${count} files`),
    alone: "calls no files",
    all: (count: number) => `Open all ${count}`,
    together: "Open all as one program",
    skipped: (count: number) =>
      count === 1
        ? "1 file is not a program text and was left out."
        : `${count} files are not program texts and were left out.`,
    cut: "The folder contains more files than can be opened at once. The rest was left out.",
  },
} as const;

export type FilesTexts = Shape<typeof files>;

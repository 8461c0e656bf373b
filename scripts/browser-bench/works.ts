import { readFileSync } from "node:fs";
import type { Turnwise } from "../../e2e/pages/turnwise.ts";
import { linkOf } from "../../src/app/records/link.ts";
import { ncLabels } from "../../src/i18n/nc-labels.ts";
import { printJob } from "../../src/program/job/print-job.ts";
import { longContour } from "../long-contour.ts";
import { grownProgram, milledProgram } from "../large-programs.ts";

/** A measured program, and the prompt for typing. */
export interface MeasuredWork {
  readonly name: string;
  /** Shares of the running time from which playback is measured: while cutting, not on the way to the tool change. */
  readonly from: readonly number[];
  readonly open: (turnwise: Turnwise) => Promise<void>;
  /** Opens a prompt where every digit changes the path. */
  readonly ask: (turnwise: Turnwise) => Promise<void>;
}

/** Operations and moves of the grown program. */
const GROWN = { operations: 100, moves: 50_000 };

/** A contour of 1,000 elements for cycle 820. */
const CONTOUR = longContour(820, 1000);

/** Opens the dialog of an operation at one of its prompts. */
const askOperation =
  (number: number, q: string) =>
  async ({ editor, dialog }: Turnwise) => {
    await editor.show("structure");
    await editor.operation(number).click();
    await editor.show("block");
    await dialog.open(q);
  };

export const WORKS: readonly MeasuredWork[] = [
  {
    name: "flange",
    from: [0.05, 0.2, 0.35, 0.5, 0.65, 0.8],
    open: ({ editor }) => editor.openFile("FLANGE.h", readFileSync("src/examples/flange.h")),
    ask: askOperation(2, "Q484"),
  },
  {
    name: "812",
    from: [0.1, 0.25, 0.4, 0.55, 0.7],
    open: ({ start }) => start.beginWithExample(812),
    async ask(turnwise) {
      await turnwise.show("prompts");
      await turnwise.dialog.open("Q484");
    },
  },
  {
    name: "plate",
    from: [0.1, 0.25, 0.4, 0.55, 0.7],
    open: ({ editor }) => editor.openFile("PLATE.h", readFileSync("src/examples/plate.h")),
    async ask({ editor, page }) {
      await editor.line("APPR LT").click();
      await editor.show("block");
      await page.getByRole("button", { name: /^LEN / }).click();
    },
  },
  {
    name: "milled",
    from: [0.1, 0.25, 0.4, 0.55, 0.7],
    open: ({ editor }) => editor.openFile("MILLED.h", Buffer.from(milledProgram(3000))),
    async ask({ editor, page }) {
      await editor.line("APPR LT").click();
      await editor.show("block");
      await page.getByRole("button", { name: /^LEN / }).click();
    },
  },
  {
    name: "grown",
    from: [0.15, 0.4, 0.65, 0.9],
    open: ({ editor }) => editor.openFile("GROWN.h", Buffer.from(grownProgram(GROWN.operations, GROWN.moves))),
    ask: askOperation(GROWN.operations, "Q484"),
  },
  {
    name: "contour",
    from: [0.1, 0.25, 0.4, 0.55, 0.7],
    async open({ page, sharing }) {
      const link = linkOf(page.url().replace(/#.*/, ""), CONTOUR);
      // As a link from outside: changing only the hash would not reload the page.
      await page.goto("about:blank");
      await page.goto(link);
      await sharing.open();
    },
    async ask(turnwise) {
      await turnwise.show("prompts");
      await turnwise.dialog.open("Q484");
    },
  },
  {
    name: "contour text",
    from: [0.1, 0.25, 0.4, 0.55, 0.7],
    open: ({ editor }) => editor.openFile("WAVES.h", Buffer.from(printJob(CONTOUR, ncLabels("en")))),
    ask: askOperation(1, "Q484"),
  },
];

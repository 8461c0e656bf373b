import { cycleByNumber } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { openText } from "../../app/fields/open/open-program.ts";
import { showTextBlock } from "../../app/fields/blocks/show-text-block.ts";
import { showComparison, showDrawing, showSection, showShare } from "../../app/place/place.ts";
import { startWork } from "../../app/records/keep.ts";
import { exampleText, openExample } from "./open-example.ts";

/** The cycle whose contour is shown with an unknown, and the point that is given by an angle instead of its Z. */
const UNKNOWN = { cycle: 810, row: "e4", angle: "200.556" };

/** A cycle with a contour of which one dimension is calculated. */
export function showUnknowns(): void {
  const cycle = cycleByNumber(UNKNOWN.cycle);
  if (!cycle) return;
  const job = exampleJob(cycle);
  startWork({
    ...job,
    contour: job.contour.map((row) => (row.id === UNKNOWN.row ? { ...row, z: "?", angle: UNKNOWN.angle } : row)),
  });
  showSection("contour");
}

/** An example with a smaller infeed, compared with the example itself. */
export async function showCompared(): Promise<void> {
  const text = await exampleText("shaft");
  if (text === undefined) return;
  openText(text.replace("Q463=+2.5", "Q463=+1.5"));
  showComparison(showTextBlock, { name: "SHAFT.h", text });
}

/** The workshop drawing of an example. */
export async function showExampleDrawing(): Promise<void> {
  await openExample("shaft");
  showDrawing();
}

/** Shares an example: a short one, whose link fits a QR code. */
export async function showExampleShared(): Promise<void> {
  await openExample("shoulder");
  showShare();
}

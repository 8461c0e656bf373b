import { parse } from "../../nc/parse.ts";
import { decidingParameter } from "../../cycles/deciding-parameter.ts";
import { cuttingCycles } from "../../cycles/index.ts";
import { isRecalled } from "../../cycles/params.ts";
import { exampleJob } from "../../program/job/job.ts";
import { openText } from "../../app/fields/open/open-program.ts";
import { chooseOpenBlock } from "../../app/fields/blocks/choose-block.ts";
import { openBlockWhenRead } from "../../app/fields/blocks/session.ts";
import { showTextBlock } from "../../app/fields/blocks/show-text-block.ts";
import { showComparison, showDrawing, showGuide, showSection, showShare } from "../../app/place/place.ts";
import { startWork } from "../../app/records/keep.ts";
import { exampleText, openExample } from "./open-example.ts";

/** The cycle that features are shown with: the first with a verified parameter list. */
const shownCycle = () => cuttingCycles.find((cycle) => !isRecalled(cycle));

/** The parameter of a cycle that decides most, with three values side by side. */
export function showValues(): void {
  const cycle = shownCycle();
  const q = cycle && decidingParameter(cycle.params, { run: "rough" });
  if (cycle && q) showGuide("guide", String(cycle.number), q);
}

/** The steps of a cycle. */
export function showSteps(): void {
  const cycle = shownCycle();
  if (cycle) showGuide("guide", String(cycle.number));
}

/** The point of the example contour that is given by an angle instead of its Z. */
const UNKNOWN = { row: "e4", angle: "200.556" };

/** A cycle with a contour of which one dimension is calculated. */
export function showUnknowns(): void {
  const cycle = cuttingCycles.find(({ contour }) => contour === "free");
  if (!cycle) return;
  const job = exampleJob(cycle);
  void startWork({
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

/** The first approach of the milled example, in its dialog. */
export async function showApproach(): Promise<void> {
  const text = await exampleText("plate");
  if (text === undefined) return;
  const first = parse(text).blocks.findIndex(({ statement }) => statement.kind === "approach");
  openText(text);
  openBlockWhenRead(first, () => {
    chooseOpenBlock();
    showSection("block");
  });
}

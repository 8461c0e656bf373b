import { ncLabels } from "../src/i18n/nc-labels.ts";
import { printJob } from "../src/program/job/print-job.ts";
import { printedExample } from "./long-contour.ts";

/** One block in this many is a cycle definition; the others are lines, as in programs of that length. */
const BETWEEN_CYCLES = 200;

/** A program of `blocks` numbered blocks: lines and cycle definitions. */
export function longProgram(blocks: number): string {
  const printed = printJob(printedExample(812), ncLabels("en"));
  const cycle = /CYCL DEF 812[\s\S]*?(?=\r?\n\d+ L )/.exec(printed)?.[0] ?? "CYCL CALL";
  const line = (i: number) =>
    i % BETWEEN_CYCLES === 0
      ? `${i} ${cycle}`
      : `${i} L X+${(50 + (i % 97) * 0.123).toFixed(3)} Z-${(i * 0.011).toFixed(3)}${i % 7 === 0 ? " F0.2" : ""}`;
  const inner = Array.from({ length: blocks - 2 }, (_, i) => line(i + 1));
  return ["0 BEGIN PGM LONG MM", ...inner, `${blocks - 1} END PGM LONG MM`, ""].join("\n");
}

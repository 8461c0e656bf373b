import type { CycleNumber } from "../../../cycles/index.ts";
import { cycleByNumber } from "../../../cycles/index.ts";
import { isUnsimulated } from "../../../cycles/unsimulated-cycles.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import type { Texts } from "../../../i18n/index.ts";
import { NO_AREA } from "../../findings/effect/effect.ts";
import type { Done } from "./program-parts.ts";
import type { OperationRow } from "./operation-rows.ts";
import { durationText } from "../../base/clock-text.ts";

/** Screen name of a cycle, without its number. */
export function cycleWords(t: Texts, cycle: number): string {
  const name = cycleByNumber(cycle)
    ? t.cycles.of[cycle as CycleNumber].name
    : isUnsimulated(cycle)
      ? t.cycles.kept[cycle]
      : "";
  return `${cycle} ${name}`.trim();
}

/** Title of an operation: its structure item, its cycle, or cutting without a cycle. */
export const titleOf = (t: Texts, { title, cycles }: Pick<OperationRow, "title" | "cycles">): string =>
  title ?? (cycles.length > 0 ? cycles.map((cycle) => cycleWords(t, cycle)).join(" · ") : t.operations.withoutCycle);

/** Passes, time and residual material in one line. */
export function doneWords(t: Texts, lengths: Lengths, { passes, seconds, residue }: Done): string {
  const time = durationText(t.page.effect.duration, lengths.language, seconds);
  if (passes === 0) return time;
  return t.editor.operation(
    t.editor.passes(passes),
    time,
    residue < NO_AREA ? t.editor.noResidue : lengths.words(t.editor.residue(lengths.area(residue, 2))),
  );
}

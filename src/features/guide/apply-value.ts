import { cycleByNumber } from "../../cycles/index.ts";
import { SPINDLE } from "../../report/advice/advise.ts";
import { setPrompt, setSpindle } from "../../app/document/edits.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import { retryImport } from "../../app/base/parts.ts";
import { closeStep } from "../../app/document/steps.ts";
import { changeJob, useEditor } from "../../app/document/store.ts";
import type { SizedWord } from "./form-values.ts";
import { type OpenCall, useOpenCall } from "../../app/place/open-call.ts";
import { withSetupValue, type SetupPageId } from "./setup-variants.ts";
import { applyAndReport } from "./applied-value.ts";

/** The cycle block of the open program that a value goes into; null if no block of this cycle was open. */
const openCallOf = (cycle: number, work: string | null, call: OpenCall | null): OpenCall | null =>
  call?.cycle === cycle && call.work === work ? call : null;

/** Writes a value into the open job, or into the open block of a program, as a separate step of undo. */
export async function applyValue(cycle: number, at: string, value: number | "auto"): Promise<void> {
  const { job, work } = useEditor.getState();
  const text = value === "auto" ? "FAUTO" : String(value);
  const shown = value === "auto" ? text : value;
  if (job) {
    closeStep();
    applyAndReport(at === SPINDLE ? "VC" : at, shown, () =>
      at === SPINDLE ? setSpindle("cuttingSpeed", text) : setPrompt(at, text),
    );
    return closeStep();
  }
  const call = openCallOf(cycle, work, useOpenCall.getState().call);
  if (!call) return;
  const { writeIntoCall } = await retryImport(() => import("../../app/fields/blocks/write-into-call.ts"));
  if (useEditor.getState().work === work) applyAndReport(at, shown, () => writeIntoCall(call, at, text));
}

/**
 * Writes a value into a place of the open job's set-up, as a separate step of undo. `letter` and `shown`: the text of
 * that step.
 */
export function applySetupValue(id: SetupPageId, value: number, letter: string, shown: number | string): void {
  closeStep();
  applyAndReport(letter, shown, () => changeJob((job) => withSetupValue(job, id, value)));
  closeStep();
}

/** Whether a place accepts a value: it is a prompt of the open job, or of the open block. */
export function useCanApply(cycle: number): (at: string) => boolean {
  const job = useEditor((s) => s.job?.cycle);
  const work = useEditor((s) => (s.program ? s.work : null));
  const call = useOpenCall((s) => s.call);
  const params = cycleByNumber(cycle)?.params ?? {};
  return (at) =>
    job === cycle
      ? at === SPINDLE || at in params
      : work !== null && at in params && openCallOf(cycle, work, call) !== null;
}

/**
 * Writes a size, mm or degrees, into the APPR or DEP block of a line whose prompts were open, as a separate step of
 * undo.
 */
export async function applyToApproach(line: number, word: SizedWord, size: number): Promise<void> {
  const { work } = useEditor.getState();
  const { writeIntoApproach } = await retryImport(() => import("../../app/fields/blocks/write-into-approach.ts"));
  if (useEditor.getState().work === work) applyAndReport(word, size, () => writeIntoApproach(line, word, size));
}

/**
 * Writes a text into a word of the block of a line whose form was open, as a separate step of undo. `letter`: the name
 * of the word in that step.
 */
export async function applyToBlock(
  line: number,
  kind: BlockKind,
  word: string,
  text: string,
  letter: string,
): Promise<void> {
  const { work } = useEditor.getState();
  const { writeIntoBlock } = await retryImport(() => import("../../app/fields/blocks/write-into-block.ts"));
  if (useEditor.getState().work === work) applyAndReport(letter, text, () => writeIntoBlock(line, kind, word, text));
}

import { cycleByNumber } from "../../cycles/index.ts";
import { SPINDLE } from "../../report/advice/advise.ts";
import { setPrompt, setSpindle } from "../../app/document/edits.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import { untilHere } from "../../app/base/parts.ts";
import { closeStep } from "../../app/document/steps.ts";
import { edit, useEditor } from "../../app/document/store.ts";
import type { SizedWord } from "./form-values.ts";
import { type OpenCall, useOpenCall } from "../../app/place/open-call.ts";
import { withSetupValue, type SetupPageId } from "./setup-variants.ts";
import { takeOver } from "./taken.ts";

/** The cycle block of the open program that a value goes into; null if no block of this cycle was open. */
const openCallOf = (cycle: number, work: string | null, call: OpenCall | null): OpenCall | null =>
  call?.cycle === cycle && call.work === work ? call : null;

/** Writes a value into the open job, or into the open block of a program, as a separate step of undo. */
export async function takeValue(cycle: number, at: string, value: number | "auto"): Promise<void> {
  const { job, work } = useEditor.getState();
  const text = value === "auto" ? "FAUTO" : String(value);
  const shown = value === "auto" ? text : value;
  if (job) {
    closeStep();
    takeOver(at === SPINDLE ? "VC" : at, shown, () =>
      at === SPINDLE ? setSpindle("cuttingSpeed", text) : setPrompt(at, text),
    );
    return closeStep();
  }
  const call = openCallOf(cycle, work, useOpenCall.getState().call);
  if (!call) return;
  const { takeIntoCall } = await untilHere(() => import("../../app/fields/blocks/take-into-call.ts"));
  if (useEditor.getState().work === work) takeOver(at, shown, () => takeIntoCall(call, at, text));
}

/**
 * Writes a value into a place of the open job's set-up, as a separate step of undo. `letter` and `shown`: the text of
 * that step.
 */
export function takeSetup(id: SetupPageId, value: number, letter: string, shown: number | string): void {
  closeStep();
  takeOver(letter, shown, () => edit((job) => withSetupValue(job, id, value)));
  closeStep();
}

/** Whether a place accepts a value: it is a prompt of the open job, or of the open block. */
export function useTaking(cycle: number): (at: string) => boolean {
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
export async function takeIntoForm(line: number, word: SizedWord, size: number): Promise<void> {
  const { work } = useEditor.getState();
  const { writeIntoForm } = await untilHere(() => import("../../app/fields/blocks/take-into-form.ts"));
  if (useEditor.getState().work === work) takeOver(word, size, () => writeIntoForm(line, word, size));
}

/**
 * Writes a text into a word of the block of a line whose form was open, as a separate step of undo. `letter`: the name
 * of the word in that step.
 */
export async function takeIntoBlock(
  line: number,
  kind: BlockKind,
  word: string,
  text: string,
  letter: string,
): Promise<void> {
  const { work } = useEditor.getState();
  const { writeIntoBlock } = await untilHere(() => import("../../app/fields/blocks/take-into-block.ts"));
  if (useEditor.getState().work === work) takeOver(letter, text, () => writeIntoBlock(line, kind, word, text));
}

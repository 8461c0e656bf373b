import type { Cycle } from "../../cycles/define.ts";
import type { Kind, Param } from "../../cycles/params.ts";
import { knownParameters } from "../../program/job-parameters.ts";
import { readText } from "../../program/field.ts";
import { fieldOf } from "../../program/read-draft.ts";
import { valueText } from "../../program/typed-value.ts";
import { draftOf, setPrompt } from "../edits.ts";
import { openPrompt, usePlace } from "../place.ts";
import { promptedJob } from "../prompted.ts";
import { closeStep } from "../store.ts";
import { cycleByNumber } from "../../cycles/index.ts";

/** The Q numbers of a cycle in the order of its prompts. */
export const promptsOf = (cycle: Cycle): readonly string[] => Object.keys(cycle.params);

/** The open cycle; null on the start page. */
export const openCycle = (): Cycle | null => {
  const job = promptedJob();
  return (job && cycleByNumber(job.cycle)) ?? null;
};

const typed = (q: string): string => {
  const job = promptedJob();
  return (job && draftOf(job)[q]) ?? "";
};

/** The open prompt is left: a sum becomes its value (one with a Q parameter once that has a value), a Q parameter stays, and what is typed next is a new step of undo. */
export function commit(): void {
  const cycle = openCycle();
  const { prompt } = usePlace.getState();
  const param = prompt === null ? undefined : cycle?.params[prompt];
  if (cycle && prompt !== null && param) {
    const text = typed(prompt);
    const job = promptedJob();
    const known = job ? knownParameters(job) : {};
    const { value, written, computed } = readText(fieldOf(prompt, param), text, known);
    const tidy = computed && value !== null ? String(value)
      : written === "auto" ? "FAUTO"
      : typeof written === "object" && written !== null && value !== null ? valueText(written)
      : text.trim();
    if (tidy !== text) setPrompt(prompt, tidy);
  }
  closeStep();
}

/** Opens a prompt after leaving the one before it. */
export function goTo(q: string | null): void {
  commit();
  openPrompt(q, q === null ? "" : typed(q));
}

/** The prompt `by` places further on; past the last one the dialog is at its end, before the first it stays. */
export function step(by: number): void {
  const cycle = openCycle();
  if (!cycle) return;
  const all = promptsOf(cycle);
  const at = all.indexOf(usePlace.getState().prompt ?? "");
  const next = at < 0 ? (by > 0 ? 0 : all.length - 1) : at + by;
  if (next < 0) return;
  goTo(all[next] ?? null);
}

/** NO ENT: the prompt is left out, where it may be. */
export function noEntry(): void {
  const { prompt } = usePlace.getState();
  if (prompt === null || !openCycle()?.params[prompt]?.optional) return;
  closeStep();
  setPrompt(prompt, "");
  step(1);
}

/** END: the rest stays as it is. */
export const finish = (): void => goTo(null);

/** Escape: the value as it was when the prompt opened. */
export function cancel(): void {
  const { prompt, before } = usePlace.getState();
  if (prompt === null) return;
  closeStep();
  setPrompt(prompt, before);
  openPrompt(prompt, before);
}

export type UnitName = "diameter" | "radius" | "axial" | "degrees" | "perRevolution" | "perMinute" | "none";

const units: Readonly<Record<Exclude<Kind, "feed">, UnitName>> = {
  choice: "none", diameter: "diameter", oversizeDiameter: "diameter", radial: "radius",
  axial: "axial", axialDepth: "axial", length: "axial", angle: "degrees",
};

/** What the value of a parameter is measured in. */
export const unitOf = (param: Param, perRevolution: boolean): UnitName =>
  param.kind === "feed" ? (perRevolution ? "perRevolution" : "perMinute") : units[param.kind];

/** True where the evidence asks for a mark beside the value. */
export const unconfirmed = (evidence: Param["evidence"]): boolean => evidence !== "A";

import type { Operation } from "../../../program/state/run-types.ts";
import { shownOtherFile, useShownOtherFile } from "../../document/shown-file.ts";
import { isDefinedIn } from "../../document/shown-findings.ts";
import { useEditor } from "../../document/store.ts";
import { useOpenCall } from "../../place/open-call.ts";

type Placed = Pick<Operation, "cycle" | "definedLine" | "definedFile">;

/**
 * Whether a cycle's guide refers to a call: to one of the open block if that is this cycle, else to any. The first
 * match counts.
 */
export function isGuidedCall(cycle: number): (each: Placed) => boolean {
  const { call } = useOpenCall.getState();
  const file = shownOtherFile()?.name ?? null;
  if (call?.cycle !== cycle || call.work !== useEditor.getState().work) return (each) => each.cycle === cycle;
  return (each) => each.cycle === cycle && each.definedLine === call.line && isDefinedIn(each, file);
}

/** The same as a hook. */
export function useIsGuidedCall(cycle: number): (each: Placed) => boolean {
  useOpenCall();
  useShownOtherFile();
  return isGuidedCall(cycle);
}

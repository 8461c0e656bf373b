import type { Operation } from "../../../program/state/run-types.ts";
import { shownBeside, useShownBeside } from "../../document/shown-file.ts";
import { isDefinedIn } from "../../document/shown-findings.ts";
import { useEditor } from "../../document/store.ts";
import { useOpenCall } from "../../place/open-call.ts";

type Placed = Pick<Operation, "cycle" | "definedLine" | "definedFile">;

/**
 * Whether the guide of a cycle speaks of a call: of those of the open block where it is such a cycle, else of any, the
 * first counts.
 */
export function speaksOf(cycle: number): (each: Placed) => boolean {
  const { call } = useOpenCall.getState();
  const file = shownBeside()?.name ?? null;
  if (call?.cycle !== cycle || call.work !== useEditor.getState().work) return (each) => each.cycle === cycle;
  return (each) => each.cycle === cycle && each.definedLine === call.line && isDefinedIn(each, file);
}

/** The same, followed by a component. */
export function useSpeaksOf(cycle: number): (each: Placed) => boolean {
  useOpenCall();
  useShownBeside();
  return speaksOf(cycle);
}

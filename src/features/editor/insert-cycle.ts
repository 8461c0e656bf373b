import { cycleByNumber } from "../../cycles/index.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { inserted } from "../../app/fields/blocks/block-edits.ts";
import { editProgram, useSession } from "../../app/fields/blocks/session.ts";
import { enterSection } from "../../app/place/place.ts";
import { cycleStatement } from "./palette.ts";

/** Inserts a cycle with the values of its example behind the open block, and opens its dialog. */
export function insertCycle(number: number): void {
  const cycle = cycleByNumber(number);
  if (!cycle) return;
  const {
    reading: { program },
    index,
  } = useSession.getState();
  editProgram(inserted(program, index + 1, cycleStatement(cycle, useSettings.getState().language)), null, index + 1);
  enterSection("block");
}

import { cycleByNumber } from "../../cycles/index.ts";
import { askedByMove } from "../../cycles/asked-by-move.ts";
import { startLines } from "../../nc/program.ts";
import { definitionOf } from "../../program/path-index.ts";
import type { Run } from "../../program/run-types.ts";
import { shownBlock } from "../approach/shown-view.ts";
import { showFile } from "../files/shown-file.ts";
import { openBlock, readWhole, useSession } from "./session.ts";

/** Opens the block whose dialog makes a move: the definition of its cycle, at the value that decides most about it; else its own block. */
export function openMaker(run: Run, step: number): void {
  const { operation = null, move } = run.steps[step] ?? {};
  const made = operation === null ? undefined : run.operations[operation];
  const place = definitionOf(run, step);
  showFile(place?.file ?? null);
  if (!place) {
    const index = shownBlock(run, step);
    return index === null ? undefined : openBlock(index);
  }
  readWhole();
  const params = made && cycleByNumber(made.cycle)?.params;
  const index = startLines(useSession.getState().reading.program).lastIndexOf(place.line);
  if (index >= 0) openBlock(index, params && move ? askedByMove(params, move) : null);
}

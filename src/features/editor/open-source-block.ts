import { cycleByNumber } from "../../cycles/index.ts";
import { decidingParameter } from "../../cycles/deciding-parameter.ts";
import { blockNumbers, startLines } from "../../nc/program.ts";
import { definitionOf } from "../../program/run/path-index.ts";
import type { Run } from "../../program/state/run-types.ts";
import { shownBlock, showsPlane, useAskedView } from "../../app/pictures/plane/shown-view.ts";
import { showFile } from "../../app/document/shown-file.ts";
import { openBlock, readWhole, useSession } from "../../app/fields/blocks/session.ts";

/** Opens the block of the program that makes a step; for a step of a called program, the calling block. */
function openMoveBlock(run: Run, step: number): void {
  showFile(null);
  readWhole();
  const { program } = useSession.getState().reading,
    index = shownBlock(run, step);
  if (index === null) return;
  openBlock(index < program.blocks.length ? index : blockNumbers(program).indexOf(run.plane[step]?.block ?? -1));
}

/**
 * Opens the block whose dialog determines a move: the definition of its cycle, at the value with the greatest
 * influence; else the block itself.
 */
export function openSourceBlock(run: Run, step: number): void {
  if (showsPlane(run, useAskedView.getState().asked)) return openMoveBlock(run, step);
  const { operation = null, move } = run.steps[step] ?? {};
  const made = operation === null ? undefined : run.operations[operation];
  const place = definitionOf(run, step);
  showFile(place?.file ?? null);
  if (!place) return openMoveBlock(run, step);
  readWhole();
  const params = made && cycleByNumber(made.cycle)?.params;
  const index = startLines(useSession.getState().reading.program).lastIndexOf(place.line);
  if (index >= 0) openBlock(index, params && move ? decidingParameter(params, move) : null);
}

import { useMemo } from "react";
import { INCH } from "../../../kernel/units.ts";
import { startLines, type Program } from "../../../nc/program.ts";
import type { Run } from "../../../program/state/run-types.ts";
import { datumAt, datumIndex } from "../../../view/datum.ts";
import type { BlockUnits } from "../../../view/measure/distance.ts";
import { useShownOtherFile } from "../../document/shown-file.ts";
import { countsInches } from "../../../program/edits/program-unit.ts";
import { useSession } from "./session.ts";

/** Unit and datum of a cycle block: the unit of its program, and the datum active at its first call. */
export function countingOf(program: Program, index: number, run: Run | null, file: string | null): BlockUnits {
  const line = startLines(program)[index];
  const call = run?.operations.find(
    ({ definedLine, definedFile }) => definedLine === line && (definedFile ?? null) === file,
  );
  const datums = run?.datums ?? [];
  return {
    unit: countsInches(program) ? INCH : 1,
    zero: datumAt(datums, call ? datumIndex(datums, call.firstStep) : -1),
  };
}

/** Unit and datum of the open block, as a hook. */
export function useBlockCounting(run: Run | null): BlockUnits {
  const program = useSession((s) => s.reading.program),
    index = useSession((s) => s.index),
    file = useShownOtherFile();
  return useMemo(() => countingOf(program, index, run, file), [program, index, run, file]);
}

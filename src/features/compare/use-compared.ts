import { useEffect, useState } from "react";
import { outcomeOfOther } from "../../app/calculation/other-outcome.ts";
import { isMadeFrom, useOutcome, type Outcome } from "../../app/calculation/outcome.ts";
import { useEditor } from "../../app/document/store.ts";
import type { ProgramWork } from "../../app/document/work.ts";
import { comparedFiles, consequencesOf, type ComparedFile, type Consequences } from "./compared.ts";
import { untilGone } from "../../app/base/until-gone.ts";

/** Two programs with their names, the earlier or other one first. */
export interface Sides {
  readonly before: ProgramWork;
  readonly after: ProgramWork;
}

/** The state and the results of a comparison. */
export interface ComparedPrograms {
  readonly files: readonly ComparedFile[];
  /** Null while both are calculated, or if one calculation failed. */
  readonly consequences: Consequences | null;
  readonly state: "calculating" | "done" | "failed";
}

/** The newest result, if it belongs to this program: saves a second calculation. */
function cachedOutcome(program: ProgramWork): Outcome | null {
  const { newest } = useOutcome.getState();
  if (!newest) return null;
  const { program: open } = useEditor.getState();
  return (open === program ? isMadeFrom(newest, program) : newest.text === program.text && !newest.files)
    ? newest
    : null;
}

/** Compares two programs: first the blocks, then the effects. Null before the blocks are compared. */
export function useProgramComparison(sides: Sides | null): ComparedPrograms | null {
  const [compared, set] = useState<{ readonly of: Sides; readonly made: ComparedPrograms } | null>(null);
  useEffect(() => {
    if (!sides) return undefined;
    // Deferred, so that "calculating" is painted before a long program blocks the page.
    return untilGone(async (isGone) => {
      const files = comparedFiles(sides.before, sides.after);
      set({ of: sides, made: { files, consequences: null, state: "calculating" } });
      const before = await outcomeOfOther(sides.before);
      if (isGone()) return;
      const after = cachedOutcome(sides.after) ?? (await outcomeOfOther(sides.after));
      if (isGone()) return;
      const consequences = before && after && consequencesOf(files, before, after);
      set({ of: sides, made: { files, consequences, state: consequences ? "done" : "failed" } });
    }, 0);
  }, [sides]);
  return sides && compared?.of === sides ? compared.made : null;
}

import { useEffect, useRef, useState } from "react";
import type { Tool } from "../../kernel/plan/tool.ts";
import type { ToolFit } from "../../program/tools/which-tool.ts";
import type { SetJob } from "../../program/job/job.ts";
import { CALCULATING } from "../base/waits.ts";
import { useEditor } from "../document/store.ts";
import { fitsOf, fitsOfCall, fitsOfWork } from "./tool-questions.ts";
import { useOutcome } from "./outcome.ts";
import { takeAnswer } from "../base/until-gone.ts";

/** What each tool can do on the open contour; null until it is known. Calculated only while it is shown. */
export function useFits(): readonly ToolFit[] | null {
  const newest = useOutcome((s) => s.newest);
  const [fits, setFits] = useState<readonly ToolFit[] | null>(null);
  useEffect(() => {
    const { job } = useEditor.getState();
    if (!newest || !job) return undefined;
    return takeAnswer(() => fitsOf(job, newest), setFits, CALCULATING.otherTools);
  }, [newest]);
  return fits;
}

/** A debounced request for the fit of all tools; null until it is answered. */
function useDebouncedFits(
  ask: (() => Promise<readonly ToolFit[] | null>) | null,
  of: unknown,
): readonly ToolFit[] | null {
  const [fits, setFits] = useState<{ readonly of: unknown; readonly fits: readonly ToolFit[] | null }>({
    of: null,
    fits: null,
  });
  const asked = useRef(ask);
  useEffect(() => {
    asked.current = ask;
  });
  useEffect(
    () =>
      takeAnswer(
        async () => await (asked.current?.() ?? null),
        (found) => setFits({ of, fits: found }),
        CALCULATING.otherTools,
      ),
    [of],
  );
  return fits.of === of ? fits.fits : null;
}

/**
 * What each tool can do in place of the one whose cycle is defined in this line of the program; null if that was not
 * run.
 */
export function useFitsOfLine(line: number | null): readonly ToolFit[] | null {
  const operation = useOutcome((s) =>
    s.newest?.run.operations.find(({ definedLine, definedFile }) => definedLine === line && !definedFile),
  );
  return useDebouncedFits(operation ? () => fitsOfCall(operation) : null, operation);
}

/** What each tool, by default of the table, can do with the values of a work that is not open. */
export const useFitsOfWork = (job: SetJob | null, tools?: readonly Tool[]): readonly ToolFit[] | null =>
  useDebouncedFits(job ? () => fitsOfWork(job, tools) : null, job);

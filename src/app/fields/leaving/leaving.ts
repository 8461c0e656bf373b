import { create } from "zustand";
import { isMadeFrom, useOutcome } from "../../calculation/outcome.ts";
import { isError, isToDo, type FindingEntry } from "../../findings/entry.ts";
import { presentFindings } from "../../findings/use-findings.ts";
import type { ShownVerdict } from "../../findings/verdict.ts";
import { readJob } from "../../document/reading.ts";
import { useEditor } from "../../document/store.ts";

/** The ways in which a program leaves the page. */
export type Way = "copy" | "save" | "download" | "share";

/** The question that stands before a program with faults leaves. */
export interface Asking {
  readonly way: Way;
  readonly verdict: ShownVerdict;
  /** What is wrong, worst first. */
  readonly faults: readonly FindingEntry[];
  /** No result for this very text came in time. */
  readonly unchecked: boolean;
  readonly answer: (go: boolean) => void;
}

export const useLeaving = create<{ readonly asking: Asking | null }>(() => ({ asking: null }));

/**
 * How long a program that is still being calculated is waited for, ms: browsers forget soon that a button was pressed.
 */
const PATIENCE = 3000;

/** Resolves when the result for a text is there; false when it does not come in time, or can not come at all. */
function calculated(text: string): Promise<boolean> {
  const { job, program } = useEditor.getState();
  const isThere = () => {
    const { newest } = useOutcome.getState();
    return newest !== null && (program ? isMadeFrom(newest, program) : newest.text === text);
  };
  if (isThere() || (job && !readJob(job)?.reading.values)) return Promise.resolve(isThere());
  return new Promise((resolve) => {
    const stop = useOutcome.subscribe(() => {
      if (!isThere()) return;
      end(true);
    });
    const timer = setTimeout(() => end(false), PATIENCE);
    const end = (found: boolean) => {
      stop();
      clearTimeout(timer);
      resolve(found);
    };
  });
}

/**
 * Asks before a program with faults leaves the page; resolves to the verdict that goes with it, or to null when it is
 * to stay. One that is not wholly proved may leave unasked, but the verdict is said.
 */
export async function mayLeave(way: Way, text: string): Promise<ShownVerdict | null> {
  const checked = await calculated(text);
  const { entries, verdict } = presentFindings();
  if (checked && verdict.faults === 0 && verdict.open === 0) return verdict;
  return new Promise((resolve) => {
    const answer = (go: boolean) => {
      useLeaving.setState({ asking: null });
      resolve(go ? verdict : null);
    };
    const faults = entries.filter((entry) => isError(entry) && !isToDo(entry));
    useLeaving.setState({ asking: { way, verdict, faults, unchecked: !checked && verdict.open === 0, answer } });
  });
}

import { create } from "zustand";
import { useOutcome } from "../../calculation/outcome.ts";
import { isResultOf } from "../../calculation/result-of.ts";
import { isError, isToDo, type FindingEntry } from "../../findings/entry.ts";
import { presentFindings } from "../../findings/use-findings.ts";
import type { ShownVerdict } from "../../findings/verdict.ts";
import { openReading } from "../../document/reading.ts";
import { flushEdits, openContent } from "../../document/store.ts";

/** Ways to export a program. */
export type ExportWay = "copy" | "save" | "download" | "share";

/** The question before a program with faults is exported. */
export interface ExportRequest {
  readonly way: ExportWay;
  readonly verdict: ShownVerdict;
  /** What is wrong, worst first. */
  readonly faults: readonly FindingEntry[];
  /** No result for this text came in time. */
  readonly unchecked: boolean;
  readonly answer: (go: boolean) => void;
}

export const useExportRequest = create<{ readonly asking: ExportRequest | null }>(() => ({ asking: null }));

/** Longest wait for a running calculation, ms. Browsers soon forget the click that copying needs. */
const PATIENCE = 3000;

/** Resolves to true when the result for the open work is there, to false when it is late or impossible. */
function waitForResult(): Promise<boolean> {
  flushEdits();
  const content = openContent();
  const isThere = () => {
    const { newest } = useOutcome.getState();
    return newest !== null && content !== null && isResultOf(newest, content);
  };
  const isIncomplete = openReading()?.reading.values === null;
  if (isThere() || isIncomplete) return Promise.resolve(isThere());
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
 * Asks before the open work is exported with faults; resolves to its verdict, or to null if cancelled. A program that
 * is only partly verified is exported without asking, but its verdict is shown.
 */
export async function confirmExport(way: ExportWay): Promise<ShownVerdict | null> {
  const checked = await waitForResult();
  const { entries, verdict } = presentFindings();
  if (checked && verdict.faults === 0 && verdict.open === 0) return verdict;
  return new Promise((resolve) => {
    const answer = (go: boolean) => {
      useExportRequest.setState({ asking: null });
      resolve(go ? verdict : null);
    };
    const faults = entries.filter((entry) => isError(entry) && !isToDo(entry));
    useExportRequest.setState({ asking: { way, verdict, faults, unchecked: !checked && verdict.open === 0, answer } });
  });
}

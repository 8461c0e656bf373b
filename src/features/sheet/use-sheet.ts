import { useMemo } from "react";
import { parse } from "../../nc/parse.ts";
import type { Program } from "../../nc/program.ts";
import type { Control } from "../../program/tools/plane-types.ts";
import { setupData, type SetupData } from "../../report/sheet/setup-data.ts";
import { useOutcome, type Outcome } from "../../app/calculation/outcome.ts";
import { isResultOf } from "../../app/calculation/result-of.ts";
import { fileOfWork, textOf } from "../../app/document/printed.ts";
import { useIsoFile } from "../../app/document/output.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { bundleOf, openContent, useEditor } from "../../app/document/store.ts";
import { toolsOnDevice, useTools } from "../../app/document/tool-store.ts";

/** Inputs of the sheet. */
export interface SheetSource {
  readonly program: Program;
  readonly data: SetupData;
  /** The result of exactly this text; null while pending. */
  readonly outcome: Outcome | null;
  /** The control it is calculated for. */
  readonly control: Control;
  /** Name of the program's file. */
  readonly file: string;
  /** The text of the file if it is DIN/ISO; null for Klartext, as in `program`. */
  readonly iso: string | null;
  readonly remarks: string;
}

/** Inputs of the sheet for the open work; null if none is open. */
export function useSheetSource(): SheetSource | null {
  const job = useEditor((s) => s.job);
  const work = useEditor(openContent);
  const newest = useOutcome((s) => s.newest);
  const shop = useTools((s) => s.list);
  const own = useEditor(bundleOf);
  const iso = useIsoFile(job);
  const settings = useSettings((s) => s.control);
  const { table } = toolsOnDevice(own.tools ?? shop);
  const text = work && textOf(work);
  const isOwn = newest !== null && !newest.isBeginning && work !== null && isResultOf(newest, work);
  const outcome = isOwn ? newest : null;
  const program = useMemo(() => (text === null ? null : parse(text)), [text]);
  const data = useMemo(
    () => program && setupData({ program, run: outcome?.run ?? null, tools: table.tools, mills: table.mills ?? [] }),
    [program, outcome, table],
  );
  if (!work || !program || !data) return null;
  return {
    program,
    data,
    outcome,
    control: own.control ?? settings,
    file: fileOfWork(work),
    iso: iso?.text ?? null,
    remarks: work.remarks ?? "",
  };
}

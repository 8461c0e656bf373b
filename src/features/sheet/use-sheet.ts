import { useMemo } from "react";
import { parse } from "../../nc/parse.ts";
import type { Program } from "../../nc/program.ts";
import type { Control } from "../../program/tools/plane-types.ts";
import { setupData, type SetupData } from "../../report/sheet/setup-data.ts";
import { isMadeFrom, useOutcome, type Outcome } from "../../app/calculation/outcome.ts";
import { fileOfJob, printedText } from "../../app/document/printed.ts";
import { useIsoFile } from "../../app/document/output.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { handedOn, useEditor } from "../../app/document/store.ts";
import { toolsOnDevice, useTools } from "../../app/document/tool-store.ts";

/** What the sheet is made of. */
export interface SheetSource {
  readonly program: Program;
  readonly data: SetupData;
  /** The result of this very text; null while there is none. */
  readonly outcome: Outcome | null;
  /** The control setting that it is calculated for. */
  readonly control: Control;
  /** Name of the program's file. */
  readonly file: string;
  /** The text of the file where it is DIN/ISO; null where it is Klartext, as in `program`. */
  readonly iso: string | null;
  readonly remarks: string;
}

/** The open work as its sheet needs it; null where nothing is open. */
export function useSheetSource(): SheetSource | null {
  const job = useEditor((s) => s.job);
  const work = useEditor((s) => s.program);
  const newest = useOutcome((s) => s.newest);
  const shop = useTools((s) => s.list);
  const own = useEditor(handedOn);
  const iso = useIsoFile(job);
  const settings = useSettings((s) => s.control);
  const { table } = toolsOnDevice(own.tools ?? shop);
  const text = job ? printedText(job) : (work?.text ?? null);
  const isOwn = newest !== null && !newest.isBeginning && (work ? isMadeFrom(newest, work) : newest.text === text);
  const outcome = isOwn ? newest : null;
  const program = useMemo(() => (text === null ? null : parse(text)), [text]);
  const data = useMemo(
    () => program && setupData({ program, run: outcome?.run ?? null, tools: table.tools, mills: table.mills ?? [] }),
    [program, outcome, table],
  );
  if (text === null || !program || !data) return null;
  return {
    program,
    data,
    outcome,
    control: own.control ?? settings,
    file: job ? fileOfJob(job) : (work?.name ?? ""),
    iso: iso?.text ?? null,
    remarks: (job ?? work)?.remarks ?? "",
  };
}

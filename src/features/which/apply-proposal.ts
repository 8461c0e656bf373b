import type { ShapeRequest } from "../../cycles/shape-request.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import { ncLanguageOf, type Language } from "../../i18n/languages.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { withOperation } from "../../program/edits/added-operation.ts";
import { operationsOf } from "../../program/edits/operations.ts";
import { requestedText } from "../../program/job/requested-text.ts";
import type { Proposal } from "../../report/which/ways.ts";
import { openText } from "../../app/fields/open/open-program.ts";
import { openPrompt } from "../../app/place/place.ts";
import { printedText } from "../../app/document/printed.ts";
import { startWork } from "../../app/records/keep.ts";
import { outputInUse } from "../../app/document/output.ts";
import { useEditor } from "../../app/document/store.ts";

/** Applies a proposal: after the operations of the open program, or as a new work. */
export async function applyProposal(
  { job }: Proposal,
  wanted: ShapeRequest,
  {
    language,
    adds,
    behind,
  }: { readonly language: Language; readonly adds: boolean; readonly behind?: number | null | undefined },
): Promise<void> {
  const { job: open, program } = useEditor.getState();
  const ncLanguage = ncLanguageOf(language),
    labels = ncLabels(ncLanguage);
  const made = { ...job, ncLanguage, output: outputInUse() };
  if (adds && (program || open)) {
    const [session, { showFile }, { openingBlock }, { openFirstOpenPrompt }] = await Promise.all([
      import("../../app/fields/blocks/session.ts"),
      import("../../app/document/shown-file.ts"),
      import("../../app/fields/blocks/operation-rows.ts"),
      import("../../app/fields/blocks/open-block.ts"),
    ]);
    const layout = open ? { layout: open.layout } : {};
    const before = parse(open ? printedText(open) : (session.sessionText() ?? program?.text ?? ""));
    const next = withOperation(before, { ...made, ...layout }, labels, behind === undefined ? {} : { behind });
    const unit = behind === undefined ? operationsOf(next).units.length - 1 : behind === null ? 0 : behind + 1;
    const index = openingBlock(next, unit);
    if (program) {
      showFile(null);
      session.editProgram(next, null, index);
      return openFirstOpenPrompt();
    }
    openText(print(next));
    if (index !== null) session.openBlockWhenRead(index, openFirstOpenPrompt);
    return;
  }
  if (wanted.allowance > 0) return openText(requestedText(made, wanted, labels));
  void startWork(made);
  const [first] = Object.keys(cycleByNumber(made.cycle)?.params ?? {});
  if (first !== undefined) openPrompt(first, made.drafts[made.cycle]?.[first] ?? "");
}

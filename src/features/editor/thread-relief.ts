import { cycleByNumber } from "../../cycles/index.ts";
import { ncLanguageOf, type Language } from "../../i18n/languages.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { print, startLines, type Program } from "../../nc/program.ts";
import { valueInProgram } from "../../program/blocks/cycle-values.ts";
import { withOperation } from "../../program/edits/added-operation.ts";
import { operationAt, operationsOf } from "../../program/edits/operations.ts";
import { countsInches } from "../../program/edits/program-unit.ts";
import { reliefsBeforeThread, type ReliefBefore } from "../../program/edits/relief-before-thread.ts";
import { reachingFirst } from "../../program/edits/undercut-operation.ts";
import { standardUndercutTools } from "../../program/iso-codes/standard-undercut-tools.ts";
import { newId, readList } from "../../program/tools/tool-list.ts";
import type { ToolEntry } from "../../program/tools/tool-entry.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";
import { fitsOfWork } from "../../app/calculation/tool-questions.ts";
import { addTool } from "../../app/document/add-tool.ts";
import { outputInUse } from "../../app/document/output.ts";
import { listInUse } from "../../app/document/work-tools.ts";
import { withPrompt } from "../../app/fields/blocks/block-prompts.ts";
import { editProgram } from "../../app/fields/blocks/session.ts";
import type { ProgramWork } from "../../app/document/work.ts";
import type { FindingEntry } from "../../app/findings/entry.ts";
import type { Trial } from "../../app/findings/host.ts";
import { numbersInScreenWriting } from "../../i18n/number.ts";
import type { FindingsTexts } from "../../i18n/en/workplace/findings.ts";
import { spindleLike, stateBefore } from "./operations/stock-before.ts";

/** The tool that makes the undercut: one of the table, else a standard one. */
async function toolFor({
  named,
  job,
}: ReliefBefore): Promise<{ readonly T: number; readonly added: ToolEntry | null } | null> {
  const best = async (tools?: Parameters<typeof fitsOfWork>[1]) => {
    const [fit] = reachingFirst((await fitsOfWork(job, tools)) ?? [], named);
    return fit?.makesContour ? fit.tool.T : null;
  };
  const own = await best();
  if (own !== null) return { T: own, added: null };
  const list = listInUse();
  const rows = standardUndercutTools(list).map((cells, i) => ({ id: `standard ${i}`, cells }));
  const T = await best(readList(rows).table.tools);
  const row = rows.find(({ cells }) => Number(cells.T) === T);
  return T === null || !row ? null : { T, added: { ...row, id: newId(list) } };
}

interface Context {
  readonly newest: Outcome;
  readonly program: Program;
  readonly work: ProgramWork;
  readonly language: Language;
  readonly t: FindingsTexts;
}

/**
 * Undercuts of DIN 76 as an operation before a thread that overruns into its shoulder, each with the end of the thread
 * as it is and in the undercut.
 */
export function reliefTrials(
  { operation: index }: FindingEntry,
  { newest, program, work, language, t }: Context,
): readonly Trial[] {
  const operation = newest.run.operations[index ?? -1];
  const cycle = operation && cycleByNumber(operation.cycle);
  const endQ = cycle && Object.keys(cycle.params).find((q) => cycle.params[q]?.text === "endZ");
  if (!cycle || endQ === undefined || operation.definedFile || newest.run.datums.length > 0) return [];
  const defined = startLines(program).indexOf(operation.definedLine);
  const unit = operationAt(program, defined) ?? -1;
  const nth = operationsOf(program).units[unit]?.definitions.indexOf(defined) ?? -1;
  if (nth < 0) return [];
  const behind = unit === 0 ? null : unit - 1;
  const { stock, operations } = stateBefore(newest, program, behind);
  const ncLanguage = ncLanguageOf(language);
  return reliefsBeforeThread(operation, stock).flatMap((relief) =>
    [null, relief.end].map((z): Trial => {
      const end = z === null ? null : String(valueInProgram(cycle.params[endQ], z, countsInches(program)));
      const { name } = relief.named;
      let made: { readonly program: Program; readonly added: ToolEntry | null } | null = null;
      return {
        // Where the contour of the part can have the undercut, that one is offered.
        group: "relief",
        name: [
          t.reliefBefore(name),
          ...(end === null ? [] : [t.endThread(numbersInScreenWriting(language, `Z${end}`))]),
        ].join(" · "),
        work: async () => {
          const tool = await toolFor(relief);
          if (!tool) return null;
          const spindle = spindleLike(relief.job.spindle, operations);
          const job = { ...relief.job, tool: tool.T, spindle, ncLanguage, output: outputInUse() };
          const ended = end === null ? program : withPrompt(program, defined, endQ, end);
          const title = name.toUpperCase().replace("×", "x");
          const next = withOperation(ended, job, ncLabels(ncLanguage), { behind, title });
          made = { program: next, added: tool.added };
          return { ...work, ...(tool.added && { tools: [...listInUse(), tool.added] }), text: print(next) };
        },
        apply: () => {
          if (!made) return;
          if (made.added) addTool(made.added);
          editProgram(made.program, null, operationsOf(made.program).units[unit + 1]?.definitions[nth] ?? null);
        },
      };
    }),
  );
}

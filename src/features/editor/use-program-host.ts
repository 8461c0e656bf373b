import { useMemo } from "react";
import { numbersInScreenWriting } from "../../i18n/number.ts";
import { writeTyped } from "../../app/fields/dialog/write-value.ts";
import { useOutcome, type Outcome } from "../../app/calculation/outcome.ts";
import { retryImport } from "../../app/base/parts.ts";
import type { FindingEntry } from "../../app/findings/entry.ts";
import type { FindingsHost, Fix } from "../../app/findings/host.ts";
import { askForFiles } from "../../app/records/files/file-handle.ts";
import { missingFile } from "../../app/calculation/missing-files.ts";
import { addFiles } from "../../app/fields/open/open-files.ts";
import { showFile, useShownOtherFile } from "../../app/document/shown-file.ts";
import { isIn, ownPlace } from "../../app/document/shown-findings.ts";
import { placeInFile } from "../../app/calculation/issue-text.ts";
import { print, type Program } from "../../nc/program.ts";
import { enterSection, openPrompt, showComparison } from "../../app/place/place.ts";
import { outputInUse } from "../../app/document/output.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { fixOf } from "./diagnostics.ts";
import { fileKey } from "../../program/state/program-files.ts";
import { useEditor } from "../../app/document/store.ts";
import { fileOf, type ProgramWork } from "../../app/document/work.ts";
import { showTextBlock } from "../../app/fields/blocks/show-text-block.ts";
import { openPrompts } from "../../app/fields/blocks/open-block.ts";
import { isUpToDate } from "../../app/fields/blocks/up-to-date.ts";
import type { Repair } from "../../app/fields/blocks/repair.ts";
import { indexOf, repairsOf, toolCallBefore, withTool } from "../../app/fields/blocks/repairs.ts";
import {
  dispatchEdit,
  editProgram,
  openBlock,
  readWhole,
  sessionView,
  useSession,
} from "../../app/fields/blocks/session.ts";

/** Decimals of offered values. */
const DECIMALS = 4;

/** The program of the shown text. */
const shownProgram = (): Program => useSession.getState().reading.program;

/** The file of a finding other than the main program; null for the main program, or a file that no longer exists. */
function fileOfEntry({ inFile }: FindingEntry): string | null {
  const { program } = useEditor.getState();
  return inFile && program && fileOf(program, fileKey(inFile.file)) ? inFile.file : null;
}

/** A finding with its position in the text of its own file. */
const inOwnText = (entry: FindingEntry): FindingEntry =>
  fileOfEntry(entry) === null ? entry : { ...entry, ...ownPlace(entry), inFile: undefined };

/** Shows the file of a finding, and returns the index of its block there. */
function showPlace(entry: FindingEntry): number {
  showFile(fileOfEntry(entry));
  readWhole();
  return indexOf(shownProgram(), inOwnText(entry));
}

/**
 * Findings of a whole program: their blocks and dialogs. A finding of a stale text offers no changes; a finding in a
 * file that is not shown first offers to open it.
 */
export function useProgramHost(): FindingsHost {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const reading = useSession((s) => s.reading);
  const newest = useOutcome((s) => s.newest);
  const beside = useShownOtherFile();
  // An exercise asks for the better way itself.
  const isExercise = useEditor((s) => s.program?.task !== undefined);
  return useMemo(() => {
    const { program } = reading;
    const isShown = (entry: FindingEntry) =>
      isIn({ inFile: fileOfEntry(entry) === null ? undefined : entry.inFile }, beside);
    const nameOf = ({ kind, text: given, block }: Repair): string => {
      const text =
        typeof given === "number" ? writeTyped(language, given, DECIMALS) : numbersInScreenWriting(language, given);
      // Blocks and words are named as the program writes them, values as the screen does.
      if (kind === "take") return t.dialog.takeNearest(text);
      if (kind === "runOut") return t.findings.runOut(text);
      if (kind === "endThread") return t.findings.endThread(text);
      if (kind === "relief")
        return text === "" ? t.findings.relief : `${t.findings.relief} · ${t.findings.endThread(text)}`;
      if (kind === "tie") return t.page.text.tie;
      if (kind === "meant") return t.findings.meant;
      if (kind === "write") return t.findings.write(String(given), block);
      return kind === "insert" ? t.findings.insert(String(given)) : t.findings.remove(String(given));
    };
    const fixWith = (repair: Repair): Fix => ({
      name: nameOf(repair),
      apply: () => {
        editProgram(repair.next(), null, repair.open);
        if (repair.asks) enterSection("block");
      },
    });
    const reliefsOf = async (entry: FindingEntry, outcome: Outcome, work: ProgramWork) => {
      const { reliefTrials } = await retryImport(() => import("./thread-relief.ts"));
      return reliefTrials(entry, { newest: outcome, program, work, language, t: t.findings });
    };
    const trialsOf: FindingsHost["trialsOf"] = (entry) => {
      const work = useEditor.getState().program;
      if (!work || !isUpToDate(newest) || beside !== null || entry.inFile) return null;
      const trials = repairsOf(program, entry, language, outputInUse()).flatMap((repair) =>
        repair.trial === undefined
          ? []
          : [{ ...fixWith(repair), group: repair.trial, work: () => ({ ...work, text: print(repair.next()) }) }],
      );
      if (newest && entry.issue.code === "threadOverruns")
        return reliefsOf(entry, newest, work).then((own) => [...trials, ...own]);
      return trials.length === 0 ? null : Promise.resolve(trials);
    };
    const open = (entry: FindingEntry) => openBlock(showPlace(entry), entry.at);
    const targetOf: FindingsHost["targetOf"] = (entry) => {
      const index = isShown(entry) ? indexOf(program, inOwnText(entry)) : null;
      if (index === -1 || (entry.block === null && entry.line === null)) return null;
      const go = () => {
        open(entry);
        enterSection("block");
        // A value that the list lacks has no line to put the cursor in.
        const asked = openPrompts();
        if (entry.at !== null && asked?.ids.includes(entry.at)) openPrompt(entry.at, asked.draft[entry.at] ?? "");
      };
      return {
        name: entry.inFile ? placeInFile(t, entry.inFile) : t.findings.inBlock(String(entry.block ?? index)),
        go,
      };
    };
    /** The name of a spelling correction: the right text. */
    const spelling = ({ issue }: FindingEntry): string | null =>
      (issue.code === "notUnderstood" || issue.code === "wordNotUnderstood") && issue.fix
        ? t.dialog.takeNearest(issue.fix.text.split(/\r?\n/)[0] ?? "")
        : null;
    const fixesOf: FindingsHost["fixesOf"] = (entry) => {
      const missing = missingFile(entry);
      if (missing !== null)
        return [
          {
            name: t.editor.files.addOne(missing),
            apply: () => void askForFiles().then((chosen) => addFiles(chosen, missing)),
          },
        ];
      const view = sessionView();
      if (!view || !isUpToDate(newest) || !isShown(entry)) return [];
      const own = inOwnText(entry);
      const repairs = repairsOf(program, own, language, outputInUse())
        .filter(({ trial }) => trial === undefined)
        .map(fixWith);
      const tool = entry.issue.code === "betterTool" && repairs.length === 0 ? entry.issue.data.tool : null;
      if (tool !== null) return [{ name: t.setup.tool.take(tool), apply: () => takeTool(entry, tool) }];
      const fix = fixOf(view.state, own);
      const name = spelling(own) ?? t.findings.fix;
      return fix ? [{ name, apply: () => dispatchEdit(fix, null) }, ...repairs] : repairs;
    };
    const takeTool: FindingsHost["takeTool"] = (entry, tool) => {
      if (!isUpToDate(newest)) return;
      let index = showPlace(entry);
      // A called program may rely on the tool of its caller.
      if (entry.inFile && toolCallBefore(shownProgram(), index) < 0) {
        showFile(null);
        index = indexOf(shownProgram(), entry);
      }
      const called = shownProgram().blocks[index]?.statement.kind === "toolCall" ? index + 1 : index;
      if (index >= 0) editProgram(withTool(shownProgram(), called, tool), null);
    };
    const cycleOf: FindingsHost["cycleOf"] = (entry) => {
      if (!isShown(entry))
        return entry.operation === null ? null : (newest?.run.operations[entry.operation]?.cycle ?? null);
      const s = program.blocks[indexOf(program, inOwnText(entry))]?.statement;
      return s?.kind === "cycle" ? s.cycle : null;
    };
    return {
      targetOf,
      fixesOf,
      trialsOf,
      cycleOf,
      point: open,
      toFirstOpen: () => undefined,
      improve: isExercise ? null : () => showComparison(showTextBlock, "better"),
      isCurrent: isUpToDate(newest),
      takeTool,
    };
  }, [t, language, reading, newest, beside, isExercise]);
}

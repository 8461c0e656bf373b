import type { EditorView } from "@codemirror/view";
import { useEffect, useMemo, type ReactNode } from "react";
import { partialWork } from "../../program/job/partial-work.ts";
import { MachineView } from "../../app/pictures/plane/MachineView.tsx";
import { clock } from "../../app/base/clock.ts";
import { cycleGivens } from "../../app/calculation/cycle-givens.ts";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { FindingsPanel } from "../../app/findings/FindingsPanel.tsx";
import { useDeferredUntilPaint } from "../../app/base/typing.ts";
import { MeasuredTargetContext } from "../../app/document/measured-target-context.ts";
import { useMeasuredTarget } from "../../app/document/measured-target.ts";
import { useInserting } from "../../app/document/inserting.ts";
import { enterSection, showSection, usePlace, type ProgramSection } from "../../app/place/place.ts";
import { playback } from "../../app/calculation/playback.ts";
import { WorkColumns } from "../../app/fields/workplace/WorkColumns.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { pendingEdits, useEditor } from "../../app/document/store.ts";
import { useToolList } from "../../app/document/work-tools.ts";
import { useThirdColumn } from "../../app/base/use-media.ts";
import { BlockPanel } from "./BlockPanel.tsx";
import { followProgram } from "./follow.ts";
import { openChosen } from "../../app/fields/blocks/choose-block.ts";
import { useBlockCounting } from "../../app/fields/blocks/block-counting.ts";
import { setBlockPrompt, useOpenBlock } from "../../app/fields/blocks/open-block.ts";
import { openSourceBlock } from "./open-source-block.ts";
import { closeSession, flushText, openSession, sessionView } from "../../app/fields/blocks/session.ts";
import { showFile } from "../../app/document/shown-file.ts";
import { lazyPart } from "../../app/base/parts.ts";
import { toggleAllFolds, toggleFold } from "../../app/fields/blocks/folding.ts";
import { useTextBar } from "../../app/fields/find/text-bar.ts";
import { useActions } from "../../app/base/actions.ts";
import { selectedText } from "./editor-text.ts";
import { StructurePanel } from "./StructurePanel.tsx";
import { TextPanel } from "./TextPanel.tsx";
import { TotalsStrip } from "./TotalsStrip.tsx";
import { useProgramHost } from "./use-program-host.ts";
import "../../app/fields/own/own-block.css";
import "./editor.css";

const InsertOperation = lazyPart(async () => ({
  default: (await import("./operations/InsertOperation.tsx")).InsertOperation,
}));

/** Keeps the editor of the open program for as long as it is open. */
function useProgramSession(): void {
  useEffect(() => {
    const { program, work } = useEditor.getState();
    if (!program || work === null) return undefined;
    // Here as well as in the lathe view: a milled program has another view.
    playback.playsOf(work);
    openSession(program, work);
    const stop = followProgram();
    pendingEdits.add(flushText);
    return () => {
      pendingEdits.delete(flushText);
      stop();
      closeSession();
      showFile(null);
    };
  }, []);
}

/** Opens the dialog of the block of a move chosen in the picture. Returns whether the dialog takes the focus. */
function openMove(step: number, byKey = false): boolean {
  const { pictured: shown } = useOutcome.getState();
  if (!shown) return false;
  openChosen(() => openSourceBlock(shown.run, step));
  (byKey ? enterSection : showSection)("block");
  return byKey;
}

const withView = (act: (view: EditorView) => void) => () => {
  const view = sessionView();
  if (view) act(view);
};

/** Blocks, lathe and text of a whole program. */
export function ProgramWorkplace() {
  const { editor: t, findings: words } = useTexts();
  const wide = useThirdColumn();
  // A request for the prompts opens the block here.
  const asked = usePlace((p) => (p.section === "prompts" ? "block" : p.section));
  const shown = useOutcome((s) => s.pictured);
  const dimmed = useOutcome((s) => s.dimmed);
  const host = useProgramHost();
  const inserting = useInserting();
  const { read } = useOpenBlock(),
    late = useDeferredUntilPaint(read),
    tools = useToolList();
  const measured = useMeasuredTarget(read, setBlockPrompt, useBlockCounting(shown?.run ?? null));
  // Blank, tool and start belong to the program: only the typed contour of the block is drawn.
  const known = useMemo(
    () =>
      late && shown?.run.datums.length === 0 && shown.run.program.unit === "mm"
        ? {
            ...partialWork(late.cycle, late.job, late.reading, cycleGivens(late), tools),
            blank: [],
            start: null,
            tool: null,
          }
        : null,
    [late, shown, tools],
  );
  useProgramSession();
  const bar = useTextBar({
    modes: ["find", "replace", "goTo"],
    show: () => {
      if (!wide) showSection("text");
    },
    selected: selectedText,
  });
  useActions([
    { id: "text.fold", run: withView(toggleFold) },
    { id: "text.foldAll", run: withView(toggleAllFolds) },
  ]);
  const possible: readonly ProgramSection[] = [...(wide ? [] : ["text" as const]), "block", "structure", "findings"];
  const open = possible.find((section) => section === asked) ?? (wide ? "structure" : "text");
  const content: Readonly<Record<ProgramSection, ReactNode>> = {
    text: <TextPanel bar={bar} toBlock={() => enterSection("block")} />,
    block: <BlockPanel />,
    structure: <StructurePanel />,
    findings: <FindingsPanel host={host} />,
  };
  return (
    <WorkColumns
      of="program"
      host={host}
      name={t.sectionsName}
      open={open}
      sections={possible.map((section) => ({
        section,
        name: section === "findings" ? words.title : t.sections[section],
        content: content[section],
      }))}
      strip={<TotalsStrip />}
      picture={
        <MeasuredTargetContext value={measured}>
          <MachineView
            result={shown}
            known={open === "block" ? known : null}
            dimmed={dimmed}
            playback={playback}
            clock={clock}
            onMove={openMove}
          />
        </MeasuredTargetContext>
      }
      text={wide ? <TextPanel bar={bar} /> : null}
    >
      {inserting && <InsertOperation behind={inserting.behind} />}
    </WorkColumns>
  );
}

import { Suspense, useState, type ReactNode } from "react";
import { flushEdits, useEditor } from "../../document/store.ts";
import type { ShownVerdict } from "../../findings/verdict.ts";
import { showComparison, type ShowBlock, showSheet } from "../../place/place.ts";
import { useActions } from "../../base/actions.ts";
import { Icon } from "../../base/Icon.tsx";
import { confirmExport } from "../leaving/confirm-export.ts";
import { lazyPart } from "../../base/parts.ts";
import { drawingSlot, exportSlot, shareSlot, exerciseSlot } from "../slots.ts";
import { printedText, programName } from "../../document/printed.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { isProgram, type Work } from "../../document/work.ts";

/** Loaded when first opened. */
const HandOnDialog = lazyPart(async () => ({ default: await shareSlot.fetch() }));
const PartExport = lazyPart(async () => ({ default: await exportSlot.fetch() }));
const TurnRound = lazyPart(async () => ({ default: (await import("./SecondSideDialog.tsx")).SecondSideDialog }));
const ProgramDrawing = lazyPart(async () => ({ default: await drawingSlot.fetch() }));
const ClampingDialog = lazyPart(async () => ({ default: (await import("./ClampingDialog.tsx")).ClampingDialog }));
const OutputDialog = lazyPart(async () => ({ default: (await import("./OutputDialog.tsx")).OutputDialog }));
const TeachDialog = lazyPart(async () => ({ default: await exerciseSlot.fetch() }));

/** A work to share, with its verdict. */
interface Leaving {
  readonly open: Work;
  readonly verdict: ShownVerdict;
}

/** The open work with its verdict; null if sharing was cancelled. */
async function leaving(): Promise<Leaving | null> {
  flushEdits();
  const { job, program } = useEditor.getState();
  const open = job ?? program;
  const verdict = open && (await confirmExport("share", isProgram(open) ? open.text : printedText(open)));
  return open && verdict && { open, verdict };
}

/** The text of what is open. */
function openText(): string {
  flushEdits();
  const { job, program } = useEditor.getState();
  if (program) return program.text;
  return job ? printedText(job) : "";
}

/** Name of the open program without extension, for files made from it. */
function openStem(): string {
  flushEdits();
  const { job, program } = useEditor.getState();
  if (program) return program.name.replace(/\.[^.]*$/, "");
  return job ? programName(printedText(job)) : "";
}

/** More actions for the open program; those of the workplace come last. */
export function ProgramMore({ showBlock, children }: { readonly showBlock: ShowBlock; readonly children?: ReactNode }) {
  const {
    page: { text: t },
  } = useTexts();
  const [handed, handOn] = useState<Leaving | null>(null);
  const [exported, exportPart] = useState<string | null>(null);
  const [turned, turnRound] = useState<string | null>(null);
  const [drawn, draw] = useState<string | null>(null);
  const [sets, setOutput] = useState(false);
  const [clamps, setClamps] = useState(false);
  const ofProgram = useEditor((s) => s.program !== null);
  const [taught, teach] = useState<{ readonly text: string; readonly work: string } | null>(null);
  const openSheet = () => {
    flushEdits();
    showSheet();
  };
  useActions([
    { id: "do.sheet", name: t.setupSheet, run: openSheet },
    { id: "do.drawing", name: t.workshopDrawing, run: () => draw(openStem()) },
    { id: "do.share", name: t.handOn, run: () => void leaving().then(handOn) },
    { id: "do.exportPart", name: t.exportPart, run: () => exportPart(openStem()) },
    { id: "do.flip", name: t.turnRound, run: () => turnRound(openText()) },
    {
      id: "do.exercise",
      name: t.makeTask,
      run: () => teach({ text: openText(), work: useEditor.getState().work ?? "" }),
    },
    ...(ofProgram ? [{ id: "do.clamping", name: t.clamping, run: () => setClamps(true) } as const] : []),
    { id: "do.compare", name: t.compare, run: () => showComparison(showBlock) },
    { id: "do.output", name: t.output, run: () => setOutput(true) },
  ]);
  return (
    <div className="program-more">
      <button type="button" className="button plain" onClick={openSheet}>
        <Icon name="print" /> {t.setupSheet}
      </button>
      <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => draw(openStem())}>
        <Icon name="drawing" /> {t.workshopDrawing}
      </button>
      {drawn !== null && (
        <Suspense>
          <ProgramDrawing stem={drawn} done={() => draw(null)} />
        </Suspense>
      )}
      <button type="button" className="button plain" onClick={() => void leaving().then(handOn)}>
        <Icon name="share" /> {t.handOn}
      </button>
      {handed && (
        <Suspense>
          <HandOnDialog {...handed} done={() => handOn(null)} />
        </Suspense>
      )}
      <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => exportPart(openStem())}>
        <Icon name="solid" /> {t.exportPart}
      </button>
      {exported !== null && (
        <Suspense>
          <PartExport stem={exported} done={() => exportPart(null)} />
        </Suspense>
      )}
      <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => turnRound(openText())}>
        <Icon name="turn" /> {t.turnRound}
      </button>
      {turned !== null && (
        <Suspense>
          <TurnRound text={turned} done={() => turnRound(null)} />
        </Suspense>
      )}
      <button
        type="button"
        className="button plain"
        aria-haspopup="dialog"
        onClick={() => teach({ text: openText(), work: useEditor.getState().work ?? "" })}
      >
        <Icon name="rename" /> {t.makeTask}
      </button>
      {taught !== null && (
        <Suspense>
          <TeachDialog {...taught} done={() => teach(null)} />
        </Suspense>
      )}
      {ofProgram && (
        <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => setClamps(true)}>
          {t.clamping}
        </button>
      )}
      {clamps && (
        <Suspense>
          <ClampingDialog done={() => setClamps(false)} />
        </Suspense>
      )}
      <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => showComparison(showBlock)}>
        <Icon name="compare" /> {t.compare}
      </button>
      <button type="button" className="button plain" aria-haspopup="dialog" onClick={() => setOutput(true)}>
        {t.output}
      </button>
      {sets && (
        <Suspense>
          <OutputDialog done={() => setOutput(false)} />
        </Suspense>
      )}
      {children}
    </div>
  );
}

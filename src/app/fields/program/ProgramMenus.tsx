import { Suspense, useState, type ReactNode } from "react";
import { flushEdits, openContent, useEditor } from "../../document/store.ts";
import type { ShownVerdict } from "../../findings/verdict.ts";
import { showComparison, type ShowBlock, showSheet } from "../../place/place.ts";
import { useActions } from "../../base/actions.ts";
import { Menu, type MenuItem } from "../../base/Menu.tsx";
import { confirmExport } from "../leaving/confirm-export.ts";
import { lazyWithin } from "../../base/parts.ts";
import { drawingSlot, exportSlot, shareSlot, exerciseSlot } from "../slots.ts";
import { asProgram, openText } from "../../document/printed.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { Work } from "../../document/work.ts";

/** Loaded when first opened. */
const HandOnDialog = lazyWithin(async () => ({ default: await shareSlot.fetch() }));
const PartExport = lazyWithin(async () => ({ default: await exportSlot.fetch() }));
const TurnRound = lazyWithin(async () => ({ default: (await import("./SecondSideDialog.tsx")).SecondSideDialog }));
const ProgramDrawing = lazyWithin(async () => ({ default: await drawingSlot.fetch() }));
const ClampingDialog = lazyWithin(async () => ({ default: (await import("./ClampingDialog.tsx")).ClampingDialog }));
const OutputDialog = lazyWithin(async () => ({ default: (await import("./OutputDialog.tsx")).OutputDialog }));
const TeachDialog = lazyWithin(async () => ({ default: await exerciseSlot.fetch() }));

/** A work to share, with its verdict. */
export interface Leaving {
  readonly open: Work;
  readonly verdict: ShownVerdict;
}

/** The open work with its verdict; null if sharing was cancelled. */
export async function leaving(): Promise<Leaving | null> {
  flushEdits();
  const open = openContent();
  const verdict = open && (await confirmExport("share"));
  return open && verdict && { open, verdict };
}

/** The text of what is open. */
function presentText(): string {
  flushEdits();
  return openText() ?? "";
}

/** Name of the open program without extension, for files made from it. */
export function openStem(): string {
  flushEdits();
  const open = openContent();
  return open ? asProgram(open).name.replace(/\.[^.]*$/, "") : "";
}

/** What can be made of the open program, and what can be done with it; the workplace adds its own actions. */
export function ProgramMenus({
  showBlock,
  files,
  changes = [],
}: {
  readonly showBlock: ShowBlock;
  /** The files of the program itself. */
  readonly files: readonly MenuItem[];
  readonly changes?: readonly MenuItem[];
}) {
  const {
    page: { text: t, program },
    findings: { betterWays },
  } = useTexts();
  const [dialog, show] = useState<ReactNode>(null);
  const ofProgram = useEditor((s) => s.program !== null);
  // An exercise asks for the better way itself.
  const canImprove = useEditor((s) => s.program !== null && s.program.task === undefined);
  const done = () => show(null);
  const opens = "dialog";
  const sheet = () => {
    flushEdits();
    showSheet();
  };
  const share = async () => {
    const handed = await leaving();
    if (handed) show(<HandOnDialog {...handed} done={done} />);
  };
  const exercise = () => show(<TeachDialog text={presentText()} work={useEditor.getState().work ?? ""} done={done} />);
  const draw = () => show(<ProgramDrawing stem={openStem()} done={done} />);
  const exportPart = () => show(<PartExport stem={openStem()} done={done} />);
  const compare = () => showComparison(showBlock);
  const improve = () => showComparison(showBlock, "better");
  const flip = () => show(<TurnRound text={presentText()} done={done} />);
  const clamp = () => show(<ClampingDialog done={done} />);
  const setOutput = () => show(<OutputDialog done={done} />);
  useActions([
    { id: "do.sheet", name: t.setupSheet, run: sheet },
    { id: "do.drawing", name: t.workshopDrawing, run: draw },
    { id: "do.share", name: t.handOn, run: () => void share() },
    { id: "do.exportPart", name: t.exportPart, run: exportPart },
    { id: "do.flip", name: t.turnRound, run: flip },
    { id: "do.exercise", name: t.makeTask, run: exercise },
    ...(ofProgram ? [{ id: "do.clamping", name: t.clamping, run: clamp } as const] : []),
    { id: "do.compare", name: t.compare, run: compare },
    ...(canImprove ? [{ id: "do.improve", name: betterWays, run: improve } as const] : []),
    { id: "do.output", name: t.output, run: setOutput },
    ...[...files, ...changes].map(({ name, go }, i) => ({ id: `do.file ${i}`, name, run: go }) as const),
  ]);
  return (
    <div className="program-more">
      <Menu
        name={t.exportMenu}
        groups={[
          files,
          [
            { name: t.setupSheet, icon: "print", go: sheet },
            { name: t.workshopDrawing, icon: "drawing", opens, go: draw },
            { name: t.exportPart, icon: "solid", opens, go: exportPart },
          ],
          [
            { name: t.handOn, icon: "share", opens, go: () => void share() },
            { name: t.makeTask, icon: "rename", opens, go: exercise },
          ],
        ]}
      />
      <Menu
        name={program}
        groups={[
          [
            { name: t.compare, icon: "compare", opens, go: compare },
            ...(canImprove ? [{ name: betterWays, icon: "search", opens, go: improve } as const] : []),
            { name: t.turnRound, icon: "turn", opens, go: flip },
            ...(ofProgram ? [{ name: t.clamping, icon: "clamp", opens, go: clamp } as const] : []),
          ],
          [{ name: t.output, icon: "settings", opens, go: setOutput }, ...changes],
        ]}
      />
      <Suspense>{dialog}</Suspense>
    </div>
  );
}

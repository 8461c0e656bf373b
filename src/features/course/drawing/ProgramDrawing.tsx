import { producedParts } from "../../../sim/produced-parts.ts";
import { useMemo, useRef } from "react";
import { createPortal } from "react-dom";
import { drawnProgram } from "../../../course/drawn-program.ts";
import type { Task } from "../../../course/task.ts";
import { finishedBody, isBody } from "../../../view/solid/bodies.ts";
import { useOutcome, type Outcome } from "../../../app/calculation/outcome.ts";
import { useMaterialOfWork } from "../../../app/fields/said/use-advice.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { programName } from "../../../app/document/printed.ts";
import { useEditor } from "../../../app/document/store.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { useTaskFile } from "../task/use-task-file.ts";
import { DrawingSheet } from "./DrawingSheet.tsx";
import { printWords } from "./print-words.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import "./drawing.css";

/** The part of a program: as its cycles and moves define it, or, without cycles, as it is machined. */
function drawnOf(outcome: Outcome, known: Task | null) {
  const { run, simulation } = outcome;
  const wanted = finishedBody(simulation, run.operations);
  return drawnProgram(outcome, isBody(wanted) ? wanted : producedParts(simulation), known);
}

/** The reason, in place of a missing drawing. */
function NoDrawing({ name, text, done }: { readonly name: string; readonly text: string; readonly done: () => void }) {
  const t = useTexts("course-drawing");
  const dialog = useRef<HTMLDialogElement>(null);
  return createPortal(
    <ModalDialog isBare ref={dialog} className="drawing-none" title={name} done={done}>
      <p role="status">{text}</p>
      <button type="button" className="button" onClick={() => dialog.current?.close()}>
        <Icon name="back" /> {t.close}
      </button>
    </ModalDialog>,
    document.body,
  );
}

/** The workshop drawing of the open program's part, from its own contours; large, to print and to save. */
export function ProgramDrawing({ stem, done }: { readonly stem: string; readonly done: () => void }) {
  const t = useTexts("course-drawing");
  const language = useSettings((s) => s.language);
  const shown = useOutcome((s) => s.shown),
    dimmed = useOutcome((s) => s.dimmed);
  const file = useEditor((s) => s.program?.name);
  const { material } = useMaterialOfWork();
  const task = useTaskFile(),
    known = task === "none" ? null : task;
  const words = useMemo(() => printWords(t, language), [t, language]);
  const outcome = shown?.isBeginning ? null : shown;
  const drawn = useMemo(() => outcome && drawnOf(outcome, known), [outcome, known]);
  const name = (outcome && programName(outcome.text)) || stem;
  if (!outcome || !drawn)
    return <NoDrawing name={t.drawingOf(name)} text={outcome ? t.noPart : t.calculating} done={done} />;
  const titled = {
    name,
    number: file ?? `${stem}.h`,
    material: material.name,
    notes: [...(dimmed ? [t.older] : []), ...(outcome.run.unproved.length > 0 ? [t.unproved] : [])],
  };
  return <DrawingSheet titled={titled} drawn={drawn} words={words} t={t} stem={`${stem}_${t.file}`} onClose={done} />;
}

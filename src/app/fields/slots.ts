import type { ComponentType, ReactNode } from "react";
import type { Task } from "../../course/task.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Language } from "../../i18n/languages.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { slot } from "../base/slot.ts";
import type { Work } from "../document/work.ts";
import type { ShownVerdict } from "../findings/verdict.ts";
import type { GuidePath } from "../place/place.ts";

/*
 * Slots for parts of other features. The shell fills them (shell/slots.ts).
 */

type Part<P> = ComponentType<P>;
type Done = { readonly done: () => void };

export const shareSlot = slot<Part<Done & { readonly open: Work; readonly verdict: ShownVerdict }>>("handing on");
export const qrSlot = slot<Part<{ readonly link: string; readonly name: string }>>("a QR code");
export const exportSlot = slot<Part<Done & { readonly stem: string }>>("the export of a part");
export const drawingSlot = slot<Part<Done & { readonly stem: string }>>("the drawing of a program");
export const exerciseSlot =
  slot<Part<Done & ({ readonly text: string; readonly work: string } | { readonly task: Task })>>("making a task");
export const promptMoreSlot = slot<Part<{ readonly page: GuidePath; readonly name: string }>>("more about a prompt");
export const setupStartSlot =
  slot<Part<{ readonly cycle: Cycle; readonly surface: boolean; readonly perRevolution: boolean }>>(
    "starting values of a set-up",
  );
export const newProgramSlot = slot<Part<Done>>("a new program");
interface ContourProps {
  readonly rows: readonly ContourRow[];
  readonly onChange: (rows: readonly ContourRow[], place: string | null) => void;
  readonly language: Language;
}
/** The table of a contour, and its drawing on a large canvas. */
export const contourSlot = slot<{
  readonly ContourTable: Part<ContourProps & { readonly inches?: boolean; readonly isDrawingElsewhere?: boolean }>;
  readonly fetchContourStage: () => Promise<{
    readonly ContourStage: Part<ContourProps & { readonly blank: readonly Ring[]; readonly lead: ReactNode }>;
  }>;
}>("the contour editor");

/** Opens tasks, results and finished parts from files. */
export const courseFilesSlot = slot<{
  readonly areTaughtFiles: (files: readonly File[]) => Promise<boolean>;
  readonly openTaughtFiles: (files: readonly File[]) => Promise<void>;
}>("files of tasks");

import { whichSlot } from "../document/which-slot.ts";
import { contourTableSlot, drawingSlot, exportSlot, handOnSlot, newProgramSlot, promptMoreSlot, setupStartSlot, taughtFilesSlot,
  teachSlot } from "../fields/slots.ts";

/* Which feature gives the parts that others show. Each is fetched when it is first shown. */
whichSlot.fill(async () => (await import("../../features/which/WhichCycle.tsx")).WhichCycle);
handOnSlot.fill(async () => (await import("../../features/handing/HandOnDialog.tsx")).HandOnDialog);
exportSlot.fill(async () => (await import("../../features/export/PartExport.tsx")).PartExport);
drawingSlot.fill(async () => (await import("../../features/course/drawing/ProgramDrawing.tsx")).ProgramDrawing);
teachSlot.fill(async () => (await import("../../features/course/teach/TeachDialog.tsx")).TeachDialog);
promptMoreSlot.fill(async () => (await import("../../features/guide/PromptMore.tsx")).PromptMore);
setupStartSlot.fill(async () => (await import("../../features/guide/SetupStart.tsx")).SetupStart);
newProgramSlot.fill(async () => (await import("../../features/editor/operations/NewProgram.tsx")).NewProgram);
contourTableSlot.fill(async () => (await import("../../features/contour/ContourTable.tsx")).ContourTable);
taughtFilesSlot.fill(() => import("../../features/course/teach/open-taught.ts"));

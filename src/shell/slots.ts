import { whichSlot } from "../app/document/which-slot.ts";
import {
  contourTableSlot,
  drawingSlot,
  exportSlot,
  handOnSlot,
  newProgramSlot,
  promptMoreSlot,
  setupStartSlot,
  taughtFilesSlot,
  teachSlot,
} from "../app/fields/slots.ts";
import { fetchContourTable } from "../features/contour/index.ts";
import { fetchOpenTaught, fetchProgramDrawing, fetchTeachDialog } from "../features/course/index.ts";
import { fetchNewProgram } from "../features/editor/index.ts";
import { fetchPartExport } from "../features/export/index.ts";
import { fetchPromptMore, fetchSetupStart } from "../features/guide/index.ts";
import { fetchHandOnDialog } from "../features/handing/index.ts";
import { fetchWhichCycle } from "../features/which/index.ts";

/* The features that provide the parts of slots. Each is fetched when it is first shown. */
whichSlot.fill(async () => (await fetchWhichCycle()).WhichCycle);
handOnSlot.fill(async () => (await fetchHandOnDialog()).HandOnDialog);
exportSlot.fill(async () => (await fetchPartExport()).PartExport);
drawingSlot.fill(async () => (await fetchProgramDrawing()).ProgramDrawing);
teachSlot.fill(async () => (await fetchTeachDialog()).TeachDialog);
promptMoreSlot.fill(async () => (await fetchPromptMore()).PromptMore);
setupStartSlot.fill(async () => (await fetchSetupStart()).SetupStart);
newProgramSlot.fill(async () => (await fetchNewProgram()).NewProgram);
contourTableSlot.fill(async () => (await fetchContourTable()).ContourTable);
taughtFilesSlot.fill(fetchOpenTaught);

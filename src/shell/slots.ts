import { whichSlot } from "../app/document/which-slot.ts";
import {
  contourSlot,
  drawingSlot,
  exportSlot,
  qrSlot,
  shareSlot,
  newProgramSlot,
  promptMoreSlot,
  setupStartSlot,
  courseFilesSlot,
  exerciseSlot,
} from "../app/fields/slots.ts";
import { fetchContourStage, fetchContourTable } from "../features/contour/index.ts";
import { fetchProgramDrawing, fetchTeachDialog } from "../features/course/index.ts";
import { fetchNewProgram } from "../features/editor/index.ts";
import { fetchPartExport } from "../features/export/index.ts";
import { fetchPromptMore, fetchSetupStart } from "../features/guide/index.ts";
import { fetchQrSection, fetchShareDialog } from "../features/share/index.ts";
import { fetchWhichCycle } from "../features/which/index.ts";

/* The features that provide the parts of slots. Each is fetched when it is first shown. */
whichSlot.fill(async () => (await fetchWhichCycle()).WhichCycle);
shareSlot.fill(async () => (await fetchShareDialog()).ShareDialog);
qrSlot.fill(async () => (await fetchQrSection()).QrSection);
exportSlot.fill(async () => (await fetchPartExport()).PartExport);
drawingSlot.fill(async () => (await fetchProgramDrawing()).ProgramDrawing);
exerciseSlot.fill(async () => (await fetchTeachDialog()).TeachDialog);
promptMoreSlot.fill(async () => (await fetchPromptMore()).PromptMore);
setupStartSlot.fill(async () => (await fetchSetupStart()).SetupStart);
newProgramSlot.fill(async () => (await fetchNewProgram()).NewProgram);
contourSlot.fill(async () => ({ ...(await fetchContourTable()), fetchContourStage }));
courseFilesSlot.fill(() => import("./json-files.ts"));

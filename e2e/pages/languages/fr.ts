import { courseDrawing } from "../../../src/i18n/fr/course-drawing.ts";
import { clamping } from "../../../src/i18n/fr/clamping.ts";
import { compare } from "../../../src/i18n/fr/compare.ts";
import { course } from "../../../src/i18n/fr/course.ts";
import { courseTask } from "../../../src/i18n/fr/course-task.ts";
import { courseTeach } from "../../../src/i18n/fr/course-teach.ts";
import { device } from "../../../src/i18n/fr/device.ts";
import { handed } from "../../../src/i18n/fr/handed.ts";
import { machineTexts } from "../../../src/i18n/fr/machine.ts";
import { sheet } from "../../../src/i18n/fr/sheet.ts";
import { tables } from "../../../src/i18n/fr/tables.ts";
import { toolCodes } from "../../../src/i18n/fr/tool-codes.ts";
import { toolFiles } from "../../../src/i18n/fr/tool-files.ts";
import { workplace } from "../../../src/i18n/fr/workplace.ts";

/** The texts that page objects use, in one language: the build makes a file of each. */
export const parts = {
  "course-drawing": courseDrawing,
  clamping,
  compare,
  course,
  "course-task": courseTask,
  "course-teach": courseTeach,
  device,
  handed,
  machine: machineTexts,
  sheet,
  tables,
  "tool-codes": toolCodes,
  "tool-files": toolFiles,
  workplace,
};

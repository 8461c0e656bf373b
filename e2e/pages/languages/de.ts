import { courseDrawing } from "../../../src/i18n/de/course-drawing.ts";
import { clamping } from "../../../src/i18n/de/clamping.ts";
import { compare } from "../../../src/i18n/de/compare.ts";
import { course } from "../../../src/i18n/de/course.ts";
import { courseTask } from "../../../src/i18n/de/course-task.ts";
import { courseTeach } from "../../../src/i18n/de/course-teach.ts";
import { device } from "../../../src/i18n/de/device.ts";
import { handed } from "../../../src/i18n/de/handed.ts";
import { machineTexts } from "../../../src/i18n/de/machine.ts";
import { sheet } from "../../../src/i18n/de/sheet.ts";
import { tables } from "../../../src/i18n/de/tables.ts";
import { toolCodes } from "../../../src/i18n/de/tool-codes.ts";
import { toolFiles } from "../../../src/i18n/de/tool-files.ts";
import { workplace } from "../../../src/i18n/de/workplace.ts";

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

import { courseDrawing } from "../../../src/i18n/en/course-drawing.ts";
import { clamping } from "../../../src/i18n/en/clamping.ts";
import { compare } from "../../../src/i18n/en/compare.ts";
import { course } from "../../../src/i18n/en/course.ts";
import { courseTask } from "../../../src/i18n/en/course-task.ts";
import { courseTeach } from "../../../src/i18n/en/course-teach.ts";
import { device } from "../../../src/i18n/en/device.ts";
import { handed } from "../../../src/i18n/en/handed.ts";
import { machineTexts } from "../../../src/i18n/en/machine.ts";
import { sheet } from "../../../src/i18n/en/sheet.ts";
import { tables } from "../../../src/i18n/en/tables.ts";
import { toolCodes } from "../../../src/i18n/en/tool-codes.ts";
import { toolFiles } from "../../../src/i18n/en/tool-files.ts";
import { workplace } from "../../../src/i18n/en/workplace.ts";

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

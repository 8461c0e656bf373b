import { courseDrawing } from "../../../src/i18n/zh/course-drawing.ts";
import { clamping } from "../../../src/i18n/zh/clamping.ts";
import { compare } from "../../../src/i18n/zh/compare.ts";
import { course } from "../../../src/i18n/zh/course.ts";
import { courseTask } from "../../../src/i18n/zh/course-task.ts";
import { courseTeach } from "../../../src/i18n/zh/course-teach.ts";
import { device } from "../../../src/i18n/zh/device.ts";
import { handed } from "../../../src/i18n/zh/handed.ts";
import { machineTexts } from "../../../src/i18n/zh/machine.ts";
import { sheet } from "../../../src/i18n/zh/sheet.ts";
import { tables } from "../../../src/i18n/zh/tables.ts";
import { toolCodes } from "../../../src/i18n/zh/tool-codes.ts";
import { toolFiles } from "../../../src/i18n/zh/tool-files.ts";
import { workplace } from "../../../src/i18n/zh/workplace.ts";

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

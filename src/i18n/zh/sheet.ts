import type { SheetTexts } from "../en/sheet.ts";

export const sheet: SheetTexts = {
  title: "调机单",
  print: "打印",
  close: "返回程序",
  remarks: "备注",
  program: "程序",
};

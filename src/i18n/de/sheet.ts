import type { SheetTexts } from "../en/sheet.ts";

export const sheet: SheetTexts = {
  title: "Einrichteblatt",
  print: "Drucken",
  close: "Zurück zum Programm",
  remarks: "Bemerkungen",
  program: "Programm",
};

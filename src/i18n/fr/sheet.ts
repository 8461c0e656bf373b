import type { SheetTexts } from "../en/sheet.ts";

export const sheet: SheetTexts = {
  title: "Fiche de réglage",
  print: "Imprimer",
  close: "Retour au programme",
  remarks: "Remarques",
  program: "Programme",
};

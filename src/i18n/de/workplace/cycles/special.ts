import type { CycleTexts } from "../../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "Koordinatensystem anpassen",
    summary: "Passt das Koordinatensystem des Drehens an ein angestelltes oder gedrehtes Werkzeug an.",
    description: [
      "Beschreibt, wie das Werkzeug zum Werkstück steht: um seine Achse gedreht, umgekehrt, angestellt. Der " +
        "Zyklus wirkt ab " +
        "seiner Definition und braucht keinen Aufruf.",
      "Vor dem Drehen und nach jedem Werkzeugwechsel einsetzen.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Mit allen Winkeln 0, ohne umgekehrtes Werkzeug und mit Q535 = 0 oder 3 ändert der Zyklus nichts. Mit " +
        "anderen Werten bleibt der Satz im Programm, wird nicht simuliert, und ab hier ist das Programm nicht " +
        "geprüft.",
      "Neuere Software hat zusätzlich den Rückzugsparameter Q599; der Parameter bleibt im Programm.",
    ],
  },
  801: {
    name: "Koordinatensystem zurücksetzen",
    summary: "Hebt die Anpassung durch Zyklus 800 auf.",
    description: [
      "Setzt das Koordinatensystem des Drehens zurück. Der Zyklus hat keine Parameter, wirkt ab seiner " +
        "Definition und braucht keinen Aufruf.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Ein nach Zyklus 800 nicht geprüftes Programm bleibt nicht geprüft: Die Stellung der Maschine ist hier " +
        "nicht bekannt.",
    ],
  },
} satisfies CycleTexts;

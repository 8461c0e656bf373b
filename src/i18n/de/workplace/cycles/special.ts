import type { CycleTexts } from "../../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "Koordinatensystem anpassen",
    summary: "Passt das Koordinatensystem des Drehens an ein angestelltes oder gedrehtes Werkzeug an.",
    description: [
      "Beschreibt, wie das Werkzeug zum Werkstück steht: um seine Achse gedreht, umgekehrt, angestellt. Der Zyklus wirkt ab " +
        "seiner Definition und braucht keinen Aufruf.",
      "Vor dem Drehen und nach jedem Werkzeugwechsel einsetzen.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Mit allen Winkeln 0, ohne umgekehrtes Werkzeug und mit Q535 = 0 oder 3 ändert er nichts, und das Programm läuft " +
        "weiter. Mit allen anderen Werten bleibt der Satz im Programm, aber dahinter ist nichts geprüft.",
      "Neuere Software kennt dazu den Rückzugsparameter Q599; er bleibt im Programm.",
    ],
  },
  801: {
    name: "Koordinatensystem zurücksetzen",
    summary: "Nimmt zurück, was Zyklus 800 angepasst hat.",
    description: [
      "Setzt das Koordinatensystem des Drehens zurück. Er hat keine Parameter, wirkt ab seiner Definition und braucht " +
        "keinen Aufruf.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Was nach Zyklus 800 nicht geprüft ist, bleibt es auch danach: Die Stellung der Maschine ist hier nicht bekannt.",
    ],
  },
} satisfies CycleTexts;

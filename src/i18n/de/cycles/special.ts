import type { CycleTexts } from "../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "Koordinatensystem anpassen",
    summary: "Passt das Koordinatensystem des Drehens an ein angestelltes oder gedrehtes Werkzeug an.",
    description: [
      "Sagt, wie das Werkzeug zum Werkstück steht: um seine Achse gedreht, umgekehrt, angestellt. Der Zyklus wirkt, wo er im "
      + "Programm steht, und braucht keinen Aufruf.",
      "Vor dem Drehen und nach jedem Werkzeugwechsel einsetzen.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Mit allen Winkeln 0, ohne umgekehrtes Werkzeug und mit Q535 = 0 oder 3 ändert er nichts, und das Programm läuft "
      + "weiter. Mit allem anderen bleibt der Satz stehen, und dahinter ist nichts bewiesen.",
      "Neuere Software kennt dazu einen Rückzugsparameter Q599; er bleibt stehen.",
    ],
  },
  801: {
    name: "Koordinatensystem zurücksetzen",
    summary: "Nimmt zurück, was Zyklus 800 angepasst hat.",
    description: [
      "Setzt das Koordinatensystem des Drehens zurück. Er hat keine Parameter, wirkt, wo er im Programm steht, und braucht "
      + "keinen Aufruf.",
    ],
    rough: [],
    finish: [],
    notes: [turnMode, "Was Zyklus 800 unbewiesen gelassen hat, bleibt so: Wo die Maschine dann steht, weiß hier niemand."],
  },
} satisfies CycleTexts;

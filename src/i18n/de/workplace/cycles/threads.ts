import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const steps = [
  "im Eilgang auf Sicherheitsabstand und Tiefe des Schnitts",
  "Gewindeschnitt, Vorschub mit der Spindel synchron",
  "im Eilgang um den Sicherheitsabstand abheben",
  "im Eilgang zurück, Zustellung nach Q467",
  "wiederholen, bis die Tiefe erreicht ist",
  "Leerschnitte auf Fertigtiefe",
  "dasselbe für den nächsten Gang",
  "im Eilgang zurück zum Zyklusstart",
];
const thread = [
  "Jeder Schnitt läuft vom Anlaufweg bis zum Gewindeende, synchron zur Spindel; dazwischen fährt das Werkzeug im " +
    "Eilgang zurück. Bei konstantem Spanquerschnitt wächst die Tiefe mit der Wurzel der Schnittnummer.",
  "Der Nenndurchmesser liegt beim Außengewinde an der Spitze, beim Innengewinde am Grund. Geschnitten wird von " +
    "Start-Z nach End-Z; Richtung und Drehsinn der Spindel bestimmen, ob ein Rechts- oder ein Linksgewinde " +
    "entsteht.",
];
const notes = [
  turnMode,
  safePosition,
  "Der Vorschub-Override wirkt beim Gewindeschneiden nicht.",
  "Das Werkzeug hat TYPE THREAD; die Spitze zeigt senkrecht ins Material.",
];

export const threads = {
  830: {
    name: "Gewinde konturparallel",
    summary: "Schneidet ein Gewinde entlang einer freien Kontur.",
    description: [
      ...thread,
      "Die Kontur ist die Linie des Nenndurchmessers; sie muss entlang der synchronen Achse in einer Richtung " +
        "verlaufen. Kreisbögen werden als Sehnen geschnitten. Zyklus 14 wählt die Kontur.",
    ],
    rough: steps,
    finish: [],
    notes,
  },
  831: {
    name: "Gewinde längs",
    summary: "Schneidet ein Gewinde auf einem Zylinder, außen oder innen.",
    description: [...thread, "Anlaufweg ist der Sicherheitsabstand Q460, Überlaufweg eine Spindelumdrehung."],
    rough: steps,
    finish: [],
    notes,
  },
  832: {
    name: "Gewinde erweitert",
    summary: "Schneidet ein Gewinde auf Zylinder, Kegel oder Stirnfläche, mit eigenem Anlauf- und Überlaufweg.",
    description: [
      ...thread,
      "Der Kegel lässt sich durch zwei Punkte oder durch einen Punkt und einen Winkel angeben (Q464).",
    ],
    rough: steps,
    finish: [],
    notes,
  },
} satisfies CycleTexts;

import type { CycleTexts } from "../../../cycle-text.ts";
import { safePosition, turnMode } from "./notes.ts";

const steps = [
  "im Eilgang auf Sicherheitsabstand und Tiefe des Schnitts",
  "schneiden, der Vorschub an die Spindel gekoppelt",
  "im Eilgang um den Sicherheitsabstand abheben",
  "im Eilgang zurück, Zustellung entlang Q467",
  "wiederholen, bis die Tiefe erreicht ist",
  "Leerschnitte auf fertiger Tiefe",
  "dasselbe für den nächsten Gang",
  "im Eilgang zurück zum Zyklusstart",
];
const thread = [
  "Jeder Schnitt läuft vom Anlauf bis zum Ende des Gewindes, an die Spindel gekoppelt; dazwischen fährt das " +
    "Werkzeug im Eilgang zurück. Bei konstantem Spanquerschnitt wächst die Tiefe mit der Wurzel der Schnittnummer.",
  "Der Nenndurchmesser liegt beim Außengewinde an der Spitze, beim Innengewinde am Grund. Geschnitten wird von " +
    "Start-Z nach End-Z; daraus und aus der Drehrichtung der Spindel folgt, ob ein Rechts- oder ein Linksgewinde entsteht. " +
    "Unsere Auslegung; an der Steuerung prüfen.",
];
const notes = [
  turnMode,
  safePosition,
  "Der Vorschub-Override wirkt beim Gewindeschneiden nicht.",
  "Das Werkzeug hat TYPE THREAD, und seine Spitze zeigt gerade ins Material.",
];

export const threads = {
  830: {
    name: "Gewinde konturparallel",
    summary: "Schneidet ein Gewinde entlang einer freien Kontur.",
    description: [
      ...thread,
      "Die Kontur ist die Linie des Nenndurchmessers; sie muss entlang der gekoppelten Achse weiterlaufen. " +
        "Bögen werden als Sehnen geschnitten. Zyklus 14 nennt sie.",
    ],
    rough: steps,
    finish: [],
    notes,
  },
  831: {
    name: "Gewinde längs",
    summary: "Schneidet ein Gewinde auf einem Zylinder, außen oder innen.",
    description: [
      ...thread,
      "Anlauf ist der Sicherheitsabstand Q460, Überlauf eine Spindelumdrehung. Unsere Auslegung; an der Steuerung prüfen.",
    ],
    rough: steps,
    finish: [],
    notes,
  },
  832: {
    name: "Gewinde erweitert",
    summary: "Schneidet ein Gewinde auf Zylinder, Kegel oder Stirnfläche, mit eigenem An- und Überlauf.",
    description: [
      ...thread,
      "Der Kegel lässt sich durch zwei Punkte oder durch einen Punkt und einen Winkel angeben (Q464).",
    ],
    rough: steps,
    finish: [],
    notes,
  },
} satisfies CycleTexts;

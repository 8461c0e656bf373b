import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const longitudinal = {
  812: {
    name: "Absatz längs erweitert",
    summary: "Dreht einen Absatz längs, mit Fasen, Winkeln und Eckenradius.",
    description: [
      "Dreht einen Absatz in Längsrichtung. Die Kanten an Konturstart und Konturende können eine Fase oder einen Radius "
      + "bekommen, Umfangsfläche und Planfläche können geneigt, die Innenecke kann verrundet sein.",
      "Schruppt achsparallel, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: Außenbearbeitung. "
      + "Kleiner: Innenbearbeitung.",
      "Liegt der Startpunkt im Zerspanbereich, fährt das Werkzeug zuerst in X, dann in Z auf Sicherheits-Abstand; beim "
      + "Schlichten zuerst in Z auf Sicherheits-Abstand.",
    ],
    rough: [
      "achsparallel zustellen im Eilgang",
      "längs schneiden mit Schruppvorschub",
      "um die Zustellung zurückziehen",
      "im Eilgang zum Anfang des Schnitts",
      "wiederholen, bis die Kontur erreicht ist",
      "im Eilgang zum Zyklusstart",
    ],
    finish: [
      "achsparallel zustellen im Eilgang",
      "Kontur von Start bis Ende schlichten",
      "um den Sicherheits-Abstand zurückziehen",
      "im Eilgang zum Zyklusstart",
    ],
    notes: [turnMode, safePosition, edgeLength],
  },
} satisfies CycleTexts;

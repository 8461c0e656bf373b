import type { CycleTexts } from "../../cycle-text.ts";
import { edgeLength, safePosition, turnMode } from "./notes.ts";

export const transverse = {
  820: {
    name: "Kontur plan",
    summary: "Dreht eine freie Kontur aus einem Unterprogramm, in Planrichtung.",
    description: [
      "Dreht eine beliebige Kontur in Planrichtung. Die Kontur steht als Unterprogramm aus Geraden, Rundungen, Fasen und Bögen "
      + "im Programm und wird mit Zyklus 14 oder SEL CONTOUR benannt.",
      "Schruppt achsparallel, schlichtet oder macht beides. Erster Konturpunkt in X größer als der letzte: Außenbearbeitung. "
      + "Kleiner: Innenbearbeitung.",
      "Liegt Z des Startpunkts unter dem Konturstart, fährt das Werkzeug zuerst in Z auf den Konturstart; beim Schlichten auf "
      + "Sicherheits-Abstand.",
    ],
    rough: [
      "achsparallel zustellen im Eilgang",
      "plan schneiden mit Schruppvorschub",
      "um die Zustellung zurückziehen",
      "im Eilgang zum Anfang des Schnitts",
      "wiederholen, bis die Kontur erreicht ist",
      "im Eilgang zum Zyklusstart",
    ],
    finish: [
      "zustellen im Eilgang",
      "Kontur von Start bis Ende schlichten",
      "um den Sicherheits-Abstand zurückziehen",
      "im Eilgang zum Zyklusstart",
    ],
    notes: [
      "Kollisionsgefahr: Die Schnittbegrenzung begrenzt die bearbeitete Kontur, An- und Abfahrwege dürfen sie überschreiten. Das "
      + "Werkzeug vor dem Aufruf auf die Seite der Grenze stellen, die zerspant werden soll.",
      turnMode,
      safePosition,
      "Die Schneidenform wird berücksichtigt, damit kein Element verletzt wird. Was das Werkzeug nicht erreicht, bleibt mit "
      + "einer Warnung stehen.",
      "Vor dem Aufruf muss Zyklus 14 mit dem Label der Kontur oder SEL CONTOUR mit ihrer Datei stehen.",
      "Lokale Parameter (QL) der Kontur müssen im Konturunterprogramm selbst belegt werden.",
      edgeLength,
    ],
  },
} satisfies CycleTexts;

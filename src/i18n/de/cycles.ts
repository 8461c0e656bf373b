import type { CyclesTexts } from "../cycle-text.ts";

const turnMode = "Läuft nur in FUNCTION MODE TURN. An einer TNC7 muss der Maschinenhersteller die Funktion freigegeben haben.";
const safePosition =
  "Vor dem Aufruf das Werkzeug mit R0 auf eine sichere Position fahren: Dieser Punkt ist der Zyklusstart und bestimmt, wie "
  + "viel zerspant wird.";
const edgeLength =
  "Eine CUTLENGTH in der Werkzeugtabelle begrenzt beim Schruppen die Zustellung; sie wird dann mit einer Meldung verringert.";

export const cycles = {
  groups: { shoulder: "Absätze", contour: "Freie Konturen", recessTurning: "Stechdrehen" },
  evidence: {
    A: "gedruckt in einem Handbuch dieser Steuerung",
    B: "gedruckt für eine Schwestersteuerung",
    L: "von den Drehsteuerungen, aus denen diese Zyklen stammen",
    I: "aus gedruckten Angaben erschlossen",
    K1: "sicher erinnert, nicht an einer gedruckten Seite geprüft",
    K2: "erinnert, nicht an einer gedruckten Seite geprüft",
    K3: "unsicher, nicht an einer gedruckten Seite geprüft",
  },
  kinds: {
    choice: "Auswahl",
    diameter: "Durchmesser",
    oversizeDiameter: "Aufmaß auf den Durchmesser",
    radial: "auf den Radius",
    axial: "in Z",
    axialDepth: "Tiefe in Z",
    length: "Länge",
    angle: "Winkel",
    feed: "Vorschub",
  },
  roughStep: (step, of, text) => `Schritt ${step} von ${of}: ${text}`,
  finishStep: (step, of, text) => `Schlichten, Schritt ${step} von ${of}: ${text}`,
  positioning: "Positionieren vor Schritt 1",
  of: {
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
    852: {
      name: "Stechdrehen axial erweitert",
      summary: "Dreht einen Einstich in eine Planfläche, mit geneigten Flanken, Fasen und Eckenradien.",
      description: [
        "Fertigt einen Einstich in der Planfläche durch Stechdrehen: Das Werkzeug sticht auf Tiefe und dreht dann seitlich, mit "
        + "wenigen Abhebewegen. Die Kanten können eine Fase oder einen Radius bekommen, beide Flanken können geneigt, die Ecken am "
        + "Grund verrundet sein.",
        "Schruppt achsparallel, schlichtet oder macht beides. Startdurchmesser größer als Enddurchmesser: Außenbearbeitung. "
        + "Kleiner: Innenbearbeitung.",
        "Liegt Z des Startpunkts unter dem Konturstart Q492, fährt das Werkzeug zuerst in Z auf Q492.",
      ],
      rough: [
        "auf die erste Tiefe einstechen",
        "seitlich zwischen Start und Ende schneiden mit Schruppvorschub",
        "fallende Elemente mit eigenem Vorschub",
        "abheben, zurückfahren und neu anfahren (eine Richtung) oder an beiden Enden zustellen (beide Richtungen)",
        "auf die nächste Tiefe schneiden",
        "wiederholen, bis die Einstichtiefe erreicht ist",
        "im Eilgang auf Abstand, dann ein Schnitt an jeder Flanke",
        "im Eilgang zum Zyklusstart",
      ],
      finish: [
        "im Eilgang zur ersten Flanke",
        "erste Flanke schlichten",
        "Grund schlichten; mit Eckenradius den ganzen Einstich in einem Zug",
        "im Eilgang freifahren",
        "im Eilgang zur zweiten Flanke",
        "zweite Flanke schlichten",
        "im Eilgang zum Zyklusstart",
      ],
      notes: [
        turnMode,
        safePosition,
        "Ab der zweiten Zustellung wird jeder Schnitt um 0,1 mm kürzer, oder um Q508; das entlastet das Werkzeug seitlich. Der "
        + "Rest fällt am Ende des Schruppens in einem Schnitt.",
        "Überschreitet der Versatz 80 % der wirksamen Breite (Schneidenbreite minus zweimal Schneidenradius), meldet die Steuerung "
        + "einen Fehler.",
        edgeLength,
        "Die Seite nennt Q460 reserviert und führt den Sicherheits-Abstand doch in zwei Schritten; wir nehmen dort einen festen Abstand.",
      ],
    },
  },
} satisfies CyclesTexts;

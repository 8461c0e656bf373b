export const turnMode =
  "Läuft nur in FUNCTION MODE TURN. An einer TNC7 muss der Maschinenhersteller die Funktion freigegeben haben.";
export const safePosition =
  "Vor dem Aufruf das Werkzeug mit R0 auf eine sichere Position fahren: Dieser Punkt ist der Zyklusstart und bestimmt, wie " +
  "viel zerspant wird.";
export const edgeLength =
  "Eine CUTLENGTH in der Werkzeugtabelle begrenzt beim Schruppen die Zustellung; sie wird dann mit einer Warnung verringert.";
/** What holds for every cycle that takes its contour from a subprogram. */
export const freeContour = [
  "Kollisionsgefahr: Die Schnittbegrenzung begrenzt die bearbeitete Kontur, An- und Abfahrwege dürfen sie überschreiten. Das " +
    "Werkzeug vor dem Aufruf auf der Seite der Grenze positionieren, die zerspant werden soll.",
  turnMode,
  safePosition,
  "Die Schneidengeometrie wird berücksichtigt, damit kein Konturelement verletzt wird. Was das Werkzeug nicht erreicht, bleibt mit " +
    "einer Warnung stehen.",
  "Vor dem Aufruf muss Zyklus 14 mit dem Label der Kontur oder SEL CONTOUR mit ihrer Datei stehen.",
  "Lokale Parameter (QL) der Kontur müssen im Konturunterprogramm selbst belegt werden.",
  edgeLength,
];
/** What holds where a tool plunges and no feed is asked for it. */
export const plunging =
  "Eingetaucht wird mit dem Schruppvorschub: Einen eigenen Vorschub dafür haben diese Zyklen nicht. An einer Flanke, die " +
  "steiler ist, als die Schneide folgen kann, bleibt mit einer Warnung Material stehen.";

export const turnMode =
  "Läuft nur in FUNCTION MODE TURN. An einer TNC7 muss der Maschinenhersteller die Funktion freigegeben haben.";
export const safePosition =
  "Vor dem Aufruf das Werkzeug mit R0 auf eine sichere Position fahren: Dieser Punkt ist der Zyklusstart und " +
  "bestimmt den Zerspanbereich.";
export const edgeLength =
  "CUTLENGTH in der Werkzeugtabelle begrenzt die Zustellung beim Schruppen; eine größere Zustellung wird mit " +
  "Warnung verringert.";
/** Notes of every cycle that takes its contour from a subprogram. */
export const freeContour = [
  "Kollisionsgefahr: Die Schnittbegrenzung begrenzt die bearbeitete Kontur, An- und Abfahrwege dürfen sie " +
    "überschreiten. Das " +
    "Werkzeug vor dem Aufruf auf der Seite der Grenze positionieren, die zerspant werden soll.",
  turnMode,
  safePosition,
  "Die Schneidengeometrie wird berücksichtigt, damit kein Konturelement verletzt wird. Wo das Werkzeug nicht " +
    "hinkommt, bleibt Restmaterial, mit Warnung.",
  "Vor dem Aufruf Zyklus 14 mit dem Label der Kontur oder SEL CONTOUR mit der Konturdatei programmieren.",
  "Lokale Parameter (QL) der Kontur im Konturunterprogramm selbst zuweisen oder berechnen.",
  edgeLength,
];
/** Note of the cycles that plunge without a plunging feed. */
export const plunging =
  "Das Werkzeug taucht mit dem Schruppvorschub ein: Diese Zyklen haben keinen eigenen Eintauchvorschub. An einer " +
  "Flanke, der die Schneide nicht folgen kann, bleibt Restmaterial, mit Warnung.";
/** Note of cycle 812: a printed list, with one fact that the page leaves open. */
export const inclination =
  "Nicht gedruckt, daher nicht geprüft: die Richtung, in die Q495 und Q496 die Flächen neigen.";

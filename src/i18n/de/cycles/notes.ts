export const turnMode = "Läuft nur in FUNCTION MODE TURN. An einer TNC7 muss der Maschinenhersteller die Funktion freigegeben haben.";
export const safePosition =
  "Vor dem Aufruf das Werkzeug mit R0 auf eine sichere Position fahren: Dieser Punkt ist der Zyklusstart und bestimmt, wie "
  + "viel zerspant wird.";
export const edgeLength =
  "Eine CUTLENGTH in der Werkzeugtabelle begrenzt beim Schruppen die Zustellung; sie wird dann mit einer Meldung verringert.";

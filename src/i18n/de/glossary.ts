import type { GlossaryTexts } from "../glossary-text.ts";

const UMLAUTS: Readonly<Record<string, string>> = { a: "ä", au: "äu", o: "ö", u: "ü" };

/**
 * A pattern of a noun with its endings, and its plural where that changes the stem: Satz, Sätze; Span, Späne; Zyklus,
 * Zyklen.
 */
function formsOf(name: string): string {
  const umlauted = name.replace(/(au|[aou])(?=[^aeiouäöü]+$)/u, (vowel) => UMLAUTS[vowel] ?? vowel);
  return `(?:${name}(?:e[nsr]?|n|s|ern)?|${umlauted}en?|${name.replace(/us$/u, "en")})`;
}

export const glossary: GlossaryTexts = {
  words: { formsOf, capitals: true, apart: true },
  blank: {
    name: "Rohteil",
    text: "Das Material vor dem ersten Schnitt, definiert mit BLK FORM: Zylinder, Rohr oder Umriss.",
  },
  stock: {
    name: "Rohmaterial",
    text: "Das aktuelle Material: Rohteil abzüglich aller bisherigen Schnitte.",
  },
  finishedPart: {
    name: "Fertigteil",
    text: "Das Teil nach allen Schnitten, wie gezeichnet. Kein Schnitt darf es verletzen.",
  },
  residue: {
    name: "Restmaterial",
    text:
      "Material, das auf der Kontur bleibt, weil die Schneidplatte nicht hinkommt: in Ecken, hinter Flanken, an " +
      "Grenzen.",
  },
  contour: {
    name: "Kontur",
    text: "Der Linienzug aus Geraden und Kreisbögen der fertigen Fläche, in Bearbeitungsrichtung.",
  },
  cornerElement: {
    name: "Fase, Rundung",
    text: "Element, das eine Ecke zwischen zwei Elementen bricht, oder die Kante am Start oder Ende eines Absatzes.",
    // Not the nose of the insert.
    where: "(?<!(?:ihre|ohne) )",
  },
  shoulder: { name: "Absatz", text: "Ein Zylinder und eine Planfläche, die sich in einer Innenecke treffen." },
  face: { name: "Planfläche", text: "Eine Fläche rechtwinklig zur Drehachse, gedreht mit einer Bewegung in X." },
  recess: {
    name: "Einstich",
    text: "Ein Grund zwischen zwei Flanken. Stechdrehen schneidet seitlich, Stechen mit Stichen nebeneinander.",
  },
  undercut: {
    name: "Freistich",
    text:
      "Eine Vertiefung unter dem Fertigmaß in der Ecke vor einer Planfläche, damit Gegenstück oder Schleifscheibe " +
      "Platz haben.",
  },
  thread: {
    name: "Gewinde",
    text:
      "Eine Rille auf einer Schraubenlinie. Der Vorschub läuft synchron zur Spindel, damit jeder Schnitt " +
      "dieselbe Rille trifft.",
  },
  pitch: {
    name: "Steigung",
    text:
      "Weg je Spindelumdrehung. Bei mehreren Gängen ist der Abstand von Rille zu Rille die Teilung: Steigung durch " +
      "Anzahl der Gänge.",
  },
  runIn: {
    name: "Anlaufweg",
    text: "Weg vor dem Gewinde, auf dem die Achse auf den Vorschub beschleunigt.",
    also: "Anlauf",
  },
  oversize: {
    name: "Aufmaß",
    text: "Material, das nach dem Schruppen für das Schlichten bleibt: Q483 im Durchmesser, Q484 in Z.",
    // Not the material in front of the face.
    where: "(?!Aufmaß zum Plan)",
  },
  workpieceZero: {
    name: "Werkstück-Nullpunkt",
    text:
      "Position von X0 und Z0. X0 ist die Spindelachse; Z0 liegt meist auf der fertigen Planfläche, das Teil auf " +
      "der Minusseite.",
    also: "Nullpunkt",
  },
  diameter: {
    name: "Durchmesser (⌀)",
    text: "X wird als Durchmesser programmiert. 2 mm in X bewegen das Werkzeug um 1 mm.",
  },
  radius: {
    name: "Auf den Radius (r)",
    text: "Tiefen quer zur Drehachse gelten je Seite: 3 mm sind 6 mm im Durchmesser.",
  },
  theoreticalTip: {
    name: "Theoretische Schneidenspitze",
    text:
      "Die Ecke, die die Platte ohne Schneidenradius hätte. Anzeige und Programm beziehen sich auf diesen Punkt, " +
      "obwohl dort kein Material ist.",
    also: "Schneidenspitze",
  },
  cuttingPoint: {
    name: "Schneidpunkt",
    text:
      "Punkt, an dem die Rundung das Teil berührt. An Zylinder und Planfläche liegt er auf der Höhe der " +
      "theoretischen Schneidenspitze, an Kegeln und Kreisbögen nicht.",
  },
  tipOrientation: {
    name: "Werkzeugorientierung (TO)",
    text:
      "Lage der theoretischen Schneidenspitze zur Rundung, 1 bis 9. Sie legt fest, auf welcher Seite die " +
      "Schneidplatte schneidet.",
  },
  noseRadius: {
    name: "Schneidenradius (RS)",
    text: "Die Rundung der Schneidenecke. Er bleibt in scharfen Innenecken und bestimmt die Vorschubrillen.",
  },
  compensation: {
    name: "Schneidenradiuskorrektur",
    text:
      "Die Steuerung führt die Rundung, nicht die theoretische Schneidenspitze, an der Kontur. Ohne Korrektur " +
      "werden Kegel und Kreisbögen falsch.",
  },
  insert: {
    name: "Schneidplatte",
    text: "Die Wendeplatte, die schneidet, mit Form, Winkeln und Schneidenradius.",
    also: "Platte",
  },
  mainEdge: {
    name: "Hauptschneide",
    text: "Die Schneide neben der Rundung, die das meiste schneidet. Einer steileren Flanke kann sie nicht folgen.",
  },
  secondaryEdge: {
    name: "Nebenschneide",
    text: "Die Schneide hinter der Rundung. An fallenden Flanken muss sie frei vom Teil bleiben.",
  },
  edgeLength: {
    name: "Schneidenlänge (CUTLENGTH)",
    text:
      "Nutzbare Länge der Schneide. Bei einem tieferen Schnitt reibt der Halter. Beim Gewindewerkzeug: die " +
      "Zahnhöhe.",
  },
  holder: {
    name: "Halter",
    text: "Werkzeugkörper, der die Schneidplatte trägt. Er darf weder Teil noch Futter berühren.",
  },
  pass: {
    name: "Schnitt",
    text: "Ein Schruppschnitt auf einer Tiefe, von der Zustellung bis zum Abheben.",
    // Not the section view.
    where: "(?<![Ii]m )",
  },
  infeed: {
    name: "Zustellung",
    text: "Tiefe eines Schnitts gegenüber dem vorigen. Q463 ist das Maximum; die Tiefe wird gleichmäßig aufgeteilt.",
  },
  roughing: {
    name: "Schruppen",
    text: "Abtragen des meisten Materials in wenigen tiefen Schnitten, bis auf das Aufmaß.",
  },
  finishing: {
    name: "Schlichten",
    text: "Ein Schnitt entlang der Kontur auf Fertigmaß, mit kleiner Tiefe und kleinem Vorschub.",
  },
  setupClearance: {
    name: "Sicherheitsabstand (Q460)",
    text: "Abstand zum Material beim Vorpositionieren und Rückzugsweg vor der Rückfahrt im Eilgang.",
  },
  startPoint: {
    name: "Startpunkt",
    text: "Position der Schneidenspitze beim Zyklusaufruf, frei vom Material. Dort beginnt und endet der Zyklus.",
  },
  rapid: { name: "Eilgang", text: "Die schnellste Bewegung der Achsen. Sie darf nie Material berühren." },
  feedPerTurn: {
    name: "Vorschub pro Umdrehung (M136)",
    also: "Vorschub je Umdrehung",
    text:
      "Weg des Werkzeugs bei einer Spindelumdrehung. Spandicke und Oberfläche sind dann unabhängig von der " +
      "Drehzahl.",
  },
  cuttingSpeed: {
    name: "Schnittgeschwindigkeit",
    text:
      "Geschwindigkeit der Fläche an der Schneide, m/min: π · ⌀ · n / 1000. VCONST hält sie bei wechselndem " +
      "Durchmesser konstant.",
  },
  speedLimit: {
    name: "Drehzahlbegrenzung (SMAX)",
    text:
      "Die maximale Spindeldrehzahl. Nahe der Drehachse würde VCONST eine unendliche Drehzahl verlangen: Futter " +
      "und Teil bestimmen die Grenze.",
  },
  chip: {
    name: "Span",
    text:
      "Das abgetragene Material. Querschnitt ist Tiefe mal Vorschub; Kraft und Leistung wachsen mit dem " +
      "Querschnitt.",
  },
  cuttingForce: {
    name: "Spezifische Schnittkraft (kc)",
    text: "Kraft je mm² Spanquerschnitt. Bei dünnen Spänen ist sie größer als bei dicken.",
  },
  roughness: {
    name: "Rauheit (Rz)",
    text:
      "Höhe der Vorschubrillen. Der Schneidenradius ergibt etwa f² / (8 · r): halber Vorschub, ein Viertel der " +
      "Höhe.",
  },
  gouge: { name: "Konturverletzung", text: "Ein Schnitt in das Fertigteil. Er lässt sich nicht rückgängig machen." },
  airPass: { name: "Luftschnitt", text: "Ein Schnitt, der kein Material berührt." },
  plunging: {
    name: "Eintauchen",
    text:
      "An einer fallenden Flanke oder gerade nach unten ins Material schneiden. Q487 erlaubt das Eintauchen, Q488 " +
      "ist der Eintauchvorschub.",
  },
  limit: {
    name: "Schnittbegrenzung",
    also: "Bearbeitungsgrenze",
    text: "Ein Durchmesser (Q480) oder eine Z-Position (Q482), hinter der der Zyklus die Kontur nicht bearbeitet.",
  },
  program: { name: "Programm", text: "Die Sätze, die die Steuerung nacheinander abarbeitet." },
  block: {
    name: "Satz",
    text:
      "Eine nummerierte Zeile eines Programms, oder mehrere, die zusammengehören, wie ein Zyklus mit seinen " +
      "Parametern.",
  },
  cycle: {
    name: "Zyklus",
    text: "Eine Bearbeitung der Steuerung: Wenige Werte legen alle Schnitte fest.",
  },
  call: {
    name: "Zyklusaufruf",
    text:
      "M99, M89 oder CYCL CALL. Erst der Aufruf führt den definierten Zyklus aus, mit aktuellem Werkzeug und " +
      "Startpunkt.",
  },
  verdict: {
    name: "Prüfergebnis",
    text: "Ergebnis der Programmprüfung: geprüft, Fehler gefunden oder nicht vollständig simuliert.",
  },
};

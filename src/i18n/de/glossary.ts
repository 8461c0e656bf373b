import type { GlossaryTexts } from "../glossary-text.ts";

const UMLAUTS: Readonly<Record<string, string>> = { a: "ä", au: "äu", o: "ö", u: "ü" };

/** A noun with its endings, and its plural where that changes within: Satz, Sätze; Span, Späne; Zyklus, Zyklen. */
function formsOf(name: string): string {
  const umlauted = name.replace(/(au|[aou])(?=[^aeiouäöü]+$)/u, (vowel) => UMLAUTS[vowel] ?? vowel);
  return `(?:${name}(?:e[nsr]?|n|s|ern)?|${umlauted}en?|${name.replace(/us$/u, "en")})`;
}

export const glossary: GlossaryTexts = {
  words: { formsOf, capitals: true, apart: true },
  blank: {
    name: "Rohteil",
    text: "Das Material vor dem ersten Schnitt. BLK FORM nennt es; hier ein Zylinder, ein Rohr oder ein Umriss.",
  },
  stock: {
    name: "Rohmaterial",
    text: "Das Material in einem Augenblick: was die Schnitte bisher vom Rohteil übrig gelassen haben.",
  },
  finishedPart: { name: "Fertigteil", text: "Was stehen bleiben muss. Kein Schnitt darf es berühren." },
  residue: {
    name: "Restmaterial",
    text: "Material, das über der Kontur stehen bleibt, weil die Platte nicht hinkommt: in Ecken, hinter Flanken, an Grenzen.",
  },
  contour: {
    name: "Kontur",
    text: "Der Zug aus Strecken und Bögen, dem die fertige Fläche folgt, in Bearbeitungsrichtung.",
  },
  cornerElement: {
    name: "Fase, Rundung",
    text: "Was eine Ecke zwischen zwei Elementen bricht, oder die Kante am Anfang oder Ende eines Absatzes.",
  },
  shoulder: { name: "Absatz", text: "Ein Zylinder und eine Planfläche, die sich in einer Innenecke treffen." },
  face: { name: "Planfläche", text: "Eine Fläche rechtwinklig zur Achse. Gedreht wird sie in X." },
  recess: {
    name: "Einstich",
    text: "Ein Grund zwischen zwei Wänden. Stechdrehen fährt seitlich, Einstechen taucht nebeneinander ein.",
  },
  undercut: {
    name: "Freistich",
    text: "Eine Vertiefung unter dem Fertigmaß in der Ecke vor einer Planfläche, damit Gegenstück oder Schleifscheibe Platz haben.",
  },
  thread: {
    name: "Gewinde",
    text:
      "Eine Rille auf einer Schraubenlinie. Der Vorschub ist an die Drehung der Spindel gekoppelt, damit jeder " +
      "Schnitt dieselbe Rille trifft.",
  },
  pitch: {
    name: "Steigung",
    text: "Von einer Rille zur nächsten. Bei mehreren Gängen ist der Weg je Umdrehung so viele Teilungen lang.",
  },
  runIn: { name: "Anlauf", text: "Weg vor dem Gewinde, auf dem die Achse ihre Geschwindigkeit erreicht." },
  oversize: {
    name: "Aufmaß",
    text: "Was das Schruppen für das Schlichten stehen lässt: Q483 im Durchmesser, Q484 längs Z.",
  },
  workpieceZero: {
    name: "Werkstück-Nullpunkt",
    text: "Wo X0 und Z0 liegen. X0 ist die Spindelachse; Z0 liegt meist auf der fertigen Planfläche, das Teil auf der Minusseite.",
    also: "Nullpunkt",
  },
  diameter: {
    name: "Durchmesser (⌀)",
    text: "X wird als Durchmesser geschrieben. 2 mm in X bewegen das Werkzeug um 1 mm.",
  },
  radius: {
    name: "Auf den Radius (r)",
    text: "Tiefen quer zur Achse zählen nur auf einer Seite: 3 mm sind 6 mm im Durchmesser.",
  },
  theoreticalTip: {
    name: "Theoretische Schneidenspitze",
    text:
      "Die Ecke, die die Platte ohne Schneidenradius hätte. Die Steuerung zeigt und programmiert die Lage " +
      "dieses Punkts, obwohl dort kein Stahl ist.",
    also: "Schneidenspitze",
  },
  cuttingPoint: {
    name: "Schneidpunkt",
    text:
      "Wo die Rundung das Teil berührt. An Zylinder und Planfläche liegt er auf der Höhe der theoretischen Schneidenspitze, an " +
      "Kegeln und Bögen nicht.",
  },
  tipOrientation: {
    name: "Werkzeugorientierung (TO)",
    text: "Wo die theoretische Schneidenspitze neben der Rundung liegt, 1 bis 9. Danach weiß die Steuerung, wo die Platte schneidet.",
  },
  noseRadius: {
    name: "Schneidenradius (RS)",
    text: "Die Rundung der Schneidenecke. In scharfen Innenecken hinterlässt sie ihren eigenen Radius, und sie macht die Vorschubrillen.",
  },
  compensation: {
    name: "Schneidenradiuskorrektur",
    text:
      "Die Steuerung führt die Platte so, dass ihr Bogen die Kontur berührt und nicht die theoretische Schneidenspitze. " +
      "Ohne sie werden Kegel und Bögen falsch.",
  },
  insert: {
    name: "Schneidplatte",
    text: "Die Wendeplatte, die schneidet, mit Form, Winkeln und Schneidenradius.",
    also: "Platte",
  },
  mainEdge: {
    name: "Hauptschneide",
    text: "Die Schneide neben der Rundung, die das meiste schneidet. Einer Wand, die stärker geneigt ist, kann sie nicht folgen.",
  },
  secondaryEdge: {
    name: "Nebenschneide",
    text: "Die Schneide hinter der Rundung. An fallenden Flanken muss sie vom Teil freibleiben.",
  },
  edgeLength: {
    name: "Schneidenlänge (CUTLENGTH)",
    text: "Wie viel der Schneide schneiden darf. Ein tieferer Schnitt arbeitet mit dem Halter. Beim Gewindewerkzeug: die Höhe des Zahns.",
  },
  holder: { name: "Halter", text: "Was die Platte trägt. Er darf weder Teil noch Futter berühren." },
  pass: { name: "Schnitt", text: "Ein Schruppschnitt auf einer Tiefe, von der Zustellung bis zum Abheben." },
  infeed: {
    name: "Zustellung",
    text: "Um wie viel ein Schnitt tiefer liegt als der vorige. Q463 ist das Höchste; die Tiefe wird gleichmäßig geteilt.",
  },
  roughing: {
    name: "Schruppen",
    text: "Das meiste Material in wenigen tiefen Schnitten abtragen, bis auf das Aufmaß.",
  },
  finishing: {
    name: "Schlichten",
    text: "Ein Schnitt entlang der Kontur auf Maß, mit wenig Span und kleinem Vorschub.",
  },
  setupClearance: {
    name: "Sicherheitsabstand (Q460)",
    text: "Der Abstand, den ein Zyklus beim Vorpositionieren im Eilgang hält und um den er abhebt, bevor er im Eilgang zurückfährt.",
  },
  startPoint: {
    name: "Startpunkt",
    text: "Wo die Spitze beim Zyklusaufruf steht: in der Luft. Von dort zählt der Zyklus die Tiefe, dorthin kehrt er zurück.",
  },
  rapid: { name: "Eilgang", text: "Die schnellste Bewegung der Achsen. Sie darf nie Material berühren." },
  feedPerTurn: {
    name: "Vorschub je Umdrehung (M136)",
    text: "Wie weit das Werkzeug bei einer Umdrehung der Spindel fährt. Spandicke und Oberfläche hängen dann nicht von der Drehzahl ab.",
  },
  cuttingSpeed: {
    name: "Schnittgeschwindigkeit",
    text: "Wie schnell die Fläche an der Schneide vorbeiläuft, m/min: π · ⌀ · n / 1000. VCONST hält sie, während sich der Durchmesser ändert.",
  },
  speedLimit: {
    name: "Drehzahlbegrenzung (SMAX)",
    text:
      "Die höchste Drehzahl, die die Steuerung wählen darf. Nahe der Achse wollte VCONST eine unendliche: " +
      "Futter und Teil setzen die Grenze.",
  },
  chip: {
    name: "Span",
    text: "Was abgetragen wird: Tiefe mal Vorschub ist sein Querschnitt, Kraft und Leistung wachsen mit ihm.",
  },
  cuttingForce: {
    name: "Spezifische Schnittkraft (kc)",
    text: "Die Kraft für jeden mm² Span. Dünne Späne brauchen mehr davon als dicke.",
  },
  roughness: {
    name: "Rauheit (Rz)",
    text: "Höhe der Vorschubrillen. Der Radius allein lässt etwa f² / (8 · r): halber Vorschub, ein Viertel der Höhe.",
  },
  gouge: { name: "Konturverletzung", text: "Fertigteil, das eine Bewegung weggeschnitten hat. Es kommt nicht wieder." },
  airPass: { name: "Luftschnitt", text: "Ein Schnitt, der kein Material berührt." },
  plunging: {
    name: "Eintauchen",
    text: "An einer fallenden Flanke oder gerade nach unten ins Material schneiden. Q487 erlaubt es, Q488 gibt ihm einen eigenen Vorschub.",
  },
  limit: {
    name: "Bearbeitungsgrenze",
    text: "Ein Durchmesser (Q480) oder ein Ort längs Z (Q482), jenseits dessen der Zyklus nicht schneidet.",
  },
  program: { name: "Programm", text: "Was die Steuerung abarbeitet: Sätze, einer nach dem anderen." },
  block: {
    name: "Satz",
    text: "Eine nummerierte Zeile eines Programms, oder mehrere, die zusammengehören, wie ein Zyklus mit seinen Parametern.",
  },
  cycle: {
    name: "Zyklus",
    text: "Eine Bearbeitung, die die Steuerung kennt: Aus wenigen Werten plant sie alle Schnitte.",
  },
  call: {
    name: "Zyklusaufruf",
    text: "M99, M89 oder CYCL CALL. Erst hier bewegt der definierte Zyklus das Werkzeug, mit Werkzeug und Startpunkt dieses Augenblicks.",
  },
  verdict: {
    name: "Urteil",
    text: "Was der Nachweis eines Programms ergibt: bewiesen, Fehler gefunden, oder nicht alles simuliert.",
  },
};

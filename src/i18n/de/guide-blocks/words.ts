/** What each word of a block does, by its field, and what is often done wrong with it. */
export const blockWords = {
  name: {
    about: "Wie das Programm heißt.",
    mistakes: ["Leerzeichen oder Umlaute stehen darin: Manche Steuerung nimmt die Datei nicht."],
  },
  unit: {
    about: "MM oder INCH für alle Längen und Vorschübe des Programms.",
    mistakes: ["Werte werden zwischen Programmen verschiedener Einheit kopiert."],
  },
  toolAxis: {
    about: "Die Achse, in der das Werkzeug steht. Bei Drehteilen ist es Z.",
    mistakes: ["X oder Y ist aus einem Fräsprogramm stehen geblieben."],
  },
  "blankBox.X": {
    about: "X dieser Ecke. Um die Achse entscheidet die fernste Ecke.",
    mistakes: ["Der ⌀ ist getippt; Quader zählen von der Achse."],
  },
  "blankBox.Y": {
    about: "Y dieser Ecke. Um die Achse entscheidet die fernste Ecke.",
    mistakes: ["Der Quader liegt neben der Achse."],
  },
  "blankBox.Z": {
    about: "Z dieser Ecke: 0.1 das hintere Ende, 0.2 die Planfläche.",
    mistakes: ["Die Planfläche endet bei Z0, obwohl sie noch roh ist."],
  },
  outsideMeasure: {
    about: "Ob außen der ⌀ (D) oder der Radius (R) steht.",
    mistakes: ["R steht da, und ein ⌀ ist getippt: Das Rohteil ist doppelt so dick."],
  },
  insideMeasure: {
    about: "Ob für die Bohrung der ⌀ (DI) oder der Radius (RI) steht.",
    mistakes: ["RI steht da, und ein ⌀ ist getippt."],
  },
  measure: {
    about: "Ob X des Umrisses als ⌀ (DIM_D) oder als Radius (DIM_R) zählt.",
    mistakes: ["Der Umriss ist in Radien gezeichnet, und DIM_D steht da: Das Rohteil ist halb so dick."],
  },
  blankSource: {
    about: "Ob der Umriss hinter einem Label dieses Programms oder in einer Datei steht.",
    mistakes: ["Die Datei liegt nicht neben dem Programm."],
  },
  "blankRotation.label": {
    about: "Label mit dem Umriss des Rohteils.",
    mistakes: ["Es ist das Label der Fertigkontur: Es bleibt nichts zu schneiden."],
  },
  "turnBlank.label": {
    about: "Label mit dem geschlossenen Umriss dessen, was im Futter steckt.",
    mistakes: ["Der Umriss ist der des Fertigteils."],
  },
  file: {
    about: "Datei mit dem Umriss, samt Endung, oder ein QS-Parameter mit ihrem Namen.",
    mistakes: ["Davor steht der Pfad einer anderen Maschine."],
  },
  "selectContour.file": {
    about: "Datei mit der Kontur, samt Endung.",
    mistakes: ["Sie enthält ein ganzes Programm mit Positioniersätzen."],
  },
  "toolDefinition.tool": {
    about: "Nummer oder Name des Werkzeugs, das beschrieben wird.",
    mistakes: ["Es steht auch in der Werkzeugtabelle: Diese gilt."],
  },
  "toolDefinition.length": {
    about: "Länge des Werkzeugs über den Bezugspunkt hinaus.",
    mistakes: ["Die Länge eines anderen Halters steht noch da."],
  },
  toolRadius: {
    about: "Radius des Werkzeugs, für die Korrektur gefräster Konturen.",
    mistakes: ["Der ⌀ ist getippt."],
  },
  "toolCall.speed": {
    about: "Drehzahl einer Fräs- oder Bohrspindel. Beim Drehen entscheidet FUNCTION TURNDATA SPIN.",
    mistakes: ["Sie ist für das Drehteil gemeint: Dort tut sie nichts."],
  },
  "toolCall.feed": {
    about: "Vorschub für FAUTO und für Sätze ohne eigenen Vorschub.",
    mistakes: ["Er wird für den Vorschub eines Zyklus gehalten, der einen eigenen hat."],
  },
  deltaLength: {
    about: "Aufmaß der Länge, zu dem der Tabelle dazu.",
    mistakes: ["Es wird für Drehwerkzeuge benutzt: Dort tut es CORR-TCS."],
  },
  deltaRadius: {
    about: "Aufmaß des Radius: Mehr lässt an gefrästen Konturen Aufmaß stehen.",
    mistakes: ["Es ist vom Schruppen stehen geblieben."],
  },
  mode: {
    about: "TURN zum Drehen, MILL zum Fräsen.",
    mistakes: ["MILL hinter dem Drehen ist vergessen: X bleibt ein ⌀."],
  },
  kinematics: {
    about: "Name einer Kinematik der Maschine, wenn sie mehrere hat.",
    mistakes: ["Der Name einer anderen Maschine steht da."],
  },
  constantSurface: {
    about:
      "Ein: Die Schnittgeschwindigkeit wird gehalten, und die Drehzahl folgt dem ⌀. Aus: Die Drehzahl wird gehalten.",
    mistakes: [
      "Ein beim Gewinde: Die Steigung stimmt nur bei fester Drehzahl.",
      "Ein ohne SMAX: Zur Achse hin läuft sie davon.",
    ],
  },
  "turnCorrection.system": {
    about: "TCS: entlang des Werkzeugs. WPL: entlang des Teils.",
    mistakes: ["WPL ist gewählt, wo der Verschleiß des Werkzeugs gemeint ist."],
  },
  "turnCorrection.plane": {
    about: "Die Ebene, in der die Korrektur zählt: Z/X beim Drehen.",
    mistakes: ["X/Y ist vom Fräsen stehen geblieben."],
  },
  DZL: {
    about: "Um so viel länger zählt das Werkzeug in Z: Planflächen wandern nach +Z.",
    mistakes: ["Es wird für ein Aufmaß der Kontur gehalten."],
  },
  DXL: {
    about: "Um so viel länger zählt das Werkzeug in X, im Radius: Der ⌀ ändert sich um das Doppelte.",
    mistakes: ["Der Unterschied des ⌀ ist getippt."],
  },
  X: {
    about:
      "X des Endpunkts: beim Drehen ein ⌀, beim Fräsen eine Koordinate. Mit I zählt es von dort, wo das Werkzeug steht.",
    mistakes: ["Ein Radius ist getippt: Das Teil wird halb so dick.", "I bleibt an: Der Wert kommt dazu."],
  },
  Y: {
    about: "Y des Endpunkts. Beim Drehen bleibt es leer.",
    mistakes: ["Es ist vom Fräsen stehen geblieben: Beim Drehen tut es nichts."],
  },
  Z: {
    about: "Z des Endpunkts. Z0 ist meist die fertige Planfläche; das Teil liegt im Minus.",
    mistakes: ["Das Minus fehlt."],
  },
  axis: {
    about: "Eine weitere Achse der Maschine: Drehachsen in Grad, parallele in mm. Sie wird nicht simuliert.",
    mistakes: ["Sie dreht, während das Werkzeug im Schnitt ist."],
  },
  "CC.X": { about: "X des Mittelpunkts oder Pols, beim Drehen ein ⌀.", mistakes: ["Ein Radius ist getippt."] },
  "CC.Y": { about: "Y des Mittelpunkts oder Pols.", mistakes: ["Es bleibt leer: Der letzte gilt."] },
  "CC.Z": { about: "Z des Mittelpunkts oder Pols.", mistakes: ["Das Minus fehlt."] },
  "C.X": {
    about: "X des Endpunkts. Er muss auf dem Kreis um CC liegen.",
    mistakes: ["Es ist gerundet: Die Steuerung findet keinen Kreis."],
  },
  "C.Z": {
    about: "Z des Endpunkts. Er muss auf dem Kreis um CC liegen.",
    mistakes: ["Es ist gerundet: Die Steuerung findet keinen Kreis."],
  },
  "datum.X": {
    about: "Wie weit der Nullpunkt in X wandert; beim Drehen ein ⌀.",
    mistakes: ["Die Hälfte war gemeint."],
  },
  "datum.Y": { about: "Wie weit der Nullpunkt in Y wandert.", mistakes: ["Es ist vom Fräsen stehen geblieben."] },
  "datum.Z": {
    about: "Wie weit der Nullpunkt in Z wandert: Minus geht zum Futter.",
    mistakes: ["Es wird von der Verschiebung davor gezählt: Ein neuer Wert ersetzt den alten."],
  },
  polarRadius: {
    about: "Abstand vom Pol CC zum Endpunkt, in mm, kein ⌀.",
    mistakes: ["Der ⌀ des Kreises ist getippt."],
  },
  polarAngle: {
    about:
      "Richtung vom Pol aus, gezählt von der ersten Achse der Ebene: beim Drehen von +Z. Mit I von der " +
      "letzten Richtung aus.",
    mistakes: [
      "Er wird beim Drehen von X aus gezählt.",
      "I fehlt in einer Wiederholung: Alles liegt an derselben Stelle.",
    ],
  },
  radius: {
    about: "Radius des Bogens. Plus nimmt den Bogen unter 180°, Minus den größeren.",
    mistakes: ["DR ist andersherum: Aus der Kehle wird ein Bauch."],
  },
  "RND.radius": {
    about: "Radius der Rundung in der Ecke.",
    mistakes: ["Er ist kleiner als der Schneidenradius in einer Innenecke: Der Schneidenradius bleibt."],
  },
  turn: {
    about: "Der Drehsinn des Bogens, auf die Ebene gesehen: DR- im Uhrzeigersinn, DR+ dagegen.",
    mistakes: ["Er wird von unterhalb der Achse gelesen: Dort ist er andersherum."],
  },
  chamfer: { about: "Länge entlang jeder der beiden Kanten.", mistakes: ["Sie ist länger als eine Kante daneben."] },
  compensation: {
    about: "Wo das Werkzeug neben der Kontur läuft: RL links davon, RR rechts davon, R0 darauf.",
    mistakes: ["Sie wird im Schnitt eingeschaltet und nicht in der Luft.", "R0 am Ende fehlt."],
  },
  feed: {
    about:
      "Wie schnell dieser Satz und die dahinter fahren. FMAX gilt nur in seinem Satz, FAUTO nimmt den von TOOL CALL.",
    mistakes: ["Mit M136 ist ein Vorschub je Minute getippt.", "FMAX steht, wo das Werkzeug schneidet."],
  },
  functions: {
    about: "Mehrere M-Funktionen, mit Leerzeichen dazwischen.",
    mistakes: ["M3 und M4 sind verwechselt: Die Platte reibt mit dem Rücken."],
  },
  retract: {
    about: "Wie weit das Werkzeug in seiner Achse zurückfährt; MAX bis ans Ende des Verfahrwegs.",
    mistakes: ["Auf dem Rückweg steht etwas."],
  },
  length: { about: "Länge der Geraden.", mistakes: ["An ihrer Stelle ist die Koordinate getippt."] },
  centreAngle: { about: "Wie weit der Bogen herumgeht.", mistakes: ["Der Winkel des Endpunkts ist getippt."] },
  free: {
    about: "Ein Wert, den die Zeichnung von diesem Element gibt; jeder kann fehlen.",
    mistakes: ["Zu wenig ist gegeben: Es gibt mehrere Lösungen."],
  },
  CLSD: {
    about: "Beginnt (+) und beendet (−) eine geschlossene Kontur.",
    mistakes: ["Das Ende ist nicht gekennzeichnet."],
  },
  "undercut.form": {
    about: "Die genormte Form: E in den Zylinder, F in Zylinder und Planfläche, H, K, U oder die eines Gewindes.",
    mistakes: ["F, wo die Planfläche schon fertig ist."],
  },
  "groove.form": {
    about: "RADIAL in einen Zylinder, AXIAL in eine Planfläche.",
    mistakes: ["Die Form passt nicht zum Element davor."],
  },
  R: { about: "Radius in den Ecken am Grund.", mistakes: ["Er ist kleiner als der Schneidenradius."] },
  DEPTH: { about: "Wie tief es ins Material geht.", mistakes: ["Er ist als ⌀ getippt."] },
  BREADTH: { about: "Wie breit es entlang seines Elements ist.", mistakes: ["Er ist schmaler als die Platte."] },
  ANGLE: {
    about: "Wie steil die Flanke ansteigt.",
    mistakes: ["Er ist steiler, als die Schneide der Platte folgen kann."],
  },
  "groove.DEPTH": {
    about:
      "Tiefe des Einstichs; das Vorzeichen sagt, auf welcher Seite des Elements er liegt: negativ nach −X oder −Z.",
    mistakes: ["Sie ist als ⌀ getippt."],
  },
  "groove.ANGLE": {
    about: "Flankenwinkel: Winkel jeder Flanke gegen die Senkrechte zum Element, an Stelle von ANG_WIDTH.",
    mistakes: ["Der Öffnungswinkel zwischen beiden Flanken ist getippt: Das ist ANG_WIDTH."],
  },
  ANG_WIDTH: {
    about: "Öffnungswinkel zwischen beiden Flanken, an Stelle von ANGLE.",
    mistakes: ["Der Winkel einer Flanke ist getippt: Der Einstich öffnet sich dann nur halb so weit."],
  },
  FACEDEPTH: {
    about: "Wie tief der Freistich in die Planfläche geht.",
    mistakes: ["Es fehlt, und der Wert der Norm gilt."],
  },
  FACEANGLE: {
    about: "Wie steil er aus der Planfläche herauskommt.",
    mistakes: ["Er wird von der Achse aus gemessen."],
  },
  ROT: {
    about: "Um wie viel der Freistich gedreht ist.",
    mistakes: ["45° sind üblich; das Vorzeichen dreht ihn in die Wand."],
  },
  "rotation.ROT": {
    about: "Winkel, um den die Ebene gedreht wird, gegen den Uhrzeigersinn positiv.",
    mistakes: ["Er ist bei der nächsten Form noch an."],
  },
  PITCH: {
    about: "Steigung des Gewindes, zu dem der Freistich gehört: Die Tabelle gibt seine Maße.",
    mistakes: ["Der ⌀ des Gewindes ist getippt."],
  },
  CENTER: {
    about: "Wo die Mitte des Einstichs liegt: Z auf einem Zylinder, ⌀ auf einer Planfläche.",
    mistakes: ["Eine Kante des Einstichs ist getippt."],
  },
  DIAM: { about: "⌀ des Grundes, an Stelle der Tiefe.", mistakes: ["Tiefe und ⌀ sind beide gegeben."] },
  RND: { about: "Radius an der äußeren Kante.", mistakes: ["RND und CHF sind beide gegeben."] },
  CHF: { about: "Fase an der äußeren Kante.", mistakes: ["RND und CHF sind beide gegeben."] },
  FAR_RND: {
    about: "Radius an der fernen äußeren Kante, wenn er anders ist.",
    mistakes: ["Ferne und nahe Kante sind vertauscht."],
  },
  FAR_CHF: {
    about: "Fase an der fernen äußeren Kante, wenn sie anders ist.",
    mistakes: ["Ferne und nahe Kante sind vertauscht."],
  },
  label: { about: "Nummer oder Name der Stelle.", mistakes: ["Dieselbe Nummer steht zweimal."] },
  "call.label": {
    about: "Welches Label gerufen wird.",
    mistakes: ["Es ist das Label einer Kontur: Sie läuft als Bahn."],
  },
  repeat: {
    about: "Wie oft der Teil noch einmal läuft, nach dem ersten Mal.",
    mistakes: ["Es ist eins zu viel: Der erste Lauf zählt nicht mit."],
  },
  "contour.cycleLine": {
    about: "Die Label mit der Kontur, durch / getrennt.",
    mistakes: ["Das Label des Rohteils steht da."],
  },
  cycleLine: {
    about: "Was hinter der Nummer der Zeile steht.",
    mistakes: ["Es gehört zu einer anderen Zeile des Zyklus."],
  },
  how: {
    about: "An dieser Stelle; an Positionen (POS); oder an jedem Punkt eines Musters (PAT).",
    mistakes: ["PAT ohne ein Muster davor."],
  },
  SCL: { about: "Faktor: 1 ist dieselbe Größe.", mistakes: ["Ein Prozentwert ist getippt."] },
  target: { about: "Der Parameter, der den Wert bekommt.", mistakes: ["Q100 bis Q199 gehören der Steuerung."] },
  formula: {
    about: "Eine Zahl, ein Parameter oder eine Rechnung mit + − * / und Funktionen.",
    mistakes: ["Winkel zählen in Grad: SIN 30 ist 0.5."],
  },
  text: { about: "Was im Satz steht, als Text.", mistakes: ["Ein Strichpunkt beginnt einen Kommentar."] },
  parameter: {
    about: "Ein Wert eines Zyklus, der hier erhalten bleibt. Was er bedeutet, steht im Handbuch der Steuerung.",
    mistakes: ["Er wird geändert im Glauben, das Bild folge."],
  },
};

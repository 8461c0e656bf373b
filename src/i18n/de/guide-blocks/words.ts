/** Function of each word of a block, by its field, and common mistakes. */
export const blockWords = {
  name: {
    about: "Name des Programms.",
    mistakes: ["Enthält Leerzeichen oder Umlaute: Manche Steuerungen lehnen die Datei ab."],
  },
  unit: {
    about: "MM oder INCH für alle Längen und Vorschübe des Programms.",
    mistakes: ["Werte werden zwischen Programmen verschiedener Einheit kopiert."],
  },
  toolAxis: {
    about: "Werkzeugachse. Beim Drehen Z.",
    mistakes: ["X oder Y aus einem Fräsprogramm übernommen."],
  },
  "blankBox.X": {
    about: "X dieser Ecke. Beim Drehen entscheidet die am weitesten entfernte Ecke.",
    mistakes: ["⌀ eingegeben; Quader werden von der Drehachse gemessen."],
  },
  "blankBox.Y": {
    about: "Y dieser Ecke. Beim Drehen entscheidet die am weitesten entfernte Ecke.",
    mistakes: ["Der Quader liegt neben der Drehachse."],
  },
  "blankBox.Z": {
    about: "Z dieser Ecke: 0.1 das hintere Ende, 0.2 die Planfläche.",
    mistakes: ["Die Planfläche endet bei Z0, obwohl sie unbearbeitet ist."],
  },
  outsideMeasure: {
    about: "Außen als ⌀ (D) oder Radius (R).",
    mistakes: ["R mit eingegebenem ⌀: Das Rohteil ist doppelt so dick."],
  },
  insideMeasure: {
    about: "Bohrung als ⌀ (DI) oder Radius (RI).",
    mistakes: ["RI mit eingegebenem ⌀."],
  },
  measure: {
    about: "X des Umrisses als ⌀ (DIM_D) oder Radius (DIM_R).",
    mistakes: ["DIM_D bei Umriss in Radiuswerten: Das Rohteil ist halb so dick."],
  },
  blankSource: {
    about: "Umriss in einem Label dieses Programms oder in einer Datei.",
    mistakes: ["Die Datei liegt nicht im Ordner des Programms."],
  },
  "blankRotation.label": {
    about: "Label mit dem Umriss des Rohteils.",
    mistakes: ["Label der Fertigkontur eingegeben: Es gibt nichts zu zerspanen."],
  },
  "turnBlank.label": {
    about: "Label mit dem geschlossenen Umriss des gespannten Materials.",
    mistakes: ["Umriss des Fertigteils verwendet."],
  },
  file: {
    about: "Datei mit dem Umriss, samt Endung, oder ein QS-Parameter mit ihrem Namen.",
    mistakes: ["Pfad einer anderen Maschine enthalten."],
  },
  "selectContour.file": {
    about: "Datei mit der Kontur, samt Endung.",
    mistakes: ["Die Datei ist ein ganzes Programm mit Positioniersätzen."],
  },
  "toolDefinition.tool": {
    about: "Nummer oder Name des definierten Werkzeugs.",
    mistakes: ["Das Werkzeug ist auch in der Werkzeugtabelle: Diese gilt."],
  },
  "toolDefinition.length": {
    about: "Werkzeuglänge ab dem Bezugspunkt.",
    mistakes: ["Länge eines anderen Halters übernommen."],
  },
  toolRadius: {
    about: "Radius des Werkzeugs, für die Korrektur gefräster Konturen.",
    mistakes: ["⌀ eingegeben."],
  },
  "toolCall.speed": {
    about: "Drehzahl einer Fräs- oder Bohrspindel. Beim Drehen gilt FUNCTION TURNDATA SPIN.",
    mistakes: ["Zum Drehen verwendet: dort ohne Wirkung."],
  },
  "toolCall.feed": {
    about: "Vorschub für FAUTO und für Sätze ohne eigenen Vorschub.",
    mistakes: ["Mit dem Vorschub eines Zyklus verwechselt, der einen eigenen Vorschub hat."],
  },
  deltaLength: {
    about: "Aufmaß der Länge, zusätzlich zur Tabelle.",
    mistakes: ["Für Drehwerkzeuge verwendet: dort CORR-TCS verwenden."],
  },
  deltaRadius: {
    about: "Aufmaß des Radius: Ein positiver Wert lässt an gefrästen Konturen Aufmaß.",
    mistakes: ["Vom Schruppen übernommen."],
  },
  mode: {
    about: "TURN zum Drehen, MILL zum Fräsen.",
    mistakes: ["MILL nach dem Drehen fehlt: X bleibt ein ⌀."],
  },
  kinematics: {
    about: "Name der Maschinenkinematik, falls mehrere vorhanden.",
    mistakes: ["Name einer anderen Maschine eingegeben."],
  },
  constantSurface: {
    about: "Ein: konstante Schnittgeschwindigkeit, die Drehzahl folgt dem ⌀. Aus: konstante Drehzahl.",
    mistakes: [
      "Ein beim Gewinde: Die Steigung stimmt nur bei konstanter Drehzahl.",
      "Ein ohne SMAX: Zur Drehachse hin ist die Drehzahl unbegrenzt.",
    ],
  },
  "turnCorrection.system": {
    about: "TCS: entlang des Werkzeugs. WPL: entlang des Teils.",
    mistakes: ["WPL für Werkzeugverschleiß verwendet."],
  },
  "turnCorrection.plane": {
    about: "Ebene der Korrektur: Z/X beim Drehen.",
    mistakes: ["X/Y vom Fräsen übernommen."],
  },
  DZL: {
    about: "Längenaufmaß in Z: Ein positiver Wert verschiebt Planflächen nach +Z.",
    mistakes: ["Mit einem Aufmaß der Kontur verwechselt."],
  },
  DXL: {
    about: "Längenaufmaß in X, auf den Radius: Der ⌀ ändert sich um das Doppelte.",
    mistakes: ["Differenz des ⌀ eingegeben."],
  },
  X: {
    about:
      "X des Endpunkts: beim Drehen ein ⌀, beim Fräsen eine Koordinate. Mit I: inkremental ab der aktuellen Position.",
    mistakes: ["Radius eingegeben: Das Teil wird halb so dick.", "I bleibt aktiv: Der Wert wird addiert."],
  },
  Y: {
    about: "Y des Endpunkts. Beim Drehen leer.",
    mistakes: ["Vom Fräsen übernommen: beim Drehen ohne Wirkung."],
  },
  Z: {
    about: "Z des Endpunkts. Z0 ist meist die fertige Planfläche; das Teil liegt auf der Minusseite.",
    mistakes: ["Das Minuszeichen fehlt."],
  },
  axis: {
    about: "Zusätzliche Maschinenachse: Drehachsen in Grad, Parallelachsen in mm. Nicht simuliert.",
    mistakes: ["Die Achse bewegt sich, während das Werkzeug schneidet."],
  },
  "CC.X": { about: "X des Mittelpunkts oder Pols, beim Drehen ein ⌀.", mistakes: ["Radius eingegeben."] },
  "CC.Y": { about: "Y des Mittelpunkts oder Pols.", mistakes: ["Leer: Der letzte Wert gilt."] },
  "CC.Z": { about: "Z des Mittelpunkts oder Pols.", mistakes: ["Das Minuszeichen fehlt."] },
  "C.X": {
    about: "X des Endpunkts. Er muss auf dem Kreis um CC liegen.",
    mistakes: ["Gerundeter Wert: Der Punkt liegt nicht auf dem Kreis."],
  },
  "C.Z": {
    about: "Z des Endpunkts. Er muss auf dem Kreis um CC liegen.",
    mistakes: ["Gerundeter Wert: Der Punkt liegt nicht auf dem Kreis."],
  },
  "datum.X": {
    about: "Nullpunktverschiebung in X; beim Drehen ein ⌀.",
    mistakes: ["Radius eingegeben."],
  },
  "datum.Y": { about: "Nullpunktverschiebung in Y.", mistakes: ["Vom Fräsen übernommen."] },
  "datum.Z": {
    about: "Nullpunktverschiebung in Z: negativ zum Futter.",
    mistakes: ["Für relativ zur vorigen Verschiebung gehalten: Ein neuer Wert ersetzt den alten."],
  },
  polarRadius: {
    about: "Abstand vom Pol CC zum Endpunkt, in mm, kein ⌀.",
    mistakes: ["⌀ des Kreises eingegeben."],
  },
  polarAngle: {
    about:
      "Richtung vom Pol aus, gemessen von der ersten Achse der Ebene: beim Drehen von +Z. Mit I: von der letzten " +
      "Richtung.",
    mistakes: ["Beim Drehen von X aus gemessen.", "I fehlt in einer Wiederholung: Alles liegt an derselben Stelle."],
  },
  radius: {
    about: "Radius des Kreisbogens. Positiv: Bogen unter 180°; negativ: der größere.",
    mistakes: ["Falsches DR: Aus konkav wird konvex."],
  },
  "RND.radius": {
    about: "Radius der Rundung in der Ecke.",
    mistakes: ["Kleiner als der Schneidenradius in einer Innenecke: Der Schneidenradius bleibt."],
  },
  turn: {
    about: "Drehsinn, auf die Ebene gesehen: DR- im Uhrzeigersinn, DR+ gegen den Uhrzeigersinn.",
    mistakes: ["Von unterhalb der Drehachse gesehen: Der Drehsinn ist umgekehrt."],
  },
  chamfer: { about: "Länge entlang jeder der beiden Kanten.", mistakes: ["Länger als eine angrenzende Kante."] },
  compensation: {
    about: "Werkzeug zur programmierten Kontur: RL links, RR rechts, R0 auf der Kontur.",
    mistakes: ["Im Schnitt aktiviert statt frei vom Material.", "R0 am Ende fehlt."],
  },
  feed: {
    about:
      "Vorschub dieses und der folgenden Sätze. FMAX gilt nur im Satz, FAUTO übernimmt den Vorschub aus TOOL CALL.",
    mistakes: ["Mit M136 Vorschub pro Minute eingegeben.", "FMAX im Schnitt verwendet."],
  },
  functions: {
    about: "Mehrere M-Funktionen, durch Leerzeichen getrennt.",
    mistakes: ["M3 und M4 vertauscht: Der Rücken der Schneidplatte reibt."],
  },
  retract: {
    about: "Rückzugsweg in der Werkzeugachse; MAX: bis zur Verfahrgrenze.",
    mistakes: ["Hindernis im Rückzugsweg."],
  },
  length: { about: "Länge der Geraden.", mistakes: ["Koordinate statt Länge eingegeben."] },
  centreAngle: { about: "Mittelpunktswinkel des Kreisbogens.", mistakes: ["Winkel des Endpunkts eingegeben."] },
  free: {
    about: "Ein Wert dieses Elements aus der Zeichnung; optional.",
    mistakes: ["Zu wenige Angaben: mehrere Lösungen."],
  },
  CLSD: {
    about: "Beginnt (+) und beendet (−) eine geschlossene Kontur.",
    mistakes: ["Die Endekennung fehlt."],
  },
  "undercut.form": {
    about: "Die genormte Form: E in den Zylinder, F in Zylinder und Planfläche, H, K, U oder die eines Gewindes.",
    mistakes: ["F, obwohl die Planfläche schon fertig ist."],
  },
  "groove.form": {
    about: "RADIAL in einen Zylinder, AXIAL in eine Planfläche.",
    mistakes: ["Die Form passt nicht zum vorigen Element."],
  },
  R: { about: "Radius in den Ecken am Grund.", mistakes: ["Kleiner als der Schneidenradius."] },
  DEPTH: { about: "Tiefe im Material.", mistakes: ["Als ⌀ eingegeben."] },
  BREADTH: { about: "Breite entlang des Elements.", mistakes: ["Schmaler als die Schneidplatte."] },
  ANGLE: {
    about: "Winkel der Flanke.",
    mistakes: ["Steiler, als die Schneide folgen kann."],
  },
  "groove.DEPTH": {
    about: "Tiefe des Einstichs; das Vorzeichen bestimmt die Seite des Elements: negativ nach −X oder −Z.",
    mistakes: ["Als ⌀ eingegeben."],
  },
  "groove.ANGLE": {
    about: "Flankenwinkel: Winkel jeder Flanke gegen die Senkrechte zum Element, anstelle von ANG_WIDTH.",
    mistakes: ["Öffnungswinkel zwischen beiden Flanken eingegeben: ANG_WIDTH verwenden."],
  },
  ANG_WIDTH: {
    about: "Öffnungswinkel zwischen beiden Flanken, anstelle von ANGLE.",
    mistakes: ["Winkel einer Flanke eingegeben: Der Einstich ist nur halb so weit geöffnet."],
  },
  FACEDEPTH: {
    about: "Tiefe des Freistichs in der Planfläche.",
    mistakes: ["Nicht eingegeben: Der Wert der Norm gilt."],
  },
  FACEANGLE: {
    about: "Austrittswinkel aus der Planfläche.",
    mistakes: ["Von der Drehachse gemessen."],
  },
  ROT: {
    about: "Drehung des Freistichs.",
    mistakes: ["45° sind üblich; ein falsches Vorzeichen dreht ihn in die Flanke."],
  },
  "rotation.ROT": {
    about: "Drehwinkel der Ebene, gegen den Uhrzeigersinn positiv.",
    mistakes: ["Bei der nächsten Form noch aktiv."],
  },
  PITCH: {
    about: "Steigung des Gewindes: Die Maße kommen aus der Tabelle.",
    mistakes: ["⌀ des Gewindes eingegeben."],
  },
  CENTER: {
    about: "Mitte des Einstichs: Z auf einem Zylinder, ⌀ auf einer Planfläche.",
    mistakes: ["Kante des Einstichs eingegeben."],
  },
  DIAM: { about: "⌀ des Grundes, anstelle der Tiefe.", mistakes: ["Tiefe und ⌀ beide eingegeben."] },
  RND: { about: "Radius an der äußeren Kante.", mistakes: ["RND und CHF beide eingegeben."] },
  CHF: { about: "Fase an der äußeren Kante.", mistakes: ["RND und CHF beide eingegeben."] },
  FAR_RND: {
    about: "Radius an der fernen Außenkante, falls abweichend.",
    mistakes: ["Ferne und nahe Kante vertauscht."],
  },
  FAR_CHF: {
    about: "Fase an der fernen Außenkante, falls abweichend.",
    mistakes: ["Ferne und nahe Kante vertauscht."],
  },
  label: { about: "Nummer oder Name des Labels.", mistakes: ["Nummer doppelt verwendet."] },
  "call.label": {
    about: "Aufzurufendes Label.",
    mistakes: ["Label einer Kontur aufgerufen: Sie läuft als Bahn."],
  },
  repeat: {
    about: "Zahl der Wiederholungen nach dem ersten Lauf.",
    mistakes: ["Eins zu viel: Der erste Lauf zählt nicht mit."],
  },
  "contour.cycleLine": {
    about: "Label mit der Kontur, durch / getrennt.",
    mistakes: ["Label des Rohteils eingegeben."],
  },
  cycleLine: {
    about: "Inhalt nach der Zeilennummer.",
    mistakes: ["Der Wert gehört zu einer anderen Zeile des Zyklus."],
  },
  how: {
    about: "An der aktuellen Position; an Positionen (POS); oder an jedem Punkt eines Musters (PAT).",
    mistakes: ["PAT ohne ein Muster davor."],
  },
  SCL: { about: "Maßfaktor: 1 ist die Originalgröße.", mistakes: ["Prozentwert eingegeben."] },
  target: { about: "Parameter für das Ergebnis.", mistakes: ["Q100 bis Q199 sind für die Steuerung reserviert."] },
  formula: {
    about: "Eine Zahl, ein Parameter oder eine Rechnung mit + − * / und Funktionen.",
    mistakes: ["Winkel in Grad: SIN 30 ist 0.5."],
  },
  text: { about: "Inhalt des Satzes als Text.", mistakes: ["Ein Semikolon beginnt einen Kommentar."] },
  parameter: {
    about: "Ein Wert eines Zyklus, der erhalten bleibt, aber nicht simuliert wird. Siehe Handbuch der Steuerung.",
    mistakes: ["Geändert in der Annahme, dass die Simulation folgt."],
  },
};

import type { MistakesTexts } from "../mistakes-text.ts";

export const mistakes: MistakesTexts = {
  kinds: {
    choice: ["Eine Zahl wird aus einem anderen Programm übernommen, ohne ihre Bedeutung in diesem Zyklus zu prüfen."],
    diameter: [
      "Radius statt Durchmesser eingegeben: Das Teil wird halb so dick.",
      "Vorzeichen und Seite der Drehachse verwechselt: X ist normalerweise positiv.",
    ],
    oversizeDiameter: ["Als Wert je Seite verstanden: Auf jeder Seite bleibt nur die Hälfte."],
    radial: ["Als Durchmesser verstanden: Der Schnitt wird doppelt so tief wie gewollt."],
    axial: ["Das Minuszeichen fehlt: Vor Z0 ist kein Teil."],
    axialDepth: ["Negativer Wert eingegeben: Tiefen sind positiv, die Richtung folgt aus der Kontur."],
    length: ["Absolute Koordinate statt einer Länge eingegeben."],
    angle: [
      "Der Winkel wird von der falschen Achse aus gemessen.",
      "Die Flanke ist steiler, als die Schneide folgen kann: Restmaterial bleibt.",
    ],
    feed: [
      "M136 fehlt: 0,2 heißt dann 0,2 mm pro Minute, und das Werkzeug scheint zu stehen.",
      "Vorschub pro Minute eingegeben, obwohl M136 aktiv ist.",
    ],
    count: ["Die Zahl ist viel zu groß: minutenlang Luftschnitte."],
    factor: ["Prozentwert statt Faktor eingegeben: 80 % sind 0,8."],
    percent: ["Faktor statt Prozentwert eingegeben: 0,8 ist weniger als ein Prozent."],
    revolutions: ["Für Sekunden gehalten: Die Zeit hängt von der Drehzahl ab."],
  },
  of: {
    operation: [
      "0 trotz eigenem Schlichtwerkzeug: Die Schruppplatte schlichtet mit.",
      "2 gewählt, ohne vorher zu schruppen: Die ganze Tiefe wird in einem Schnitt zerspant.",
    ],
    clearance: [
      "0 oder sehr wenig: Das Werkzeug fährt im Eilgang bis ans Material, und trifft ein etwas größeres Rohteil.",
      "So groß, dass der Startpunkt im Sicherheitsabstand liegt: Das Werkzeug fährt zuerst weg.",
    ],
    clearanceReserved: ["Für mehr Abstand geändert: hier ohne Wirkung. Stattdessen den Startpunkt ändern."],
    startDiameter: [
      "Aus Versehen kleiner als der Enddurchmesser: Die Steuerung bearbeitet dann eine Bohrung.",
      "Kleiner als das Rohteil: Vor der Kontur bleibt ein Ring, und der erste Schnitt wird zu tief.",
    ],
    endDiameter: [
      "Start und Ende sind gleich: Es gibt nichts zu zerspanen.",
      "Fertigmaß mit Aufmaß eingegeben: Q483 kommt noch einmal dazu.",
    ],
    startZ: ["Z0 liegt auf der unbearbeiteten Planfläche, die später gedreht wird: Alle Längen werden zu kurz."],
    endZ: [
      "Länge des Absatzes ohne Vorzeichen eingegeben.",
      "Futter und Backen nicht beachtet: Das Ende liegt dahinter.",
    ],
    surfaceAngle: [
      "Halber und ganzer Kegelwinkel verwechselt: Einzugeben ist der Winkel zur Drehachse, also der halbe.",
    ],
    faceAngle: ["Winkel von der Drehachse gemessen; er zählt von der rechtwinkligen Planfläche."],
    flankAngle: ["Flanken vertauscht: Q495 gehört zum Konturstart, Q496 zum Konturende."],
    secondFlankAngle: ["Flanken vertauscht: Q495 gehört zum Konturstart, Q496 zum Konturende."],
    startElement: [
      "Typ 0, obwohl Q502 eine Größe hat: keine Fase, kein Radius.",
      "Fase gewählt, obwohl die Zeichnung einen Radius hat.",
    ],
    startElementSize: ["Das Element ist länger als die angrenzende Flanke."],
    endElement: ["Typ 0, obwohl Q504 eine Größe hat: keine Fase, kein Radius."],
    endElementSize: ["Die Fase am Ende liegt auf dem Rohdurchmesser: Bei größerem Rohteil fehlt die Kante."],
    cornerRadius: [
      "Kleiner als der Schneidenradius: Die Ecke behält den Schneidenradius, Restmaterial bleibt.",
      "Auch für die Außenkanten verwendet: Dafür gelten Q502 und Q504.",
    ],
    infeedRadial: [
      "Für die tatsächliche Zustellung gehalten: Die Tiefe wird gleichmäßig aufgeteilt, die Zustellung ist oft " +
        "kleiner.",
      "Mehr als ein Drittel der Schneidenlänge: Die Platte wird überlastet.",
      "Verdoppelt, weil sich der Durchmesser um das Doppelte ändert.",
    ],
    infeedAxial: [
      "Radialer Wert vom Längsdrehen übernommen: Hier erfolgt die Zustellung in Z.",
      "0 für „nicht schruppen“ eingegeben: 0 heißt alles in einem Schnitt.",
    ],
    infeedGroove: [
      "So groß wie die Einstichtiefe: Der Span kommt nicht heraus.",
      "Für einen Durchmesser gehalten: In der Planfläche erfolgt die Zustellung in Z.",
    ],
    roughingFeed: [
      "Mehr als 0,8 des Schneidenradius: Die Schneide bricht aus, die Fläche sieht aus wie ein Gewinde.",
      "So klein, dass der Span nicht bricht.",
    ],
    finishingFeed: [
      "Vorschub Schruppen übernommen: Rz wächst mit dem Quadrat des Vorschubs.",
      "Sehr kleiner Vorschub für eine glatte Fläche: Unter der Mindestspandicke reibt die Schneide nur.",
    ],
    oversizeZ: [
      "0, obwohl Q483 gesetzt ist: Der Schlichtschnitt reibt an der Planfläche, ohne zu schneiden.",
      "Größer, als es der Schneidenradius in der Ecke erlaubt: Beim Schlichten bleibt zu viel Material.",
    ],
    smoothing: [
      "2 gewählt, um Zeit zu sparen: Durch die Stufen schwankt die Schnitttiefe beim Schlichten.",
      "Andere Fertigkontur erwartet: Nur der Weg zwischen den Schnitten ändert sich.",
    ],
    plunging: [
      "1, obwohl die Schneidplatte für fallende Flanken keinen Freiwinkel hat: Die Nebenschneide reibt.",
      "0 gesetzt: Der Freistich wird nicht bearbeitet, ohne Meldung.",
    ],
    plungingFeed: [
      "0 für „kein Vorschub“ eingegeben: 0 heißt Vorschub Schruppen.",
      "So groß wie der Vorschub Schruppen, obwohl die Schneide in voller Breite schneidet.",
    ],
    limits: ["1 gesetzt, aber Q480 und Q482 haben die Werte eines anderen Teils."],
    limitDiameter: ["Auf der falschen Seite der Kontur: Es gibt nichts zu zerspanen."],
    limitZ: ["Das Vorzeichen fehlt, die ganze Kontur liegt hinter der Grenze."],
    reverseContour: [
      "2 gewählt ohne ein Werkzeug, das in der anderen Richtung schneidet.",
      "Kontur rückwärts programmiert und hier noch einmal umgekehrt: Beides hebt sich auf.",
    ],
    direction: ["Beide Richtungen (0) mit einem Stechwerkzeug, das nur in eine Richtung schneiden darf."],
    offsetWidth: [
      "Mehr als 80 % der wirksamen Schneidenbreite: Stege blieben stehen, die Steuerung stoppt.",
      "0: Die Schneidenecke reibt bei jedem Schnitt an der Flanke.",
    ],
    depthCompensation: [
      "Positiver Wert für einen tieferen Einstich: Positiv bleibt über dem Grund.",
      "Zur Korrektur einer falschen Werkzeuglänge verwendet: Werkzeugtabelle korrigieren.",
    ],
    blankAllowance: ["Schlichtaufmaß eingegeben: Gefragt ist das Aufmaß des Rohteils auf der Kontur."],
    threadPitch: ["Bei mehreren Gängen die Teilung statt der Steigung eingegeben."],
    threadDepth: ["0 für „kein Gewinde“ eingegeben: Die Steuerung berechnet dann die Tiefe aus der Steigung."],
    firstInfeed: ["Für die Zustellung jedes Schnitts gehalten: Spätere Zustellungen sind kleiner."],
    infeedAngle: ["Mehr als der halbe Gewindewinkel: Die Schneidplatte verletzt die fertige Flanke."],
    threadStarts: ["Zahl der Schnitte eingegeben: Gefragt ist die Zahl der Gewindegänge."],
    airCuts: ["Zahl der Schnitte eingegeben: Leerschnitte sind zusätzliche Schnitte auf Fertigtiefe."],
    threadRunIn: ["Zu kurz für die Drehzahl: Am Gewindestart hat die Achse den Vorschub noch nicht erreicht."],
    recessingOverlap: ["Breite eines Stichs in mm statt des Faktors der Schneidenbreite eingegeben."],
    plungeLimit: ["0 für „nicht einstechen“ eingegeben: 0 heißt in einem Stich auf volle Tiefe."],
    dwellTurns: ["Zu lange Verweilzeit: Die Schneide reibt und härtet die Fläche."],
  },
};

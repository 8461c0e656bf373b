import type { MistakesTexts } from "../mistakes-text.ts";

export const mistakes: MistakesTexts = {
  kinds: {
    choice: [
      "Eine Zahl wird aus einem anderen Programm übernommen, ohne nachzusehen, was sie in diesem Zyklus bedeutet.",
    ],
    diameter: [
      "Ein Radius wird eingegeben, wo die Steuerung einen Durchmesser will: Das Teil wird halb so dick.",
      "Vorzeichen und Seite der Achse werden verwechselt: Bei einem gewöhnlichen Teil ist X positiv.",
    ],
    oversizeDiameter: ["Der Wert wird je Seite verstanden: Auf jeder Seite bleibt nur die Hälfte stehen."],
    radial: ["Der Wert wird als Durchmesser verstanden: Der Schnitt wird doppelt so tief wie gedacht."],
    axial: ["Das Minus wird vergessen: Vor Z0 ist kein Teil."],
    axialDepth: ["Ein Minus wird eingegeben: Tiefen sind positiv, die Richtung folgt aus der Kontur."],
    length: ["Eine absolute Koordinate wird eingegeben, wo eine Länge gefragt ist."],
    angle: [
      "Der Winkel wird von der falschen Achse aus gemessen.",
      "Eine Flanke wird verlangt, die steiler ist, als die Schneide folgen kann: Material bleibt stehen.",
    ],
    feed: [
      "M136 fehlt: 0,2 heißt dann 0,2 mm in der Minute, und das Werkzeug scheint zu stehen.",
      "Ein Vorschub je Minute wird eingegeben, während M136 wirkt.",
    ],
    count: ["Die Zahl ist viel größer als nötig, und der Zyklus fährt minutenlang in der Luft."],
    factor: ["Ein Prozentwert wird statt eines Anteils eingegeben: 80 % sind 0,8."],
    percent: ["Ein Anteil wird statt eines Prozentwerts eingegeben: 0,8 ist weniger als ein Prozent."],
    revolutions: ["Der Wert wird für Sekunden gehalten: Die Zeit hängt von der Drehzahl ab."],
  },
  of: {
    operation: [
      "0 bleibt stehen, obwohl es ein eigenes Schlichtwerkzeug gibt: Die Schruppplatte schlichtet mit.",
      "2 wird gewählt, ohne dass geschruppt wurde: Die ganze Tiefe fällt in einen Schnitt.",
    ],
    clearance: [
      "0 oder sehr wenig: Das Werkzeug fährt im Eilgang bis ans Material, und ein etwas zu großes Rohteil wird getroffen.",
      "So groß, dass der Startpunkt darin liegt: Das Werkzeug fährt erst weg.",
    ],
    clearanceReserved: [
      "Der Wert wird geändert, um mehr Abstand zu halten: Hier bewirkt er nichts. Nur der Startpunkt hilft.",
    ],
    startDiameter: [
      "Aus Versehen kleiner als der Enddurchmesser: Die Steuerung hält es dann für eine Bohrung.",
      "Kleiner als das Rohteil: Vor der Kontur bleibt ein Ring stehen, und der erste Schnitt wird zu tief.",
    ],
    endDiameter: [
      "Start und Ende sind gleich: Es gibt nichts zu zerspanen.",
      "Das Fertigmaß wird mit Aufmaß eingegeben: Q483 kommt noch einmal dazu.",
    ],
    startZ: ["Z0 liegt auf der rohen Planfläche, die erst später gedreht wird: Jede Länge wird zu kurz."],
    endZ: [
      "Die Länge des Absatzes wird ohne Vorzeichen eingegeben.",
      "Futter und Backen werden vergessen: Das Ende liegt hinter ihnen.",
    ],
    surfaceAngle: [
      "Halber und ganzer Kegelwinkel werden verwechselt: Gefragt ist der Winkel zur Achse, also der halbe.",
    ],
    faceAngle: ["Der Winkel wird von der Achse aus gemessen; er zählt von der rechtwinkligen Planfläche aus."],
    flankAngle: ["Die beiden Flanken werden vertauscht: Q495 gehört zum Konturanfang, Q496 zum Konturende."],
    secondFlankAngle: ["Die beiden Flanken werden vertauscht: Q495 gehört zum Konturanfang, Q496 zum Konturende."],
    startElement: [
      "Typ 0 bleibt stehen, obwohl Q502 eine Größe hat: Keine Kante wird gebrochen.",
      "Eine Fase wird gewählt, wo die Zeichnung einen Radius hat.",
    ],
    startElementSize: ["Es ist länger als die Wand, die es bricht."],
    endElement: ["Typ 0 bleibt stehen, obwohl Q504 eine Größe hat: Keine Kante wird gebrochen."],
    endElementSize: ["Die Fase am Ende liegt auf dem Rohdurchmesser: Ist das Rohteil größer, hängt sie in der Luft."],
    cornerRadius: [
      "Kleiner als der Schneidenradius: Die Ecke wird so rund wie die Platte, und Material bleibt stehen.",
      "Er wird auch für die Kanten genommen: Dafür sind Q502 und Q504 da.",
    ],
    infeedRadial: [
      "Der Wert wird für die wirkliche Zustellung gehalten: Die Tiefe wird gleichmäßig geteilt, der Schnitt ist oft kleiner.",
      "Mehr als ein Drittel der Schneidenlänge: Die Platte wird überlastet.",
      "Er wird verdoppelt, weil sich der Durchmesser um das Doppelte ändert.",
    ],
    infeedAxial: [
      "Ein radialer Wert wird vom Längsdrehen übernommen: Hier geht der Schnitt längs Z.",
      "0 wird als „nicht schruppen“ eingegeben: Es heißt alles in einem Schnitt.",
    ],
    infeedGroove: [
      "So tief wie der Einstich gesetzt: Der Span kommt nicht mehr heraus.",
      "An einen Durchmesser gedacht: In der Planfläche läuft die Zustellung längs Z.",
    ],
    roughingFeed: [
      "Mehr als 0,8 des Schneidenradius: Die Schneide bricht aus, die Fläche wird zum Gewinde.",
      "So klein, dass der Span nicht bricht.",
    ],
    finishingFeed: [
      "Der Schruppvorschub wird übernommen: Rz wächst mit dem Quadrat des Vorschubs.",
      "Ein winziger Vorschub soll die Fläche glätten: Unter der kleinsten Spandicke reibt die Schneide nur.",
    ],
    oversizeZ: [
      "Bleibt 0, während Q483 gesetzt ist: Der Schlichtschnitt reibt an der Planfläche, ohne zu schneiden.",
      "Größer, als es der Schneidenradius in der Ecke erlaubt: Das Schlichten trifft auf einen Berg.",
    ],
    smoothing: [
      "2 wird genommen, um Zeit zu sparen, obwohl die Stufen den Schlichtschnitt springen lassen.",
      "Man erwartet eine andere Fertigkontur: Nur der Weg zwischen den Schnitten ändert sich.",
    ],
    plunging: [
      "1 bleibt stehen, obwohl die Platte für fallende Flanken keinen Freiwinkel hat: Die Nebenschneide reibt.",
      "0 ist gesetzt, und der Freistich bleibt ohne Meldung einfach voll.",
    ],
    plungingFeed: [
      "0 wird als „kein Vorschub“ eingegeben: Es heißt, dass der Schruppvorschub gilt.",
      "So schnell wie der Schruppvorschub, obwohl der Stecher in voller Breite steht.",
    ],
    limits: ["1 ist gesetzt, und Q480 und Q482 haben noch die Werte eines anderen Teils."],
    limitDiameter: ["Sie liegt auf der falschen Seite der Kontur: Es bleibt nichts zu zerspanen."],
    limitZ: ["Das Vorzeichen wird vergessen, und die ganze Kontur liegt jenseits der Grenze."],
    reverseContour: [
      "2 wird ohne ein Werkzeug gewählt, das in der anderen Richtung schneidet.",
      "Die Kontur ist rückwärts programmiert und wird hier noch einmal gewendet: Beides hebt sich auf.",
    ],
    direction: ["Beide Richtungen (0) mit einem Stecher, der nur in eine schneiden darf."],
    offsetWidth: [
      "Mehr als 80 % der wirksamen Stecherbreite: Stege blieben stehen, und die Steuerung hält an.",
      "Bleibt 0, und die Ecke des Stechers reibt bei jedem Schnitt an der Wand.",
    ],
    depthCompensation: [
      "Ein positiver Wert soll den Einstich tiefer machen: Positiv bleibt über dem Grund.",
      "Damit wird eine falsche Werkzeuglänge korrigiert: Das gehört in die Werkzeugtabelle.",
    ],
    blankAllowance: [
      "Das Schlichtaufmaß wird eingegeben: Gemeint ist, um wie viel das Rohteil dicker ist als die Kontur.",
    ],
    threadPitch: ["Bei mehreren Gängen wird die Steigung über alle Gänge statt der Teilung eingegeben."],
    threadDepth: ["0 wird für „kein Gewinde“ gehalten: Die Steuerung rechnet dann die Tiefe aus der Steigung."],
    firstInfeed: ["Der Wert wird für jeden Schnitt gehalten: Die späteren werden kleiner."],
    infeedAngle: ["Mehr als der halbe Gewindewinkel: Die Platte schneidet in die fertige Flanke."],
    threadStarts: ["Die Zahl der Schnitte wird eingegeben: Gemeint sind die Gänge nebeneinander."],
    airCuts: ["Die Zahl der Schnitte wird eingegeben: Das sind zusätzliche Schnitte auf fertiger Tiefe."],
    threadRunIn: ["Zu kurz für die Drehzahl: Am Anfang des Gewindes hat die Achse die Steigung noch nicht erreicht."],
    recessingOverlap: ["Die Breite eines Einstichs in mm wird statt des Anteils der Stecherbreite eingegeben."],
    plungeLimit: ["0 wird für „nicht einstechen“ gehalten: Es heißt in einem Zug auf ganze Tiefe."],
    dwellTurns: ["Langes Verweilen am Grund: Der Stecher reibt und härtet die Fläche."],
  },
};

import type { GuidePlacesTexts } from "../en/guide-places.ts";

export const guidePlaces = {
  other: "Weitere Eingaben",
  setup: "Einrichten",
  approach: "Anfahren und Wegfahren",
  contour: "Kontur",
  ownCycles: "Ihre Zyklen",
  runWith: "Der Zyklus, simuliert mit jedem dieser Werte.",
  places: {
    "blank.outside": {
      about: "⌀ des Rohteils: D in BLK FORM CYLINDER. Nur für die Simulation; die Maschine verwendet den Wert nicht.",
      mistakes: [
        "Fertig-⌀ eingegeben: In der Simulation fehlt Material, ein Eilgang hinein wird nicht erkannt.",
        "Stangen und Gussteile sind größer als ihr Nennmaß: Toleranz addieren.",
      ],
    },
    "blank.bore": {
      about: "⌀ einer vorhandenen Bohrung: DI in BLK FORM CYLINDER. Innenzyklen beginnen an dieser Bohrung.",
      mistakes: [
        "0 trotz Vorbohrung: Die Prüfung findet die Bohrstange im Vollen.",
        "Die Bohrung ist enger als Werkzeug und Schaft: Berührung beim Einfahren.",
      ],
    },
    "blank.length": {
      about: "Gesamtlänge des Rohteils: L in BLK FORM CYLINDER, einschließlich Einspannlänge.",
      mistakes: [
        "Nur die freie Länge eingegeben: Die Backen sind dem Werkzeug im Weg.",
        "Die Länge zum Abstechen fehlt.",
      ],
    },
    "blank.allowance": {
      about: "Aufmaß der Planfläche vor dem Werkstück-Nullpunkt: DIST. Z0 ist meist die fertige Planfläche.",
      mistakes: [
        "0 bei unbearbeiteter Planfläche: Vor Z0 trifft das Werkzeug im Eilgang auf Material.",
        "Negativer Wert: Das Rohteil beginnt hinter Z0, die ersten Schnitte sind Luftschnitte.",
      ],
    },
    tool: {
      about:
        "TOOL CALL wählt eine Schneidplatte mit Schneidenradius und Werkzeugorientierung TO aus der Tabelle. " +
        "Dieselben Werte mit anderer Schneidplatte ergeben ein anderes Teil: Der Schneidenradius bleibt in " +
        "Ecken, die Schneiden begrenzen die Flanken.",
      mistakes: [
        "Werkzeugnummer und Revolverplatz verwechselt: Eine andere Schneidplatte schneidet.",
        "Außenwerkzeug für eine Innenkontur aufgerufen: Die Werkzeugorientierung passt nicht.",
      ],
    },
    "start.x": {
      about:
        "X-Position der Schneidenspitze beim Zyklusaufruf, als ⌀. Zyklen ohne Startdurchmesser beginnen die " +
        "Kontur hier; alle Zyklen starten und enden an dieser Position.",
      mistakes: [
        "Im Rohteil: Der erste Eilgang fährt durch Material.",
        "Radius eingegeben: Das Werkzeug steht im halben Abstand zur Drehachse.",
      ],
    },
    "start.z": {
      about:
        "Z-Position der Schneidenspitze beim Zyklusaufruf: vor dem Material, auf der Seite, von der der Zyklus " +
        "bearbeitet.",
      mistakes: [
        "Hinter einem Bund: Der Weg zum ersten Schnitt führt durch den Bund.",
        "Falsche Seite: Ein Zyklus in Richtung Futter muss von rechts aufgerufen werden.",
      ],
    },
    "spindle.cuttingSpeed": {
      about:
        "VC in m/min: Die Steuerung passt die Drehzahl dem ⌀ an, n = 1000 · vc / (π · d). Die Bahn bleibt " +
        "gleich; Zeit, Wärme und Oberfläche ändern sich.",
      mistakes: [
        "SMAX fehlt: Zur Drehachse hin dreht die Spindel mit maximaler Drehzahl.",
        "Drehzahl eingegeben: 1500 m/min sind für Stahl viel zu schnell.",
      ],
    },
    "spindle.speed": {
      about:
        "S in Umdrehungen pro Minute, bei jedem ⌀ gleich: nötig für Gewinde. Zur Drehachse hin fällt die " +
        "Schnittgeschwindigkeit auf null.",
      mistakes: [
        "Von einem dünnen Teil übernommen: Am großen ⌀ ist die Schnittgeschwindigkeit zu hoch.",
        "Beim Plandrehen verwendet: Zur Mitte hin wird die Oberfläche schlechter.",
      ],
    },
    "spindle.limit": {
      about:
        "SMAX in Umdrehungen pro Minute: maximale Drehzahl bei konstanter Schnittgeschwindigkeit. Futter, " +
        "Aufspannung und Unwucht bestimmen sie, nicht die Schneidplatte.",
      mistakes: [
        "Grenzdrehzahl des Futters nicht beachtet: Backen verlieren mit der Drehzahl an Spannkraft.",
        "Zu niedrig: Die Schnittgeschwindigkeit wird nur am größten ⌀ erreicht.",
      ],
    },
    perRevolution: {
      about: "Mit M136 gelten Vorschübe in mm pro Umdrehung, sonst in mm pro Minute.",
      mistakes: [
        "M136 fehlt: 0,3 heißt dann 0,3 mm pro Minute, und das Werkzeug scheint zu stehen.",
        "Vorschub pro Minute nicht geändert: 200 mm pro Umdrehung.",
      ],
    },
    rapid: {
      about: "Eilganggeschwindigkeit der Maschine. Nur für die geschätzte Zeit; nicht Teil des Programms.",
      mistakes: [
        "Mit einem Vorschub verwechselt: Im Eilgang wird nie geschnitten.",
        "Zeiten zweier Maschinen werden mit dem Eilgang der einen verglichen.",
      ],
    },
  },
  on: "ein",
  off: "aus",
  form: {
    points: "Punkte",
    of: {
      PS: "Unmittelbar vor APPR programmiert, mit R0.",
      PH: "Von der Steuerung aus Form und Werten berechnet.",
      PA: "Im APPR-Satz programmiert.",
      PE: "Im letzten Satz der Kontur programmiert.",
      PN: "Außerhalb der Kontur: bei DEP LCT programmiert, sonst berechnet.",
    },
    polar: "Der Punkt ist vom Pol CC aus durch Abstand PR und Winkel PA festgelegt.",
    ownLead: "Gezeigt an der Kontur Ihres Satzes.",
    sampleLead: "Gezeigt an einer Ecke, mit Werkzeugradius 8 mm.",
    way: "Bahn",
    danger: "Warum PS→PH gefährlich ist",
    dangers: [
      "Von PS nach PH prüft die Steuerung nicht, ob die Kontur verletzt wird.",
      "Bei LT, LN und CT gilt auf dieser Bahn der zuletzt programmierte Vorschub: nach FMAX Eilgang. Bei LCT " +
        "gilt der Vorschub des APPR-Satzes.",
      "PS auf die Seite legen, auf der die Kontur beginnt, damit die Gerade nach PH frei ist. Die App prüft " +
        "diese Gerade.",
    ],
    leaving: "Nach PN folgt der nächste Satz: PN muss frei von Teil und Futter sein.",
    mistakes: {
      all: "RL und RR vertauscht: Das Werkzeug schneidet mit seiner ganzen Breite ins Teil.",
      LT: "Die Verlängerung des Elements ist nicht frei: Die Gerade führt durch einen Absatz.",
      LN:
        "Das Werkzeug wechselt an der Kontur um 90° die Richtung und steht kurz: Auf einer fertigen Fläche " +
        "entsteht eine Marke.",
      CT:
        "Im Satz steht R0: Ein Kreisbogen benötigt RL oder RR. Negatives R legt den Kreisbogen auf die " +
        "Werkstückseite.",
      LCT: "Der äußere Punkt liegt im Kreis von R: Keine Tangente möglich.",
    },
    others: "Andere Formen",
  },
  elements: {
    lead:
      "Die Kontur ist ein Unterprogramm nach dem Hauptprogramm, unter dem mit CYCL DEF 14 gewählten Label. Die " +
      "Richtung der Kontur bestimmt die Bearbeitungsrichtung.",
    title: "Elemente",
    of: {
      L: "Gerade zum Endpunkt. Eine fehlende Koordinate bleibt unverändert.",
      RND: "Rundet die Ecke zwischen vorigem und nächstem Element.",
      CHF: "Fase an der Ecke, auf beiden Seiten gleich lang.",
      CR: "Kreisbahn mit Radius zum Endpunkt; negativer Radius: der größere Kreisbogen.",
      CC: "Mittelpunkt des nächsten C und Pol der polaren Elemente.",
      C: "Kreisbahn um CC zum Endpunkt, Drehsinn DR.",
      CT: "Kreisbahn zum Endpunkt mit tangentialem Anschluss.",
      LP: "Gerade zu einem Punkt mit Abstand und Winkel von CC.",
      CP: "Kreisbahn um CC bis zu einem Winkel.",
      CTP: "Kreisbahn mit tangentialem Anschluss zu einem Punkt, bezogen auf CC.",
      UDC: "Freistich genormter Form zwischen zwei Elementen.",
      GRV: "Einstich mitten in einem geraden Element.",
    },
    mistakes: [
      "Die erste Zeile wird für ein Element gehalten: Sie ist nur der Startpunkt.",
      "X als Radius eingegeben; es ist ein ⌀.",
      "RND oder CHF am Anfang oder Ende: Dort ist keine Ecke.",
      "Eine Rundung ist zu groß für die Nachbarelemente.",
      "Die Kontur reicht bis ins Futter.",
    ],
  },
} satisfies GuidePlacesTexts;

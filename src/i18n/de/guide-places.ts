import type { GuidePlacesTexts } from "../en/guide-places.ts";

export const guidePlaces = {
  other: "Weitere Eingaben",
  setup: "Einrichten",
  approach: "Anfahren und Wegfahren",
  contour: "Kontur",
  ownCycles: "Ihre Zyklen",
  runWith: "Der Kern hat den Zyklus mit jedem davon laufen lassen.",
  places: {
    "blank.outside": {
      about: "Der ⌀ des Rohteils: D in BLK FORM CYLINDER. Die Prüfung trägt davon ab; die Maschine sieht ihn nie.",
      mistakes: [
        "Der Fertig-⌀ steht da: Im Bild fehlt Material, das die Maschine hat, und ein Eilgang hinein wird nicht gefunden.",
        "Stange und Guss sind dicker als ihr Nennmaß: Die Toleranz gehört dazu.",
      ],
    },
    "blank.bore": {
      about: "⌀ einer Bohrung, die vor dem Drehen da ist: DI in BLK FORM CYLINDER. Innenzyklen beginnen bei ihr.",
      mistakes: [
        "0 bleibt stehen, obwohl vorgebohrt ist: Die Prüfung findet die Bohrstange dann im Vollen.",
        "Die Bohrung ist enger als Werkzeug samt Schaft: Sie streifen beim Einfahren.",
      ],
    },
    "blank.length": {
      about: "Ganze Länge des Rohteils: L in BLK FORM CYLINDER, mit dem Stück, das das Futter hält.",
      mistakes: [
        "Nur die freie Länge steht da: Die Backen stehen dem Werkzeug im Weg.",
        "Die Länge zum Abstechen ist vergessen.",
      ],
    },
    "blank.allowance": {
      about: "Wie weit die Planfläche des Rohteils vor dem Werkstück-Nullpunkt steht: DIST. Z0 ist meist die fertige.",
      mistakes: [
        "0, obwohl die Planfläche noch roh ist: Vor Z0 trifft das Werkzeug im Eilgang auf Material.",
        "Ein Minus: Das Rohteil beginnt hinter Z0, und die ersten Schnitte gehen in die Luft.",
      ],
    },
    tool: {
      about:
        "TOOL CALL holt eine Platte mit Schneidenradius und Orientierung TO aus der Tabelle. Dieselben Werte mit anderer Platte ergeben " +
        "ein anderes Teil: Der Radius bleibt in Ecken, die Schneiden begrenzen Flanken.",
      mistakes: [
        "Werkzeugnummer und Revolverplatz sind verwechselt: Eine andere Platte schneidet.",
        "Ein Außenwerkzeug wird für eine Innenkontur gerufen: Die Orientierung passt nicht.",
      ],
    },
    "start.x": {
      about:
        "Wo die Spitze beim Zyklusaufruf quer steht, als ⌀. Zyklen ohne Startdurchmesser beginnen ihre Kontur hier; alle kommen von " +
        "hier und fahren hierher zurück.",
      mistakes: [
        "Er liegt im Rohteil: Der erste Eilgang geht durch Material.",
        "Ein Radius ist getippt: Das Werkzeug steht im halben Abstand zur Achse.",
      ],
    },
    "start.z": {
      about:
        "Wo die Spitze beim Zyklusaufruf längs steht: vor dem Material, auf der Seite, von der der Zyklus arbeitet.",
      mistakes: [
        "Er liegt hinter einem Bund: Der Weg zum ersten Schnitt geht hindurch.",
        "Die Seite ist falsch: Ein Zyklus, der zum Futter schneidet, wird von rechts gerufen.",
      ],
    },
    "spindle.cuttingSpeed": {
      about:
        "VC in m/min: Die Steuerung ändert die Drehzahl mit dem ⌀, n = 1000 · vc / (π · d). Der Weg bleibt; Zeit, Wärme und Oberfläche " +
        "ändern sich.",
      mistakes: [
        "SMAX fehlt daneben: Zur Achse hin dreht die Spindel, so schnell sie kann.",
        "Umdrehungen stehen da: 1500 m/min sind für Stahl viel zu schnell.",
      ],
    },
    "spindle.speed": {
      about:
        "S in Umdrehungen je Minute, bei jedem ⌀ gleich: richtig für Gewinde. Zur Achse hin fällt die Schnittgeschwindigkeit auf null.",
      mistakes: [
        "Sie stammt von einem dünnen Teil: Am großen ⌀ läuft die Schneide zu schnell.",
        "Damit wird plangedreht: Zur Mitte hin wird die Oberfläche schlechter.",
      ],
    },
    "spindle.limit": {
      about:
        "SMAX in Umdrehungen je Minute: Konstante Schnittgeschwindigkeit dreht nie schneller. Futter, Spannung und Unwucht bestimmen sie, " +
        "nicht die Platte.",
      mistakes: [
        "Die Grenze des Futters ist übersehen: Backen verlieren mit der Drehzahl an Spannkraft.",
        "Sie ist so niedrig, dass die Schnittgeschwindigkeit nur am größten ⌀ gehalten wird.",
      ],
    },
    perRevolution: {
      about: "Mit M136 zählen Vorschübe in mm je Umdrehung, ohne in mm je Minute.",
      mistakes: [
        "M136 fehlt: 0,3 heißt dann 0,3 mm je Minute, und das Werkzeug scheint zu stehen.",
        "Ein Vorschub je Minute steht noch da: 200 mm je Umdrehung.",
      ],
    },
    rapid: {
      about:
        "Wie schnell die Maschine im Eilgang fährt. Nur die geschätzte Zeit hängt davon ab; im Programm steht er nicht.",
      mistakes: [
        "Er wird für einen Vorschub gehalten: Er schneidet nie.",
        "Zeiten zweier Maschinen werden mit dem Eilgang der einen verglichen.",
      ],
    },
  },
  on: "ein",
  off: "aus",
  form: {
    points: "Ihre Punkte",
    of: {
      PS: "Unmittelbar vor APPR programmiert, mit R0.",
      PH: "Rechnet die Steuerung aus Form und Werten.",
      PA: "Steht im APPR-Satz.",
      PE: "Steht im letzten Satz der Kontur.",
      PN: "Außerhalb: DEP LCT nennt ihn, die anderen rechnen ihn aus.",
    },
    polar: "Der Punkt ist vom Pol CC aus gegeben: durch den Abstand PR und den Winkel PA.",
    ownLead: "Gezeichnet an der Kontur Ihres Satzes.",
    sampleLead: "Gezeichnet an einer Ecke, mit einem Werkzeug von 8 mm Radius.",
    way: "Weg",
    danger: "Warum PS→PH gefährlich ist",
    dangers: [
      "Von PS nach PH prüft die Steuerung nicht, ob die Kontur verletzt wird.",
      "Bei LT, LN und CT läuft dieser Weg mit dem zuletzt programmierten Vorschub: nach FMAX im Eilgang. Bei LCT mit dem des Satzes.",
      "Legen Sie PS auf die Seite, von der die Kontur beginnt, sodass die Gerade nach PH frei ist. Die App prüft diese Gerade.",
    ],
    leaving: "Hinter PN fährt der nächste Satz seinen eigenen Weg: PN muss frei von Teil und Futter sein.",
    mistakes: {
      all: "RL und RR sind vertauscht: Das Werkzeug schneidet seine eigene Breite ins Teil.",
      LT: "Das Element ist in seiner Verlängerung nicht frei: Das gerade Stück geht durch einen Absatz.",
      LN: "An der Kontur dreht das Werkzeug um 90° und steht kurz: Auf einer fertigen Fläche bleibt eine Marke.",
      CT: "Im Satz steht R0: Ein Bogen braucht RL oder RR. Ein Minus vor R legt den Bogen auf die Seite des Werkstücks.",
      LCT: "Der Punkt außerhalb liegt im Kreis von R: Es gibt keine Tangente.",
    },
    others: "Die anderen Formen",
  },
  elements: {
    lead:
      "Die Kontur steht hinter dem Hauptprogramm, unter einem Label, das CYCL DEF 14 nennt. Ihre Richtung entscheidet, von wo sie " +
      "geschnitten wird.",
    title: "Ihre Elemente",
    of: {
      L: "Gerade zum Endpunkt. Eine fehlende Koordinate bleibt, wie sie war.",
      RND: "Rundet die Ecke zwischen den Elementen davor und dahinter.",
      CHF: "Bricht die Ecke, auf beiden Seiten um die gleiche Länge.",
      CR: "Bogen zum Endpunkt mit Radius; ein Minus nimmt den längeren Weg.",
      CC: "Mittelpunkt des nächsten C und Pol der polaren Elemente.",
      C: "Bogen um CC zum Endpunkt, in der Richtung DR.",
      CT: "Bogen zum Endpunkt, der ohne Ecke an das Element davor anschließt.",
      LP: "Gerade zu einem Punkt, den Abstand und Winkel von CC geben.",
      CP: "Bogen um CC bis zu einem Winkel.",
      CTP: "Bogen ohne Ecke zu einem Punkt, der von CC aus gegeben ist.",
      UDC: "Freistich genormter Form zwischen zwei Elementen.",
      GRV: "Einstich mitten in einem geraden Element.",
    },
    mistakes: [
      "Die erste Zeile wird für ein Element gehalten: Sie ist nur der Startpunkt.",
      "X ist als Radius getippt; es ist ein ⌀.",
      "RND oder CHF steht am Anfang oder Ende: Dort ist keine Ecke.",
      "Eine Rundung ist länger als die Elemente daneben.",
      "Die Kontur geht bis ins Futter.",
    ],
  },
} satisfies GuidePlacesTexts;

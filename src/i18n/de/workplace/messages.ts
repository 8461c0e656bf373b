import type { MessagesTexts } from "../../message-texts.ts";
import { running } from "./messages/running.ts";
import { threads } from "./messages/threads.ts";

/** The value that a finding proposes, if any. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Vorschlag: ${say(value)}.`;

const reasons: MessagesTexts["reasons"] = {
  insertRadius: "Schneidenradius",
  mainEdge: "Hauptschneide",
  secondaryEdge: "Nebenschneide",
  toolWidth: "Werkzeugbreite",
  cutLength: "CUTLENGTH",
  limit: "Schnittbegrenzung",
  plunging: "nicht erlaubtes Eintauchen",
  oversize: "Aufmaß",
  smoothing: "Stufen zwischen den Schnitten",
  correction: "Werkzeugkorrektur",
  overCrest: "Material über der Gewindespitze",
  behindContour:
    "Einstich hinter der Kontur, den dieser Zyklus nicht erreicht; für Form F „Freistich nach Norm“ als Bearbeitung einfügen",
};

const ELEMENT = { angle: "Winkel", length: "Länge", radius: "Radius" };

/** Clamping devices. */
const CLAMPED = {
  jaws: "den Backen",
  chuck: "dem Futter",
  collet: "der Spannzange",
  driver: "dem Mitnehmer",
  tailstock: "dem Reitstock",
  limit: "der Spanngrenze",
};

/** Units of a feed. */
const FEED = { "mm/min": "mm/min", "mm/rev": "mm/U" };

export const messages = {
  reasons,
  morePlaces: (place, more) => `${place} und ${more === 1 ? "einer weiteren Stelle" : `${more} weiteren Stellen`}`,
  of: {
    ...running,
    ...threads,
    missing: () => "Wert eingeben.",
    notANumber: (d, w) => `„${w.text(d.text)}“ ist keine Zahl.`,
    badExpression: (d, w) => `„${w.text(d.text)}“ lässt sich nicht berechnen.`,
    unknownParameter: (d) => `${d.name} hat hier keinen Wert. Zahl eingeben.`,
    outOfRange: (d, w) =>
      `${w.value(d.value)} liegt außerhalb des Bereichs: ${w.value(d.min)} bis ${w.value(d.max)}.${nearest(d.nearest, w.value)}`,
    notWhole: (d, w) => `${w.number(d.value)} ist keine ganze Zahl.${nearest(d.nearest, w.number)}`,
    notAChoice: (d, w) =>
      `${w.number(d.value)} ist nicht zulässig (${d.choices.join(", ")}).${nearest(d.nearest, w.number)}`,
    startEqualsEnd: (d, w) => `Start und Ende sind gleich: auch ${d.other} ist ${w.value(d.value)}.`,
    startLevelWithEnd: (d, w) =>
      `Der Startpunkt liegt auf ${d.axis} ${w.size(d.value)}, gleich dem Konturende: Dazwischen gibt es nichts zu zerspanen.`,
    diameterNegative: (d, w) =>
      `${w.value(d.value)} ist ein Durchmesser jenseits der Drehachse.${nearest(d.nearest, w.value)}`,
    elementTooLong: (d, w) => `${w.size(d.size)} ist zu lang für das Element: max. ${w.size(d.max)}.`,
    cornersTooWide: (d, w) =>
      `Zwei Eckenradien von ${w.size(d.radius)} sind breiter als der Grund: max. ${w.size(d.max)}.`,
    wallsMeet: (d, w) =>
      `Mit ${w.angle(d.angle)} treffen sich die Flanken über dem Grund: kleiner als ${w.angle(d.max)}.`,
    cornerSmallerThanInsert: (d, w) =>
      `Eckenradius ${w.size(d.radius)} ist kleiner als der Schneidenradius ${w.size(d.insert)}: Die Ecke ` +
      `behält ${w.size(d.insert)}.`,
    recessNarrowerThanTool: (d, w) =>
      `Der Grund des Einstichs ist ${w.size(d.width)} breit, Werkzeug und Aufmaß benötigen ${w.size(d.tool)}.` +
      `${nearest(d.nearest, w.value)}`,
    angleNotFollowed: (d, w) =>
      `${d.element === undefined ? "" : `Element ${d.element}: `}Das Werkzeug kann ${w.angle(d.angle)} nicht folgen: ` +
      (d.edge === "behindContour"
        ? "Der Winkel führt hinter die Kontur, wo dieser Zyklus mit keinem Werkzeug schneidet"
        : `Die ${reasons[d.edge]} lässt ${w.angle(d.max)} zu`) +
      ", Restmaterial bleibt.",
    tooManyPasses: (d, w) => `${d.passes} Schnitte überschreiten das Maximum ${d.most}.${nearest(d.nearest, w.size)}`,
    infeedOverCutLength: (d, w) =>
      `Zustellung ${w.size(d.infeed)} ist größer als CUTLENGTH ${w.size(d.cutLength)}: auf ${w.size(d.cutLength)} verringert.`,
    depthOverCutLength: (d, w) =>
      `Tiefe ${w.size(d.depth)} ist größer als CUTLENGTH ${w.size(d.cutLength)}: Restmaterial bleibt.`,
    offsetReduced: (d, w) =>
      `Versatz ${w.size(d.offset)} wird auf ${w.size(d.kept)} verringert: 80 % der wirksamen Breite müssen ` +
      "für " +
      (d.passes === 1 ? "1 Schnitt" : `${d.passes} Schnitte`) +
      " reichen.",
    offsetOverLimit: (d, w) =>
      "Der seitliche Versatz von " +
      (d.passes === 1 ? "1 Schnitt" : `${d.passes} Schnitten`) +
      ` ergibt ${w.size(d.offset)}; 80 % der wirksamen Breite sind ${w.size(d.max)}.` +
      `${nearest(d.nearest, w.size)}`,
    toolUnfit: (d) =>
      `Ein Werkzeug vom Typ ${d.type} mit Werkzeugorientierung ${d.orientation} ist hier nicht geeignet. Geeignet: ` +
      `${d.types.join(" oder ")} mit Werkzeugorientierung ${d.orientations.join(", ")}.`,
    toolCannotCutSideways: (d) =>
      `Ein Werkzeug vom Typ ${d.type} kann nur einstechen, dieser Zyklus schneidet auch seitlich. Werkzeug vom Typ RECTURN verwenden.`,
    flanksNotChecked: () => "T-ANGLE oder P-ANGLE ist leer: Die Flanken der Schneide werden nicht geprüft.",
    toolColumn: (d, w) => {
      const what =
        d.value === null
          ? d.column === "TYPE"
            ? "TYPE fehlt oder ist kein Werkzeugtyp."
            : `${d.column} fehlt oder ist keine Zahl.`
          : `${d.column} ${w.value(d.value)} ist nicht möglich.`;
      if (d.min !== undefined && d.max !== undefined)
        return `${what} Erlaubt: ${w.value(d.min)} bis ${w.value(d.max)}.`;
      if (d.min !== undefined)
        return `${what} Der Wert muss ${d.column === "CUTWIDTH" ? "größer als" : "mindestens"} ${w.value(d.min)} sein.`;
      return d.max === undefined ? what : `${what} Der Wert muss kleiner als ${w.value(d.max)} sein.`;
    },
    toolNumberTwice: (d) => `Werkzeug ${d.number} ist bereits in der Tabelle.${nearest(d.nearest, String)}`,
    toolName: (d, w) =>
      `„${w.text(d.text)}“: Ein Name hat höchstens ${d.max} Zeichen, nur Großbuchstaben, Ziffern und # $ % & , - . _ sind erlaubt.`,
    holderAxis: (d, w) => `„${w.text(d.text)}“: Der Schaft muss in X oder in Z liegen.`,
    holderHead: (d, w) =>
      `„${w.text(d.text)}“ ist kein Umriss. Jede Ecke als Z/X ab der Spitze eingeben, Ecken durch Leerzeichen, Teile durch Semikolon getrennt; ein Teil hat mindestens drei Ecken.`,
    bladeSupport: (d, w) =>
      `„${w.text(d.text)}“ ist keine Unterstützung einer Stechklinge: NONE, STRAIGHT oder CURVED.`,
    straightBlade: () =>
      "Eine gerade Stechklinge reibt im Axialeinstich: Nötig ist eine gebogene, passend zum ⌀ (DAXN, DAXX).",
    pointDiffers: (d, w) =>
      `Spitzenlänge ${w.size(d.length)} passt nicht zu ${w.angle(d.angle)}, daraus folgen ${w.size(d.byAngle)}: Es gilt der Winkel.`,
    betterTool: (d) => `Werkzeug ${d.tool} ${d.name} ist für diese Kontur geeignet.`,
    startInArea: (d, w) =>
      `Der Startpunkt ${w.place(d.x, d.z)} liegt im Zerspanbereich: Das Werkzeug fährt zuerst auf Sicherheitsabstand.`,
    startInMaterial: (d, w) => `Der Startpunkt ${w.place(d.x, d.z)} liegt im Material.`,
    startBelowContour: (d, w) =>
      `Der Startpunkt liegt ${w.length(d.below)} unter dem Konturstart: Das Werkzeug fährt zuerst auf den Konturstart.`,
    startBehindContour: (d, w) =>
      `Der Startpunkt liegt ${w.length(d.behind)} hinter dem Konturstart: Das Werkzeug fährt zuerst in Z auf den Sicherheitsabstand von ${w.size(
        d.clearance,
      )} davor.`,
    startInPart: (d, w) =>
      `Der Startpunkt liegt im Fertigteil: Von dort wird nichts zerspant. Gültiger Startpunkt: ${w.place(d.x, d.z)}.`,
    insertAcrossAxis: (d, w) =>
      `Die Schneidplatte reicht ${w.length(d.reach)} über die Drehachse: Konturverletzung.` +
      (d.nearest === undefined
        ? " Die Schneidplatte ist für diese Bohrung zu lang."
        : ` Frei mit Startpunkt ab X${w.diameter(d.nearest)}.`),
    boreMissing: (d, w) =>
      `Die Bohrung fehlt: Ab Z${w.signed(d.z)} ist das Material voll, der Zyklus bearbeitet bis Z${w.signed(
        d.to,
      )}. Erst bis dorthin mit mindestens ${w.diameter(d.need)} vorbohren.`,
    startOnWrongSide: (d, w) =>
      `Die Kontur läuft auf den Startpunkt zu: Von dort wird nichts zerspant. Gültiger Startpunkt: ${w.place(d.x, d.z)}.`,
    startInsideEnvelope: (d, w) =>
      `Der Startpunkt liegt näher an der Kontur als der Abstand ${w.size(d.clearance)}: Das Werkzeug fährt mit Vorschub Schlichten direkt zur Kontur.`,
    limitOnWrongSide: (d, w) =>
      `Mit der Grenze ${w.value(d.limit)} wird auf der Seite des Werkzeugs nichts zerspant.${nearest(d.nearest, w.value)}`,
    cutBehindLimit: (d, w) =>
      `Hinter der Schnittbegrenzung werden bei ${w.place(d.x, d.z)} ${w.area(d.area)} Material zerspant: Die Grenze gilt für die Kontur, nicht für An- und Abfahren.` +
      (d.finishing
        ? " Nur Schruppen (Q215 = 1) zerspant dort nicht."
        : " Die Grenze so setzen, dass An- und Abfahren frei von Material sind."),
    nothingToCut: () => "Zwischen Startpunkt und Kontur gibt es nichts zu zerspanen.",
    contourMissing: (d, w) =>
      d.label === "" ? "Die Kontur fehlt." : `Die Kontur LBL ${w.text(d.label)} gibt es nicht.`,
    contourTooShort: () => "Eine Kontur benötigt mindestens zwei verschiedene Punkte.",
    contourFlat: (d) => `Start und Ende der Kontur haben dasselbe ${d.axis}: Dazwischen gibt es nichts zu zerspanen.`,
    contourEndCovered: (d, w) =>
      `Die Kontur endet bei ${w.place(
        d.x,
        d.z,
      )} in sich selbst: Ein Element reicht über dieses Ende hinaus, das Teil kann nicht fortgesetzt werden.`,
    contourPoint: (d) => `Element ${d.element}: Der Endpunkt fehlt oder ist nicht erreichbar.`,
    cornerElementAlone: (d) =>
      `Element ${d.element}: Fase und Rundung benötigen ein Element davor und danach, eine Fase zwei Geraden.`,
    cornerElementTooLong: (d, w) =>
      `Element ${d.element}: ${w.size(d.size)} passt nicht zwischen die Nachbarelemente: max. ${w.size(d.max)}.`,
    arcOffCircle: (d, w) => `Element ${d.element}: Der Endpunkt verfehlt den Kreis um ${w.size(d.gap)}.`,
    arcTooSmall: (d, w) => `Element ${d.element}: Radius ${w.size(d.radius)} ist zu klein für den Endpunkt.`,
    elementFree: (d) =>
      d.freedom === 1
        ? `Element ${d.element}: 1 weitere Angabe nötig.`
        : `Element ${d.element}: ${d.freedom} weitere Angaben nötig.`,
    elementContradicts: (d, w) =>
      d.quantity === "tangent"
        ? `Element ${d.element} schließt nicht tangential an; die Abweichung ist ${w.number(d.nearest)}°.`
        : `Element ${d.element}: ${ELEMENT[d.quantity]} ${(d.quantity === "angle" ? w.number : w.size)(
            d.given,
          )} widerspricht den übrigen Angaben; ` + `${(d.quantity === "angle" ? w.number : w.size)(d.nearest)} passt.`,
    elementUnreachable: (d) =>
      `Element ${d.element}: Mit dieser Länge, diesem Radius oder diesem Winkel ist das Nachbarelement nicht erreichbar.`,
    centreMissing: (d) => `Element ${d.element}: Der Kreismittelpunkt fehlt; CC davor programmieren.`,
    contourCrossesItself: (d) => `Element ${d.element} kreuzt Element ${d.other}.`,
    toolRadiusTooLarge: (d, w) =>
      `Element ${d.element}: Ein Werkzeugradius von ${w.size(d.radius)} passt nicht.${nearest(d.nearest, w.size)}`,
    pathCutsContour: (d, w) =>
      `An Element ${d.element} schneidet das Werkzeug bei ${w.spot(d.x, d.y, undefined)} um ${w.length(
        d.depth,
      )} in Element ${d.other} ein: Das Werkzeug ist zu groß; die Steuerung prüft nur Nachbarelemente.${nearest(d.nearest, w.size)}`,
    approachNeedsSide: () => "CT benötigt RL oder RR: Mit R0 stoppt die Steuerung hier.",
    approachSideAssumed: () =>
      "R0 legt keine Seite fest: Angenommen wird Anfahren von links der Kontur. Nicht geprüft.",
    approachInsideCircle: (d, w) =>
      `${d.point} liegt im Kreis mit R ${w.size(d.radius)}: Von dort ist keine Tangente möglich.${nearest(d.nearest, w.size)}`,
    approachCutsContour: (d, w) =>
      `Zwischen ${d.point} und der Kontur schneidet das Werkzeug bei ${w.spot(d.x, d.y, d.z)} um ${w.length(d.depth)}` +
      ` in sie ein; die Steuerung prüft das nicht. Frei ist ${d.point} ${w.spot(d.freeX, d.freeY, d.freeZ)}.`,
    approachValueCutsContour: (d, w) =>
      `Zwischen ${d.point} und der Kontur schneidet das Werkzeug bei ${w.spot(d.x, d.y, d.z)} um ${w.length(d.depth)}` +
      ` in sie ein; die Steuerung prüft das nicht. Frei mit ${d.word} ${w.size(d.nearest)}.`,
    approachBlocked: (d, w) =>
      `Zwischen ${d.point} und der Kontur schneidet das Werkzeug bei ${w.spot(d.x, d.y, d.z)} um ${w.length(d.depth)}` +
      " in sie ein; die Steuerung prüft das nicht.",
    undercutNeighbours: (d) =>
      `Element ${d.element}: Ein Freistich benötigt einen achsparallelen Zylinder und eine Planfläche, ein Einstich ein gerades Element seiner Richtung.`,
    recessWord: (d) => `Element ${d.element}: ${d.word} fehlt oder ergibt keine gültige Form.`,
    recessWordsExclusive: (d) =>
      `Element ${d.element}: ${d.other} und ${d.word} schließen sich aus. Nur eines davon eingeben.`,
    pitchNotListed: (d, w) => {
      const near = [d.below, d.above].flatMap((n) => (n === undefined ? [] : [w.size(n, 4)])).join(" und ");
      return `Element ${d.element}: DIN 76 hat keinen Freistich für Steigung ${w.size(
        d.pitch,
        4,
      )}; nächste Steigungen: ${near}. Eine davon verwenden oder ${d.words} eingeben.`;
    },
    undercutDefaults: (d) =>
      `Element ${d.element}: ${d.words} nach Norm, für diese Steuerung nicht geprüft; zur Sicherheit eingeben.`,
    materialLeft: (d, w) =>
      d.asked === undefined
        ? `Restmaterial bei ${w.place(d.x, d.z)}: ${w.area(d.area)}. Grund: ${reasons[d.reason]}.`
        : d.reason === "oversize"
          ? `Aufmaß bei ${w.place(d.x, d.z)}: ${w.area(d.area)}, wie programmiert.`
          : `Die Ecke bei ${w.place(d.x, d.z)} hat den Schneidenradius: ${w.area(d.area)} Restmaterial. Kein anderer Radius ist programmiert.`,
    gouge: (d, w) => `Konturverletzung bei ${w.place(d.x, d.z)}: ${w.area(d.area)}.`,
    rapidInStock: (d, w) => `Eilgang bei ${w.place(d.x, d.z)} durch ${w.area(d.area)} Material.`,
    holderContact: (d, w) => `Der Halter berührt bei ${w.place(d.x, d.z)} das Material.`,
    cutBelowContour: (d, w) =>
      `Dieser Schnitt geht bei ${w.place(d.x, d.z)} um ${w.area(
        d.area,
      )} unter die Kontur des Zyklus in Satz ${d.block}. Falls gewollt, bestätigen.`,
    intendedCut: (d, w) =>
      `Als gewollt gekennzeichnet: ${d.blocks.length === 1 ? "Schnitt" : "Schnitte"} unter der Kontur in ${
        d.blocks.length === 1 ? "Satz" : "den Sätzen"
      } ${d.blocks.join(", ")}, ${w.area(d.area)} bei ${w.place(d.x, d.z)}.`,
    cameLoose: (d, w) =>
      `${{ piece: "Ein Stück", ring: "Ein Ring", slug: "Ein Butzen" }[d.shape]} von ${w.area(d.area)} bei ${w.place(
        d.x,
        d.z,
      )} ist nicht mehr mit dem gespannten Ende verbunden: abgetrennt in Satz ${d.block}.`,
    partedOff: (d, w) =>
      `Das Stück bei ${w.place(d.x, d.z)}, ${w.area(d.area)}, wird in Satz ${d.block} abgestochen und aus der Simulation entfernt.`,
    cutOnLoosePiece: (d, w) =>
      `Satz ${d.block} trennt dieses Stück ab, bevor es fertig ist: bei ${w.place(d.x, d.z)} würden ${w.area(
        d.area,
      )} von einem nicht mehr gespannten Stück abgetragen. Zuletzt abtrennen.`,
    behindBlank: (d, w) =>
      d.motion === "unheld"
        ? `Außen wird bis zum hinteren Ende des Rohteils bei Z${w.size(
            d.rear,
          )} gedreht: Zum Spannen bleibt keine Fläche. Bei anderer Aufspannung diese angeben.`
        : `${d.motion === "rapid" ? "Eilgang" : "Schnitt"} hinter dem hinteren Ende des Rohteils bei Z${w.size(
            d.rear,
          )}, bei ${w.place(d.x, d.z)}: Dort steht das Spannmittel.`,
    clampContact: (d, w) =>
      `${d.by === "tool" ? "Das Werkzeug" : "Der Halter"} kollidiert bei ${w.place(d.x, d.z)} mit ${
        CLAMPED[d.part]
      }. Schnitt früher beenden oder anders spannen.`,
    contactsUnlooked: (d) =>
      `${d.limit} Bewegungen verletzen die Kontur, fahren im Eilgang ins Material oder berühren es mit dem Halter: Ab hier nicht weiter geprüft.`,
    deeperThanInfeed: (d, w) =>
      "" +
      (d.pass === undefined ? "Ein Glätt- oder Schlichtschnitt" : `Schnitt ${w.number(d.pass)}`) +
      ` schneidet ${w.length(d.depth)} tief; erlaubt sind max. ${w.length(d.allowed)}.`,
    blankLacks: (d, w) =>
      `${w.text(d.what)} lässt ${w.area(d.area)} des laut Programm vorhandenen Materials aus. Der Umriss gilt.`,
    blankGone: (d, w) =>
      `${w.text(d.what)} umfasst ${w.area(d.area)} bereits abgetragenes Material. Abgetragenes Material bleibt abgetragen.`,
    nothingCut: () => "Diese Bearbeitung trägt kein Material ab.",
    airPasses: (d) => (d.count === 1 ? "1 Luftschnitt." : `${d.count} Luftschnitte.`),

    notUnderstood: (d, w) => `„${w.text(d.text)}“ ist unbekannt: bleibt im Programm, wird nicht simuliert.`,
    wordNotUnderstood: (d, w) => `Das Wort „${w.text(d.text)}“ ist unbekannt.`,
    wordTwice: (d, w) => `${w.text(d.word)} steht zweimal im Satz; das letzte gilt.`,
    equalsMissing: (d, w) =>
      `In „${w.text(d.text)}“ fehlt das Gleichheitszeichen. Gelesen wird der Text wie mit Gleichheitszeichen.`,
    blankBeforeEquals: (d, w) => `In „${w.text(d.text)}“ steht ein Leerzeichen vor dem Gleichheitszeichen.`,
    lineTooLong: (d) => `Die Zeile hat mehr als ${d.most} Zeichen: Sie bleibt im Text stehen, wird aber nicht gelesen.`,
    badNumber: (d, w) => `„${w.text(d.text)}“ ist keine Zahl.`,
    wordMissing: (d, w) => `${w.text(d.word)} fehlt in diesem Satz.`,
    blockNumber: (d) => `Satznummer ${d.found} ist außer der Reihe; erwartet: ${d.expected}.`,
    blockNumberMissing: (d) => `Der Satz hat keine Nummer; erwartet: ${d.expected}.`,
    listWithoutTilde: (d) =>
      `${d.places === 1 ? "In einer Zyklusliste fehlt" : `In ${d.places} Zykluslisten fehlt`} das ~ am Zeilenende: Die Steuerung kann das Programm nicht laden.`,
    continuationOpen: () => "Die Zeile endet mit ~, aber es folgt keine Fortsetzung.",
    isoProgram: () => "Der Text ist DIN/ISO. Als eigenes Programm öffnen, um ihn in Klartext umzuwandeln.",
    frameMissing: (d) => `Dem Programm fehlt ${d.which}.`,

    notSimulated: (d, w) => `${w.text(d.what)}: bleibt im Programm, wird nicht simuliert.`,
    notProved: (d, w) =>
      `${w.text(d.what)} wird nicht simuliert und kann Bahn oder Rohteil verändern: ab hier nicht geprüft.`,
    cycleNotSimulated: (d, w) => `Zyklus ${d.cycle} ${w.text(d.name)}: bleibt im Programm, wird nicht simuliert.`,
    noCycleDefined: () => "Vor dem Aufruf ist kein Zyklus definiert.",
    noToolCalled: () => "Vor diesem Satz ist kein Werkzeug aufgerufen.",
    toolUnknown: (d, w) => `Werkzeug ${w.text(d.tool)} ist nicht in der Tabelle.`,
    notInTurnMode: () => "Der Zyklus läuft nur in FUNCTION MODE TURN: diesen Satz vor dem Aufruf programmieren.",
    compensationActive: (d) =>
      `Hier ist ${d.side} aktiv, die Steuerung verlangt R0: R0 im Positioniersatz davor programmieren.`,
    feedZero: (d, w) =>
      `${w.text(d.word)}: Der Schnittvorschub ist hier 0. Vorschub größer 0 eingeben; FAUTO übernimmt F aus TOOL CALL.`,
    feedUnlikely: (d, w) =>
      `Ein Vorschub von ${w.feed(d.feed, FEED[d.unit])} ist unwahrscheinlich. M136 prüfen: Mit M136 gilt F pro Umdrehung.`,
    pointBeyondDepth: (d, w) =>
      `Die Bohrung ist ${w.size(d.depth)} tief, die Bohrerspitze ${w.size(d.point)} lang: Die Bohrung erreicht ihren Durchmesser nicht.`,
    drillTooShort: (d, w) =>
      `Die Bohrung ist ${w.size(d.depth)} tief, die Schneiden des Bohrers (LCUTS) sind ${w.size(d.edges)} lang: Der Schaft kann reiben.`,
    centreMouth: (d, w) =>
      `Die Zentrierbohrung hat an der Planfläche ⌀${w.size(d.mouth)} statt ⌀${w.size(d.wanted)}: Ihr Bohrer braucht die Tiefe ${w.size(d.depth)}.`,
    pitchOfTap: (d, w) =>
      `Q239 ist ${w.size(d.pitch)}, der Gewindebohrer in der Tabelle hat aber PITCH ${w.size(d.tap)}.`,
    freeChosen: () =>
      "Ab hier passen mehrere Konturen zu den Angaben: Gezeigt wird die kürzeste. Die Steuerung verwendet die " +
      "mit FSELECT gewählte.",
    freeUnsolved: (d, w) =>
      `${w.text(d.form)}: Die Angaben bestimmen dieses Element nicht oder widersprechen sich. Weitere Angaben oder FSELECT eingeben.`,
    cycleNeverCalled: (d) => `Zyklus ${d.cycle} ist definiert, wird aber nie aufgerufen: CYCL CALL oder M99 fehlt.`,
    neverReached: (d) => `Das Programm endet mit ${d.by} vor diesem Satz: Der Satz wird nie ausgeführt.`,
    listOfOlderSoftware: (d, w) =>
      `Die Parameterliste von Zyklus ${d.cycle} stammt von einem älteren Softwarestand. Die Steuerung ergänzt: ${d.filled
        .map((word) => w.text(word))
        .join(", ")}.`,
    parameterForeign: (d, w) =>
      `${w.text(d.name)} ist hier nicht zulässig: Zyklus ${d.cycle} hat diesen Parameter nicht, oder der Parameter ist zweimal programmiert.`,
    runsIntoLabel: (d, w) => `Das Programm läuft in die Kontur von LBL ${w.text(d.label)}: Davor fehlt M30.`,
    contourStartIncomplete: (d) => `Der erste Satz der Kontur benötigt X und Z; ${d.axis} fehlt.`,
    approachUncompensated: (d) => `${d.form} hat kein RL oder RR: Die folgende Kontur läuft ohne Radiuskorrektur.`,
    labelMissing: (d, w) => `LBL ${w.text(d.label)} gibt es nicht.`,
    labelTwice: (d, w) => `LBL ${w.text(d.label)} steht zweimal im Programm.`,
    labelNotClosed: (d, w) => `LBL ${w.text(d.label)} wird nicht mit LBL 0 abgeschlossen.`,
    contourNotNamed: (d) => `Zyklus ${d.cycle} benötigt vor dem Aufruf Zyklus 14 mit der Kontur.`,
    contoursJoined: (d, w) =>
      `${w.text(d.joined)}: Hier sind mehrere Konturen verknüpft. Zyklus ${w.number(d.cycle)} bearbeitet nur eine Kontur; die Bahn wird nicht gezeigt.`,
    errorRaised: (d, w) =>
      d.error === null
        ? "FN 14: Die Steuerung stoppt hier mit einem Fehler; die folgenden Sätze werden nicht ausgeführt."
        : `FN 14: Die Steuerung stoppt hier mit Fehler ${w.number(d.error)}; die folgenden Sätze werden nicht ausgeführt.`,
    contourInFile: (d, w) =>
      `Die Kontur steht in der Datei ${w.text(d.file)}, die hier nicht vorliegt: die Kontur in ein Label schreiben und mit Zyklus 14 wählen.`,
    feedMissing: () => "Es ist kein Vorschub programmiert.",
    spindleMissing: () => "Es ist keine Spindeldrehzahl programmiert; Zeiten fehlen.",
    parameterUnset: (d) => `${d.name} hat hier keinen Wert.`,
    divisionByZero: () => "Division durch 0.",
    notFinite: (d, w) => `„${w.text(d.text)}“ ergibt keine gültige Zahl.`,
    clampingUnread: (d, w) => `CLAMPING: „${w.text(d.what)}“ ist unbekannt und wird ignoriert.`,
    clampingIncomplete: (d) =>
      `CLAMPING wird ignoriert: ${d.words} fehlt oder ist ungültig. Die Aufspannung ist unbekannt.`,
    clampingTwice: () => "CLAMPING ist zweimal definiert: das erste gilt. Dieses löschen.",
    clampingMisses: (d, w) =>
      `Die Aufspannung fasst das Rohteil nicht: Im Spannbereich liegt keine Fläche mit ${w.diameter(
        d.diameter,
      )}. ⌀, Länge und Lage von CLAMPING prüfen.`,
    blankMissing: () => "Das Programm definiert kein Rohteil.",
    blankNotTurned: (d, w) => `Ein Rohteil vom Typ ${w.text(d.form)} ist kein Rotationskörper.`,
    endsExchanged: (d, w) =>
      d.axis === "X"
        ? `Von X${w.diameter(d.start)} nach X${w.diameter(d.end)} ist kein Material zu zerspanen. Start und Ende (${d.other}) vertauscht?`
        : `Von Z${w.signed(d.start)} nach Z${w.signed(d.end)} schneidet der Zyklus vom Futter weg. Start und Ende (${d.other}) vertauscht?`,
    endInFront: (d, w) => `Z${w.signed(d.value)} liegt vor dem Werkstück. ${w.signed(d.nearest)}?`,
    startInFront: (d, w) => `Z${w.signed(d.value)} liegt vor dem Werkstück. ${w.signed(d.nearest)}?`,
    diameterInSolid: (d, w) =>
      `${w.diameter(d.value)} liegt im vollen Rohteil: Es gibt keine Bohrung, in der das Werkzeug beginnen könnte.`,
    diameterOutside: (d, w) => `${w.diameter(d.value)} ist größer als das Rohteil, ${w.diameter(d.blank)}.`,
    blankAgainstContour: (d, w) =>
      ({
        outside: `Die Kontur reicht bis ${w.diameter(d.contour)}, das Rohteil nur bis ${w.diameter(d.blank)}. Vorschlag: ${w.diameter(
          d.nearest,
        )}.`,
        bore: `Die Bohrung des Rohteils hat ${w.diameter(d.blank)}, die Kontur endet bei ${w.diameter(
          d.contour,
        )}: Es wird nichts zerspant. Vorschlag: ${w.diameter(d.nearest)}.`,
        length: `Die Kontur reicht bis Z${w.signed(d.contour)}, das Rohteil nur bis Z${w.signed(d.blank)}. Vorschlag: ${w.size(
          d.nearest,
        )}.`,
        allowance: `Die Kontur beginnt bei Z${w.signed(d.contour)}, das Rohteil erst bei Z${w.signed(d.blank)}: Luftschnitte. Vorschlag: ${w.signed(d.nearest)}.`,
        thread: `Das Gewinde hat ${w.diameter(d.contour)}, das Rohteil ${w.diameter(d.blank)}. Vorschlag: ${w.diameter(d.nearest)}.`,
      })[d.place],
    blankImpossible: () => "Das Rohteil hat kein Volumen: Maße prüfen.",
    boxTurned: (d, w) =>
      `Der Quader gilt als Zylinder um seine Ecken, Durchmesser ${w.size(d.outer)}. Nur innerhalb von Durchmesser ${w.size(d.inner)} ist ringsum sicher Material. Für Rundmaterial BLK FORM CYLINDER verwenden.`,
    blankTaken: (d, w) => `${w.text(d.what)} wird als Rohteil verwendet.`,
    blankAdds: (d, w) => `${w.text(d.what)} umfasst ${w.area(d.area)} mehr als BLK FORM. Der Umriss gilt.`,
    blankTraced: () =>
      "Bei aktiver Rohteilnachführung entfallen beim Schruppen Zustellungen ohne Material. Andere Leerwege, die " +
      "die Steuerung kürzen kann, werden vollständig gezeigt.",
    poleMissing: () => "Der Satz benötigt davor einen Pol CC.",
    startUnknown: () => "Die Position vor diesem Satz ist nicht bekannt.",
    arcImpossible: () => "Mit diesen Werten ist kein Kreisbogen möglich.",
    radiusCompensation: (d) => `${d.side} wird erkannt, die Bahn aber nicht korrigiert.`,
    compensationUndefined: (d) =>
      `${d.side} mit Werkzeugorientierung TO ${d.orientation}: Die Richtung der Korrektur ist nicht eindeutig. Ein Werkzeug verwenden, dessen ` +
      "Schneide in eine Ecke zeigt, oder die Bahn mit R0 programmieren.",
    sideChanged: () => "Zwischen RL und RR verlangt die Steuerung einen Satz mit R0.",
    approachWithoutContour: (d) => `${d.form} benötigt ein angrenzendes Konturelement.`,
    lengthDelta: (d) =>
      `DZL und DXL von Werkzeug ${d.tool}: Die Steuerung addiert die Werte zu den Werkzeuglängen. Die Schneidenspitze bleibt auf der ` +
      "Bahn; Bahn und Werkstück ändern sich nicht.",
    toolRadiusUnknown: (d, w) =>
      `Der Radius von Werkzeug ${w.text(d.tool)} ist nicht bekannt: Die Bahn ist mit Radius 0 berechnet.`,
    wordsRecalled: (d, w) => `${w.text(d.what)}: Parameter nicht am Handbuch geprüft; an der Steuerung prüfen.`,
    programEndMissing: () => "Am Ende des Hauptprogramms fehlt M30 oder M2.",
    tooManyBlocks: (d) => `Mehr als ${d.limit} Sätze wurden ausgeführt: dort angehalten.`,
    tooManyRepeated: (d) =>
      `Mehr als ${d.limit} Sätze wurden wiederholt ausgeführt: dort angehalten. Ein Sprung oder eine Wiederholung endet vielleicht nie.`,
    tooManyMoves: (d) => `Mehr als ${d.limit} Bewegungen: dort angehalten.`,
    contourTooLong: (d) => `Die Kontur hat mehr als ${d.limit} Sätze: dort angehalten.`,
    tooManyOperations: (d) => `Mehr als ${d.limit} Zyklusaufrufe: dort angehalten.`,
    moreAlike: (d, w) =>
      `Ab hier sind ${w.number(d.count)} weitere Prüfmeldungen derselben Art (${d.code}) nur gezählt, nicht aufgeführt.`,
    callsTooDeep: (d) => `Label-Aufrufe sind mehr als ${d.limit}-fach verschachtelt.`,
    programsTooDeep: (d) =>
      `Programmaufrufe sind mehr als ${d.limit}-fach verschachtelt: Ein Programm ruft sich endlos selbst auf. Dort angehalten.`,
    endInCalled: (d) =>
      `${d.word} ist in einem aufgerufenen Programm nicht erlaubt: Das aufrufende Programm läuft nach dem Aufruf weiter.`,
    programNotOpened: (d, w) =>
      `${w.text(d.file)} ist nicht geöffnet: Zusammen mit diesem Programm öffnen, um es auszuführen.`,
    programNotSelected: () => "CALL SELECTED PGM benötigt ein vorher mit SEL PGM gewähltes Programm.",
  },
} satisfies MessagesTexts;

import type { MessagesTexts } from "../../message-texts.ts";
import { running } from "./messages/running.ts";
import { threads } from "./messages/threads.ts";

/** What a finding offers, where it offers something. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Nächster möglicher Wert: ${say(value)}.`;

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
  overCrest: "Material über dem Gewindeaußenmaß",
};

const ELEMENT = { angle: "Winkel", length: "Länge", radius: "Radius" };

/** What holds the work. */
const CLAMPED = {
  jaws: "die Backen",
  chuck: "das Futter",
  collet: "die Spannzange",
  driver: "den Mitnehmer",
  tailstock: "den Reitstock",
  limit: "die angegebene Grenze",
};

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
      `${w.number(d.value)} steht nicht zur Wahl (${d.choices.join(", ")}).${nearest(d.nearest, w.number)}`,
    startEqualsEnd: (d, w) => `Start und Ende sind gleich: auch ${d.other} ist ${w.value(d.value)}.`,
    startLevelWithEnd: (d, w) =>
      `Der Startpunkt steht auf ${d.axis} ${w.size(d.value)}, wo die Kontur endet: Dazwischen gibt es nichts zu zerspanen.`,
    diameterNegative: (d, w) =>
      `${w.value(d.value)} ist ein Durchmesser jenseits der Drehachse, dort wird keine Kontur geplant.${nearest(d.nearest, w.value)}`,
    elementTooLong: (d, w) => `${w.size(d.size)} ist länger, als das Element erlaubt: höchstens ${w.size(d.max)}.`,
    cornersTooWide: (d, w) =>
      `Zwei Eckenradien von ${w.size(d.radius)} sind breiter als der Grund: höchstens ${w.size(d.max)}.`,
    wallsMeet: (d, w) =>
      `Mit ${w.angle(d.angle)} treffen sich die Flanken über dem Grund: weniger als ${w.angle(d.max)}.`,
    cornerSmallerThanInsert: (d, w) =>
      `Eckenradius ${w.size(d.radius)} ist kleiner als der Schneidenradius ${w.size(d.insert)}: Die Ecke ` +
      `behält ${w.size(d.insert)}.`,
    recessNarrowerThanTool: (d, w) =>
      `Der Grund des Einstichs ist ${w.size(d.width)} breit, Werkzeug und Aufmaß brauchen ${w.size(d.tool)}.` +
      `${nearest(d.nearest, w.value)}`,
    angleNotFollowed: (d, w) =>
      `${d.element === undefined ? "" : `Element ${d.element}: `}Das Werkzeug kann ${w.angle(d.angle)} nicht folgen: Die ${
        reasons[d.edge]
      } lässt ${w.angle(d.max)} zu, ` + `Material bleibt stehen.`,
    tooManyPasses: (d, w) => `${d.passes} Schnitte sind mehr als ${d.most}.${nearest(d.nearest, w.size)}`,
    infeedOverCutLength: (d, w) =>
      `Zustellung ${w.size(d.infeed)} ist größer als CUTLENGTH ${w.size(d.cutLength)}: Sie wird auf ` +
      `${w.size(d.cutLength)} verringert.`,
    depthOverCutLength: (d, w) =>
      `Tiefe ${w.size(d.depth)} ist größer als CUTLENGTH ${w.size(d.cutLength)}: Der Rest bleibt stehen.`,
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
      `Ein Werkzeug vom Typ ${d.type} mit Werkzeugorientierung ${d.orientation} kann das nicht. Geeignet: ` +
      `${d.types.join(" oder ")} mit Werkzeugorientierung ${d.orientations.join(", ")}.`,
    toolCannotCutSideways: (d) =>
      `Ein Werkzeug vom Typ ${d.type} sticht nur ein, dieser Zyklus schneidet auch seitlich. Ein Werkzeug vom Typ RECTURN nehmen.`,
    flanksNotChecked: () => "T-ANGLE oder P-ANGLE ist leer: Die Flanken der Schneide werden nicht geprüft.",
    toolColumn: (d, w) => {
      const what =
        d.value === null
          ? `${d.column} fehlt oder ist keine Zahl.`
          : `${d.column} ${w.value(d.value)} ist nicht möglich.`;
      if (d.min !== undefined && d.max !== undefined)
        return `${what} Erlaubt: ${w.value(d.min)} bis ${w.value(d.max)}.`;
      if (d.min !== undefined)
        return `${what} Der Wert muss ${d.column === "CUTWIDTH" ? "größer als" : "mindestens"} ${w.value(d.min)} sein.`;
      return d.max === undefined ? what : `${what} Der Wert muss kleiner als ${w.value(d.max)} sein.`;
    },
    toolNumberTwice: (d) => `Werkzeug ${d.number} steht schon in der Tabelle.${nearest(d.nearest, String)}`,
    toolName: (d, w) =>
      `„${w.text(d.text)}“: Ein Name hat höchstens ${d.max} Zeichen, nur Großbuchstaben, Ziffern und # $ % & , - . _ sind erlaubt.`,
    holderAxis: (d, w) => `„${w.text(d.text)}“: Der Schaft liegt längs X oder längs Z.`,
    holderHead: (d, w) =>
      `„${w.text(d.text)}“ ist kein Umriss. Jede Ecke ist Z/X ab der Spitze, Ecken durch Leerzeichen getrennt, ` +
      "Teile durch Semikolon; ein Teil braucht drei Ecken.",
    betterTool: (d) => `Werkzeug ${d.tool} ${d.name} kann diese Kontur fertigen.`,
    startInArea: (d, w) =>
      `Der Startpunkt ${w.place(d.x, d.z)} liegt im Zerspanbereich: Das Werkzeug fährt zuerst auf Sicherheitsabstand.`,
    startInMaterial: (d, w) => `Der Startpunkt ${w.place(d.x, d.z)} steht im Material.`,
    startBelowContour: (d, w) =>
      `Der Startpunkt liegt ${w.length(d.below)} unter dem Konturstart: Das Werkzeug fährt zuerst dorthin.`,
    startBehindContour: (d, w) =>
      `Der Startpunkt liegt ${w.length(d.behind)} hinter dem Konturstart: Das Werkzeug fährt zuerst in Z auf den Sicherheitsabstand von ${w.size(
        d.clearance,
      )} davor.`,
    startInPart: (d, w) =>
      `Der Startpunkt liegt im Fertigteil: Von dort wird nichts zerspant. Ein Startpunkt, der geht: ${w.place(d.x, d.z)}.`,
    insertAcrossAxis: (d, w) =>
      `Die Schneidplatte reicht ${w.length(d.reach)} über die Drehachse und verletzt dort das Fertigteil.` +
      (d.nearest === undefined
        ? " Für diese Bohrung ist sie zu lang."
        : ` Mit dem Startpunkt ab X${w.diameter(d.nearest)} bleibt sie frei.`),
    boreMissing: (d, w) =>
      `Die Bohrung fehlt: Ab Z${w.signed(d.z)} ist das Material voll, der Zyklus geht bis Z${w.signed(
        d.to,
      )}. Erst bis dorthin mit mindestens ${w.diameter(d.need)} vorbohren.`,
    startOnWrongSide: (d, w) =>
      `Die Kontur läuft auf den Startpunkt zu: Von dort wird nichts zerspant. Ein Startpunkt, der geht: ${w.place(d.x, d.z)}.`,
    startInsideEnvelope: (d, w) =>
      `Der Startpunkt liegt näher an der Kontur als der Abstand ${w.size(d.clearance)}: Das Werkzeug fährt ` +
      "mit Schlichtvorschub direkt zur Kontur.",
    limitOnWrongSide: (d, w) =>
      `Mit der Grenze ${w.value(d.limit)} wird auf der Seite des Werkzeugs nichts zerspant.${nearest(d.nearest, w.value)}`,
    cutBehindLimit: (d, w) =>
      `Hinter der Grenze werden bei ${w.place(d.x, d.z)} ${w.area(
        d.area,
      )} Material zerspant: Begrenzt ist nur die Kontur, nicht An- und Wegfahren.` +
      (d.finishing
        ? " Schruppen allein (Q215 = 1) lässt es stehen."
        : " Setzen Sie die Grenze dorthin, wo diese kein Material treffen."),
    nothingToCut: () => "Zwischen Startpunkt und Kontur gibt es nichts zu zerspanen.",
    contourMissing: (d, w) =>
      d.label === "" ? "Die Kontur fehlt." : `Die Kontur LBL ${w.text(d.label)} gibt es nicht.`,
    contourTooShort: () => "Eine Kontur braucht mindestens zwei verschiedene Punkte.",
    contourFlat: (d) => `Start und Ende der Kontur haben dasselbe ${d.axis}: Dazwischen ist nichts zu zerspanen.`,
    contourEndCovered: (d, w) =>
      `Die Kontur endet bei ${w.place(
        d.x,
        d.z,
      )} in sich selbst: Ein Element reicht über dieses Ende hinaus, das Teil geht dort nicht weiter.`,
    contourPoint: (d) => `Element ${d.element}: Der Endpunkt fehlt oder ist nicht erreichbar.`,
    cornerElementAlone: (d) =>
      `Element ${d.element}: Fase und Rundung brauchen ein Element davor und dahinter, eine Fase zwei Geraden.`,
    cornerElementTooLong: (d, w) =>
      `Element ${d.element}: ${w.size(d.size)} passt nicht zwischen die Nachbarelemente: höchstens ${w.size(d.max)}` +
      `.`,
    arcOffCircle: (d, w) => `Element ${d.element}: Der Endpunkt verfehlt den Kreis um ${w.size(d.gap)}.`,
    arcTooSmall: (d, w) => `Element ${d.element}: Radius ${w.size(d.radius)} ist zu klein für den Endpunkt.`,
    elementFree: (d) =>
      d.freedom === 1
        ? `Element ${d.element}: Noch 1 Angabe ist nötig.`
        : `Element ${d.element}: Noch ${d.freedom} Angaben sind nötig.`,
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
      )} in Element ${d.other} ein: Es passt` +
      ` nicht hindurch; die Steuerung vergleicht nur Nachbarn.${nearest(d.nearest, w.size)}`,
    approachNeedsSide: () => "CT braucht RL oder RR: Mit R0 hält die Steuerung hier an.",
    approachSideAssumed: () =>
      "R0 nennt keine Seite: Angenommen wird, dass das Werkzeug von links der Kontur kommt. An der Steuerung prüfen.",
    approachInsideCircle: (d, w) =>
      `${d.point} liegt im Kreis mit R ${w.size(d.radius)}: Keine Gerade von dort berührt ihn.${nearest(d.nearest, w.size)}`,
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
      `Element ${d.element}: Ein Freistich braucht einen achsparallelen Zylinder und eine Planfläche dazu, ein Einstich ein ` +
      "gerades Element seiner Richtung.",
    recessWord: (d) => `Element ${d.element}: ${d.word} fehlt oder ergibt keine mögliche Form.`,
    recessWordsExclusive: (d) =>
      `Element ${d.element}: ${d.other} und ${d.word} schließen sich aus. Nur eines davon eingeben.`,
    pitchNotListed: (d, w) => {
      const near = [d.below, d.above].flatMap((n) => (n === undefined ? [] : [w.size(n, 4)])).join(" und ");
      return `Element ${d.element}: DIN 76 nennt keinen Freistich für Steigung ${w.size(
        d.pitch,
        4,
      )}; daneben stehen ${near}. Eine davon nehmen oder ${d.words} angeben.`;
    },
    undercutDefaults: (d) =>
      `Element ${d.element}: ${d.words} nach der Norm, für diese Steuerung nicht gedruckt; sicherer ist es, die Werte selbst anzugeben.`,
    materialLeft: (d, w) =>
      d.asked === undefined
        ? `Restmaterial bei ${w.place(d.x, d.z)}: ${w.area(d.area)}. Grund: ${reasons[d.reason]}.`
        : d.reason === "oversize"
          ? `Bei ${w.place(d.x, d.z)} bleiben ${w.area(d.area)} Aufmaß stehen, wie vorgegeben.`
          : `Die Ecke bei ${w.place(d.x, d.z)} hat den Radius der Schneide: ${w.area(
              d.area,
            )} bleiben stehen. Ein anderer Radius ist nicht vorgegeben.`,
    gouge: (d, w) => `Konturverletzung bei ${w.place(d.x, d.z)}: ${w.area(d.area)} des Fertigteils weggeschnitten.`,
    rapidInStock: (d, w) => `Eine Eilgangbewegung fährt bei ${w.place(d.x, d.z)} durch ${w.area(d.area)} Material.`,
    holderContact: (d, w) => `Der Halter berührt bei ${w.place(d.x, d.z)} das Material.`,
    cutBelowContour: (d, w) =>
      `Dieser Schnitt geht bei ${w.place(d.x, d.z)} um ${w.area(
        d.area,
      )} unter die Kontur des Zyklus in Satz ${d.block}. Ist er gewollt, bestätigen Sie ihn.`,
    cameLoose: (d, w) =>
      `${{ piece: "Ein Stück", ring: "Ein Ring", slug: "Ein Butzen" }[d.shape]} von ${w.area(d.area)} bei ${w.place(
        d.x,
        d.z,
      )} hängt nicht mehr ` + `mit dem gespannten Ende zusammen: Satz ${d.block} trennt es ab.`,
    partedOff: (d, w) =>
      `Das Stück bei ${w.place(d.x, d.z)}, ${w.area(d.area)}, wird in Satz ${d.block} abgestochen und verlässt das Bild.`,
    cutOnLoosePiece: (d, w) =>
      `Bei ${w.place(d.x, d.z)} würden ${w.area(
        d.area,
      )} von einem Stück abgetragen, das Satz ${d.block} abgetrennt hat: nichts hält es mehr.`,
    behindBlank: (d, w) =>
      d.motion === "unheld"
        ? `Außen wird bis zum hinteren Ende des Rohteils bei Z${w.size(
            d.rear,
          )} gedreht: Zum Spannen bleibt nichts. Geben Sie die Spannung an, wenn es anders gehalten wird.`
        : `${d.motion === "rapid" ? "Eine Eilgangbewegung fährt" : "Das Werkzeug schneidet"} hinter dem hinteren Ende des Rohteils bei Z${w.size(
            d.rear,
          )}, bei ${w.place(d.x, d.z)}: Dort steht das Spannmittel.`,
    clampContact: (d, w) =>
      `${d.by === "tool" ? "Das Werkzeug" : "Der Halter"} stößt bei ${w.place(d.x, d.z)} an ${
        CLAMPED[d.part]
      }. Schnitt davor beenden oder anders spannen.`,
    contactsUnlooked: (d) =>
      `${d.limit} Bewegungen verletzen die Kontur, fahren im Eilgang ins Material oder berühren es mit dem Halter: Ab hier wird ` +
      "danach nicht mehr gesucht.",
    deeperThanInfeed: (d, w) =>
      "" +
      (d.pass === undefined ? "Ein Glätt- oder Schlichtschnitt" : `Schnitt ${w.number(d.pass)}`) +
      ` nimmt ${w.length(d.depth)} Material auf einmal; erlaubt sind ${w.length(d.allowed)}.`,
    blankLacks: (d, w) =>
      `${w.text(d.what)} lässt ${w.area(d.area)} von dem Material aus, das laut Programm dort steht. Der Umriss gilt.`,
    blankGone: (d, w) =>
      `${w.text(d.what)} umreißt ${w.area(d.area)}, wo nichts mehr steht. Was abgetragen ist, bleibt abgetragen.`,
    nothingCut: () => "Diese Bearbeitung trägt kein Material ab.",
    airPasses: (d) =>
      d.count === 1 ? "1 Schnitt berührt kein Material." : `${d.count} Schnitte berühren kein Material.`,

    notUnderstood: (d, w) => `„${w.text(d.text)}“ wird nicht verstanden: bleibt im Programm, wird nicht simuliert.`,
    wordNotUnderstood: (d, w) => `Das Wort „${w.text(d.text)}“ wird nicht verstanden.`,
    wordTwice: (d, w) => `${w.text(d.word)} steht zweimal im Satz; das letzte gilt.`,
    equalsMissing: (d, w) =>
      `In „${w.text(d.text)}“ fehlt das Gleichheitszeichen. Es wird so gelesen, als stünde es da.`,
    blankBeforeEquals: (d, w) => `In „${w.text(d.text)}“ steht ein Leerzeichen vor dem Gleichheitszeichen.`,
    badNumber: (d, w) => `„${w.text(d.text)}“ ist keine Zahl.`,
    wordMissing: (d, w) => `${w.text(d.word)} fehlt in diesem Satz.`,
    blockNumber: (d) => `Satznummer ${d.found} passt nicht in die Reihenfolge; ${d.expected} wäre an der Reihe.`,
    blockNumberMissing: (d) => `Der Satz hat keine Nummer; ${d.expected} wäre an der Reihe.`,
    listWithoutTilde: (d) =>
      `${d.places === 1 ? "In einer Zyklusliste fehlt" : `In ${d.places} Zykluslisten fehlt`} das ~ am Zeilenende: Eine Steuerung lädt ` +
      "das Programm so nicht.",
    continuationOpen: () => "Die Zeile endet mit ~, aber es folgt keine Fortsetzung.",
    isoProgram: () => "Der Text ist DIN/ISO. Als eigenes Programm öffnen: Dabei wird er in Klartext übersetzt.",
    frameMissing: (d) => `Dem Programm fehlt ${d.which}.`,

    notSimulated: (d, w) => `${w.text(d.what)}: bleibt im Programm, wird nicht simuliert.`,
    notProved: (d, w) =>
      `${w.text(d.what)} wird nicht simuliert und kann Bahn oder Rohteil verändern: Ab hier ist nichts geprüft.`,
    cycleNotSimulated: (d, w) => `Zyklus ${d.cycle} ${w.text(d.name)}: bleibt im Programm, wird nicht simuliert.`,
    noCycleDefined: () => "Vor dem Aufruf ist kein Zyklus definiert.",
    noToolCalled: () => "Vor diesem Satz ist kein Werkzeug aufgerufen.",
    toolUnknown: (d, w) => `Werkzeug ${w.text(d.tool)} steht nicht in der Tabelle.`,
    notInTurnMode: () => "Der Zyklus läuft nur in FUNCTION MODE TURN: diesen Satz vor dem Aufruf programmieren.",
    compensationActive: (d) =>
      `Hier ist ${d.side} aktiv, die Steuerung verlangt R0: R0 im Positioniersatz davor programmieren.`,
    feedZero: (d, w) =>
      `${w.text(d.word)}: Der Schnittvorschub ist hier 0. Einen Vorschub über 0 angeben; FAUTO nimmt das F aus TOOL CALL.`,
    feedUnlikely: (d, w) =>
      `Ein Vorschub von ${w.number(d.feed)} ${d.unit} ist unwahrscheinlich. M136 prüfen: Damit zählt F in mm pro Umdrehung.`,
    drillTooShort: (d, w) =>
      `Die Bohrung ist ${w.size(d.depth)} tief, die Schneiden des Bohrers (LCUTS) sind ${w.size(d.edges)} lang: Der Schaft kann reiben.`,
    pitchOfTap: (d, w) =>
      `Q239 ist ${w.size(d.pitch)}, der Gewindebohrer in der Tabelle hat aber PITCH ${w.size(d.tap)}.`,
    freeChosen: () =>
      "Ab hier passen mehrere Konturen zu den Angaben: Die kürzeste wird gezeigt. Die Steuerung nimmt die, die FSELECT auswählt.",
    freeUnsolved: (d, w) =>
      `${w.text(d.form)}: Die Angaben bestimmen dieses Element nicht oder widersprechen sich. Mehr Angaben machen oder FSELECT wählen.`,
    cycleNeverCalled: (d) =>
      `Zyklus ${d.cycle} ist definiert und wird nie aufgerufen: Dahinter fehlt CYCL CALL oder M99.`,
    neverReached: (d) => `Das Programm endet mit ${d.by} vor diesem Satz: Er wird nie ausgeführt.`,
    listOfOlderSoftware: (d, w) =>
      `Die Liste von Zyklus ${d.cycle} stammt von einem älteren Softwarestand. Die Steuerung ergänzt: ${d.filled
        .map((word) => w.text(word))
        .join(", ")}.`,
    parameterForeign: (d, w) =>
      `${w.text(d.name)} gehört nicht hierher: Zyklus ${d.cycle} hat diesen Parameter nicht, oder er steht zweimal.`,
    runsIntoLabel: (d, w) => `Das Programm läuft in die Kontur von LBL ${w.text(d.label)} hinein: Davor fehlt M30.`,
    contourStartIncomplete: (d) => `Der erste Satz der Kontur braucht X und Z; ${d.axis} fehlt.`,
    approachUncompensated: (d) => `${d.form} hat kein RL oder RR: Die Kontur dahinter läuft ohne Radiuskorrektur.`,
    labelMissing: (d, w) => `LBL ${w.text(d.label)} gibt es nicht.`,
    labelTwice: (d, w) => `LBL ${w.text(d.label)} steht zweimal im Programm.`,
    labelNotClosed: (d, w) => `LBL ${w.text(d.label)} wird nicht mit LBL 0 abgeschlossen.`,
    contourNotNamed: (d) => `Zyklus ${d.cycle} braucht vor dem Aufruf Zyklus 14 mit seiner Kontur.`,
    contoursJoined: (d, w) =>
      `${w.text(d.joined)}: Hier ergeben mehrere Konturen eine. Zyklus ${w.number(
        d.cycle,
      )} nimmt eine Kontur; seine Bahn wird nicht gezeigt.`,
    errorRaised: (d, w) =>
      d.error === null
        ? "FN 14: Die Steuerung hält hier mit einem Fehler an; dahinter läuft nichts."
        : `FN 14: Die Steuerung hält hier mit Fehler ${w.number(d.error)} an; dahinter läuft nichts.`,
    contourInFile: (d, w) =>
      `Die Kontur steht in der Datei ${w.text(d.file)}, die hier nicht vorliegt: Sie in ein Label schreiben und mit Zyklus 14 nennen.`,
    feedMissing: () => "Es ist kein Vorschub programmiert.",
    spindleMissing: () => "Es ist keine Spindeldrehzahl programmiert; Zeiten fehlen.",
    parameterUnset: (d) => `${d.name} hat hier keinen Wert.`,
    divisionByZero: () => "Division durch 0.",
    notFinite: (d, w) => `„${w.text(d.text)}“ ergibt keine brauchbare Zahl.`,
    clampingUnread: (d, w) => `CLAMPING: „${w.text(d.what)}“ ist nicht verständlich und zählt nicht.`,
    clampingIncomplete: (d) =>
      `CLAMPING zählt nicht: ${d.words} fehlt oder ist unmöglich. Von der Spannung ist nichts bekannt.`,
    clampingTwice: () => "CLAMPING steht zweimal: das erste zählt. Dieses löschen.",
    clampingMisses: (d, w) =>
      `Die Spannung fasst das Rohteil nicht: Im Spannbereich liegt keine Fläche mit ${w.diameter(
        d.diameter,
      )}. ⌀, Länge und Lage von CLAMPING prüfen.`,
    blankMissing: () => "Das Programm nennt kein Rohteil.",
    blankNotTurned: (d, w) => `Ein Rohteil der Form ${w.text(d.form)} ist kein Drehkörper um die Achse.`,
    endsExchanged: (d, w) =>
      d.axis === "X"
        ? `Von X${w.diameter(d.start)} nach X${w.diameter(d.end)} ist kein Material zu zerspanen. Anfang und Ende (${d.other}) vertauscht?`
        : `Von Z${w.signed(d.start)} nach Z${w.signed(d.end)} ist kein Material zu zerspanen. Anfang und Ende (${d.other}) vertauscht?`,
    endInFront: (d, w) => `Z${w.signed(d.value)} liegt vor dem Werkstück. ${w.signed(d.nearest)}?`,
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
        allowance: `Die Kontur beginnt bei Z${w.signed(d.contour)}, das Rohteil erst bei Z${w.signed(
          d.blank,
        )}: Das sind Luftschnitte. Vorschlag: ${w.signed(d.nearest)}.`,
        thread: `Das Gewinde hat ${w.diameter(d.contour)}, das Rohteil ${w.diameter(d.blank)}. Vorschlag: ${w.diameter(d.nearest)}.`,
      })[d.place],
    blankImpossible: () => "Das Rohteil hat kein Volumen: Maße prüfen.",
    boxTurned: (d, w) =>
      `Der Quader dreht sich als Zylinder um seine Ecken, Durchmesser ${w.size(d.outer)}. Nur innerhalb von Durchmesser ${w.size(
        d.inner,
      )} steht ringsum sicher Material. ` + "Rundmaterial ist ein BLK FORM CYLINDER.",
    blankTaken: (d, w) => `${w.text(d.what)} wird als Rohteil genommen.`,
    blankAdds: (d, w) => `${w.text(d.what)} umreißt ${w.area(d.area)} mehr, als BLK FORM hat. Der Umriss gilt.`,
    blankTraced: () =>
      "Während der Rohteilnachführung lässt das Schruppen Zustellungen aus, die kein Material berühren. " +
      "Andere Leerwege, die die Steuerung kürzen kann, werden ganz gezeigt.",
    poleMissing: () => "Der Satz braucht davor einen Pol CC.",
    startUnknown: () => "Die Position vor diesem Satz ist nicht bekannt.",
    arcImpossible: () => "Zu diesen Werten gibt es keinen Bogen.",
    radiusCompensation: (d) => `${d.side} wird gelesen, die Bahn aber nicht korrigiert.`,
    compensationUndefined: (d) =>
      `${d.side} mit Schneidenlage TO ${d.orientation}: Die Richtung der Korrektur ist nicht eindeutig. Ein Werkzeug verwenden, dessen ` +
      "Schneide in eine Ecke zeigt, oder die Bahn mit R0 programmieren.",
    sideChanged: () => "Zwischen RL und RR braucht die Steuerung einen Satz mit R0.",
    approachWithoutContour: (d) => `${d.form} braucht ein Konturelement neben sich.`,
    lengthDelta: (d) =>
      `DZL und DXL von Werkzeug ${d.tool}: Die Steuerung rechnet sie zu den Werkzeuglängen. Die Schneidenspitze bleibt auf der ` +
      "Bahn; Bahn und Werkstück ändern sich nicht.",
    toolRadiusUnknown: (d, w) =>
      `Der Radius von Werkzeug ${w.text(d.tool)} ist nicht bekannt: Die Bahn ist mit Radius 0 gerechnet.`,
    wordsRecalled: (d, w) =>
      `${w.text(d.what)}: Die Wörter sind aus der Erinnerung, nicht an einer gedruckten Seite geprüft. An der Steuerung prüfen.`,
    programEndMissing: () => "Am Ende des Hauptprogramms fehlt M30 oder M2.",
    tooManyBlocks: (d) =>
      `Mehr als ${d.limit} Sätze wurden ausgeführt: dort angehalten. Hat es weniger, endet ein Sprung oder eine Wiederholung nie.`,
    tooManyMoves: (d) => `Mehr als ${d.limit} Bewegungen: dort angehalten.`,
    contourTooLong: (d) => `Die Kontur hat mehr als ${d.limit} Sätze: dort angehalten.`,
    tooManyOperations: (d) => `Mehr als ${d.limit} Zyklusaufrufe: dort angehalten.`,
    moreAlike: (d, w) =>
      `Ab hier sind ${w.number(d.count)} weitere Befunde derselben Art (${d.code}) nur gezählt, nicht aufgeführt.`,
    callsTooDeep: (d) => `Label-Aufrufe sind mehr als ${d.limit}-fach verschachtelt.`,
    programsTooDeep: (d) =>
      `Programmaufrufe sind mehr als ${d.limit}-fach verschachtelt: Ein Programm ruft sich endlos selbst auf. Dort angehalten.`,
    endInCalled: (d) =>
      `${d.word} steht in einem aufgerufenen Programm, was die Steuerung nicht erlaubt: Das aufrufende läuft hinter dem Aufruf weiter.`,
    programNotOpened: (d, w) =>
      `${w.text(d.file)} ist nicht geöffnet: Zusammen mit diesem Programm öffnen, dann wird es mit ausgeführt.`,
    programNotSelected: () => "CALL SELECTED PGM braucht ein Programm, das SEL PGM vorher genannt hat.",
  },
} satisfies MessagesTexts;

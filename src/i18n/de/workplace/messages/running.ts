import type { Sentences } from "../../../message-texts.ts";

const RULES = {
  signOfAngle: (word: string) =>
    `Winkel und DR haben verschiedene Vorzeichen (${word}): Die Steuerung lehnt den Bogen ab. Beiden dasselbe Vorzeichen geben.`,
  zeroBehindCorner: (word: string) =>
    `Dieser Satz hinter ${word} bewegt nichts: Mit einem Element der Länge 0 kann die Steuerung keine Ecke runden oder fasen.`,
  emptyCentre: (word: string) =>
    `${word} ohne Koordinaten übernimmt den letzten Punkt, der Satz davor nennt aber nur eine ` +
    `Achse: dort oder in ${word} beide Koordinaten programmieren.`,
  sideOnArc: (word: string) =>
    `Die Radiuskorrektur darf nicht auf einem Kreisbogen beginnen (${word}): RL oder RR in einem Geradensatz davor programmieren.`,
  toolCallCompensated: (word: string) =>
    `Bei diesem TOOL CALL ist ${word} aktiv: Die Steuerung lehnt ihn ab. Vorher R0 programmieren.`,
};

/** What holds while a program runs: spindle, speeds, holes, and the printed rules of the control. */
export const running = {
  spindleStopped: ({ how, block }) => {
    const by = block === undefined ? "" : ` in Satz ${block}`;
    return {
      stopped:
        block === undefined
          ? "Die Spindel steht hier: Kein M3, M4, M303 oder M304 hat sie gestartet."
          : `Die Spindel steht hier: Satz ${block} hat sie angehalten. Vor diesem Schnitt M3, M4, M303 oder M304 programmieren.`,
      noSpeed: "Die Spindel hat hier keine Drehzahl: vor diesem Schnitt FUNCTION TURNDATA SPIN programmieren.",
      hand: `Die Spindel dreht für dieses Werkzeug in die falsche Richtung, festgelegt${by}. Die andere Drehrichtung programmieren.`,
    }[how];
  },
  holeMissing: ({ tool, diameter, z }, w) =>
    `Werkzeug ${tool} fährt im Vorschub bis Z${w.signed(z)}, wo keine Bohrung ist: vorher mit mindestens ${w.diameter(diameter)} bohren.`,
  speedUnlimited: ({ diameter, block }, w) =>
    `Die konstante Schnittgeschwindigkeit hat kein SMAX, und Satz ${block} kommt bis ${w.diameter(
      diameter,
    )}: Dort steigt die Drehzahl unbegrenzt. ` + "SMAX programmieren.",
  speedUnlikely: ({ speed, most, of }, w) =>
    of === "material"
      ? `Eine Schnittgeschwindigkeit von ${w.number(speed)} m/min ist mehr, als Werkstoffe beim Drehen zulassen (${w.number(most)} m/min).`
      : `${w.number(speed)} 1/min sind mehr, als die Spindel der Maschine kann (${w.number(most)} 1/min).`,
  offCentre: ({ y }, w) =>
    `Das Werkzeug dreht ${w.length(
      y,
    )} in Y neben der Mitte: Was es dort zerspant, ist nicht geprüft. Y+0 programmieren und die Verschiebung in Y zurücknehmen.`,
  toolIndexUnknown: ({ tool, rows }, w) =>
    `Werkzeug ${w.text(tool)} steht nicht in der Tabelle: ${
      rows.length > 0 ? `Von diesem Werkzeug hat sie ${rows.join(", ")}` : "Sie hat keine Zeile dieses Werkzeugs"
    }.`,
  firstElement: ({ word }, w) =>
    `Eine Kontur darf nicht mit ${w.text(
      word,
    )} beginnen: Die Steuerung kennt keinen Punkt davor. Mit einem Geradensatz beginnen, der X und Z nennt.`,
  controlRule: ({ rule, word }, w) => RULES[rule](w.text(word)),
} satisfies Partial<Sentences>;

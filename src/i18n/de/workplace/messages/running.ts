import type { Sentences } from "../../../message-texts.ts";

const RULES = {
  signOfAngle: (word: string) =>
    `Winkel und DR haben verschiedene Vorzeichen (${word}): Die Steuerung lehnt den Kreisbogen ab. Gleiches Vorzeichen programmieren.`,
  zeroBehindCorner: (word: string) =>
    `Dieser Satz nach ${word} hat die Länge 0: Die Steuerung kann damit keine Ecke runden oder fasen.`,
  emptyCentre: (word: string) =>
    `${word} ohne Koordinaten übernimmt den letzten Punkt, der Satz davor enthält aber nur eine Achse: dort oder in ${word} beide Koordinaten programmieren.`,
  sideOnArc: (word: string) =>
    `Die Radiuskorrektur darf nicht auf einem Kreisbogen beginnen (${word}): RL oder RR in einem Geradensatz davor programmieren.`,
  toolCallCompensated: (word: string) =>
    `Bei diesem TOOL CALL ist ${word} aktiv: Die Steuerung lehnt ihn ab. Vorher R0 programmieren.`,
};

/** Messages about a running program: spindle, speeds, holes, and the printed rules of the control. */
export const running = {
  spindleStopped: ({ how, block }) => {
    const by = block === undefined ? "" : ` in Satz ${block}`;
    return {
      stopped:
        block === undefined
          ? "Die Spindel steht hier: M3, M4, M303 oder M304 fehlt."
          : `Die Spindel steht hier, gestoppt in Satz ${block}. Vor diesem Schnitt M3, M4, M303 oder M304 programmieren.`,
      noSpeed: "Die Spindel hat hier keine Drehzahl: vor diesem Schnitt FUNCTION TURNDATA SPIN programmieren.",
      hand: `Falsche Spindeldrehrichtung für dieses Werkzeug, festgelegt${by}. Andere Drehrichtung programmieren.`,
    }[how];
  },
  toolLimit: ({ tool, column, value, limit, x, z }, w) =>
    ({
      DAXN: `Werkzeug ${tool} sticht axial auf ${w.diameter(value)}; die Klinge ist erst ab ${w.diameter(limit)} geeignet (DAXN) und reibt an der Außenwand.`,
      DAXX: `Werkzeug ${tool} sticht axial auf ${w.diameter(value)}; die Klinge ist nur bis ${w.diameter(limit)} geeignet (DAXX) und reibt an der Innenwand.`,
      CDX: `Werkzeug ${tool} steckt bei ${w.place(x, z)} ${w.length(value)} tief im Material; die Stechtiefe ist ${w.length(limit)} (CDX).`,
      CUTDIA: `Werkzeug ${tool} sticht ${w.diameter(value)} ab; es ist bis ${w.diameter(limit)} geeignet (CUTDIA).`,
      DMIN: `Werkzeug ${tool} steht bei ${w.place(x, z)} in einer Bohrung von ${w.diameter(value)}; es braucht ${w.diameter(limit)} (DMIN).`,
    })[column],
  holeMissing: ({ tool, diameter, z }, w) =>
    `Werkzeug ${tool} fährt im Vorschub bis Z${w.signed(z)}, wo keine Bohrung ist: vorher mit mindestens ${w.diameter(diameter)} bohren.`,
  speedUnlimited: ({ diameter, block }, w) =>
    `Konstante Schnittgeschwindigkeit ohne SMAX, und Satz ${block} erreicht ${w.diameter(
      diameter,
    )}: Dort ist die Drehzahl unbegrenzt. ` + "SMAX programmieren.",
  speedUnlikely: ({ speed, most, of }, w) =>
    of === "material"
      ? `Schnittgeschwindigkeit ${w.number(speed)} m/min überschreitet das Maximum beim Drehen (${w.number(most)} m/min).`
      : `${w.number(speed)} 1/min überschreiten die maximale Spindeldrehzahl der Maschine (${w.number(most)} 1/min).`,
  offCentre: ({ y }, w) =>
    `Das Werkzeug liegt in Y ${w.length(y)} außermittig: Der Schnitt ist nicht geprüft. Y+0 programmieren und die Verschiebung in Y aufheben.`,
  toolIndexUnknown: ({ tool, rows }, w) =>
    `Werkzeug ${w.text(tool)} ist nicht in der Tabelle: ${
      rows.length > 0 ? `von diesem Werkzeug nur ${rows.join(", ")}` : "keine Zeile dieses Werkzeugs"
    }.`,
  firstElement: ({ word }, w) =>
    `Eine Kontur darf nicht mit ${w.text(
      word,
    )} beginnen: Davor ist kein Punkt bekannt. Mit einem Geradensatz mit X und Z beginnen.`,
  controlRule: ({ rule, word }, w) => RULES[rule](w.text(word)),
} satisfies Partial<Sentences>;

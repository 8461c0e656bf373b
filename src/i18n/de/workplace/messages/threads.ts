import type { MessagesTexts } from "../../../message-texts.ts";
import type { Write } from "../../../write.ts";

/** The value that a finding proposes, if any. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Vorschlag: ${say(value)}.`;

const ALL_ALONG =
  " Kein üblicher Anlaufweg vermeidet das: Gewinde am freien Ende beginnen oder dort vorher einen Freistich drehen.";
/** A position on the synchronized axis of a thread: Z, or a diameter in a face. */
const placeOn = (axis: "X" | "Z", value: number, w: Write): string =>
  axis === "X" ? `X${w.diameter(value)}` : `Z${w.signed(value)}`;

export const threads = {
  pitchZero: () => "Ein Gewinde benötigt eine Steigung größer als 0.",
  depthFromPitch: (d, w) =>
    `Tiefe aus der Steigung, metrisches ISO-Profil: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} auf den Radius.`,
  depthOfOtherProfile: (d, w) =>
    `Q473 = 0 verwendet die Tiefe des metrischen Profils: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(
      d.depth,
    )}. Dieser Faktor gilt für 60°; die Schneide hat ${w.angle(d.angle)}. ${
      d.right === undefined
        ? d.nearest === undefined
          ? "Gewindetiefe dieses Profils eingeben."
          : "Trapezgewinde (30°): halbe Steigung plus Spitzenspiel."
        : `Whitworth (55°): ${w.number(d.right)} × Steigung.`
    }${nearest(d.nearest, w.size)}`,
  toothAssumed: (d, w) =>
    `CUTLENGTH des Gewindewerkzeugs ist leer: Angenommen wird die Zahnhöhe ${w.length(d.height)}. Zahnhöhe eingeben, um Absätze neben dem Gewinde mit der tatsächlichen Schneide zu prüfen.`,
  threadOverInsert: (d, w) =>
    `Tiefe ${w.length(d.depth)} ist größer als die Zahnhöhe ${w.length(d.most)}. Gewindewerkzeug mit höherem Zahn (CUTLENGTH) verwenden.`,
  threadTooSteep: (d, w) =>
    `Das Gewinde steigt mit ${w.angle(d.angle)} an: Die Flanken der Schneide erlauben weniger als ${w.angle(d.most)}. Einen flacheren Kegel eingeben oder die Gewindeachse wechseln.`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `Im ${d.place === "before" ? "Anlaufweg" : "Überlaufweg"} fährt das Werkzeug ins Material. `}Bei ${w.place(
      d.x,
      d.z,
    )} sind ${w.length(d.over)} Material über den Gewindespitzen${
      d.most === undefined
        ? d.place === "over"
          ? ": Der erste Schnitt trägt auch dieses Material ab, zwischen den Gängen bleibt es."
          : "."
        : `; die Schneide hat Freiraum für ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `Mit ${w.angle(d.angle)} verletzen die Schnitte die fertige Flanke: max. der halbe Spitzenwinkel, ${w.angle(d.most)}.` +
    nearest(d.nearest, w.angle),
  runOutTooLong: (d, w) =>
    `Der Auslauf von ${w.size(d.size)} ist länger als das Gewinde: max. ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) =>
    `Das Gewinde muss von Start bis Ende entlang ${d.axis} in einer Richtung verlaufen: Diese Achse läuft synchron zur Spindel.`,
  runInBlocked: (d, w) =>
    `Am Beginn des Anlaufwegs, ${w.place(d.x, d.z)}, wäre das Werkzeug im Material.${
      d.nearest === undefined ? ALL_ALONG : nearest(d.nearest, w.size)
    }`,
  threadSurfaceSpeed: (d, w) =>
    `Gewinde mit konstanter Schnittgeschwindigkeit (VCONST:ON, ${w.number(d.cuttingSpeed)} m/min): Die Drehzahl folgt dem Durchmesser${
      d.slow === undefined || d.fast === undefined ? "" : `, von ${w.number(d.slow)} bis ${w.number(d.fast)} 1/min`
    }; die Schnitte treffen womöglich nicht denselben Gang. VCONST:OFF mit S programmieren.`,
  threadOverruns: (d, w) =>
    `Das Gewinde endet bei ${placeOn(d.axis, d.end, w)} mit Überlauf bis ${placeOn(d.axis, d.to, w)}; ${
      d.meets === "shaft" ? "Konturverletzung" : "die Flanke der Schneide trifft den Absatz, Konturverletzung"
    } bei ${w.place(d.x, d.z)}: ${w.area(d.area)}. Gewinde früher enden lassen (Q494), Gewindeauslauf (Q474) angeben oder ` +
    "vorher einen ausreichend breiten Freistich (DIN 76) drehen.",
  crestMissing: (d, w) =>
    `An den Gewindespitzen fehlen ${w.length(d.missing)}: zu wenig Material. Richtig: ${
      "diameter" in d ? w.diameter(d.diameter) : `Z${w.signed(d.z)}`
    }.`,
  threadTooMany: (d, w) =>
    `${w.number(d.turns)} Spindelumdrehungen in allen Schnitten überschreiten das Maximum ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `Mit dem Winkel ${w.angle(d.angle)} hat das Gewinde keinen Endpunkt.`,
  threadFeedOverLimit: (d, w) =>
    `Drehzahl ${w.number(d.speed)} × Steigung = ${w.feed(d.feed, "mm/min")} überschreitet den maximalen Achsvorschub ${w.feed(d.most, "mm/min")}. Max. ${w.number(d.upTo)} 1/min.`,
  runInShort: (d, w) =>
    `Bei ${w.number(d.speed)} 1/min ist der Anlaufweg von ${w.size(d.runIn)} zu kurz für den Vorschub. Faustregel: Drehzahl × Steigung / 400 = ${w.length(d.needed)}.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;

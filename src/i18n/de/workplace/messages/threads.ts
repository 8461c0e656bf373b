import type { MessagesTexts } from "../../../message-texts.ts";
import type { Write } from "../../../write.ts";

/** What a finding offers, where it offers something. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Nächster möglicher Wert: ${say(value)}.`;

const ALL_ALONG =
  " Kein üblicher Anlauf führt daran vorbei: Gewinde am freien Ende beginnen oder dort vorher einen Freistich drehen.";
/** A place on the axis that a thread runs along: a Z, or in a face a diameter. */
const placeOn = (axis: "X" | "Z", value: number, w: Write): string =>
  axis === "X" ? `X${w.diameter(value)}` : `Z${w.signed(value)}`;

export const threads = {
  pitchZero: () => "Ein Gewinde braucht eine Steigung größer als 0.",
  depthFromPitch: (d, w) =>
    `Tiefe aus der Steigung, metrisches ISO-Profil: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} im Radius.`,
  depthOfOtherProfile: (d, w) =>
    `Q473 = 0 nimmt die Tiefe des metrischen Profils: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(
      d.depth,
    )}. Dieser Faktor gehört zu ` +
    `60°; die Schneide hat ${w.angle(d.angle)}. ${
      d.right === undefined
        ? "Gewindetiefe ihres Profils eingeben."
        : `Whitworth (55°): ${w.number(d.right)} × Steigung.`
    }${nearest(d.nearest, w.size)}`,
  toothAssumed: (d, w) =>
    `CUTLENGTH des Gewindewerkzeugs ist leer: Als Zahnhöhe gelten ${w.length(
      d.height,
    )}. Zahnhöhe eingeben, damit Absätze neben dem Gewinde mit ` + "der wirklichen Schneide geprüft werden.",
  threadOverInsert: (d, w) =>
    `${w.length(d.depth)} sind tiefer, als die Schneide hoch ist: ${w.length(
      d.most,
    )}. Ein Gewindewerkzeug mit höherem Zahn (CUTLENGTH) nehmen.`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `Im ${d.place === "before" ? "Anlauf" : "Überlauf"} läuft das Werkzeug ins Material. `}Bei ${w.place(
      d.x,
      d.z,
    )} stehen ${w.length(d.over)} Material über den Gewindespitzen${
      d.most === undefined
        ? d.place === "over"
          ? ": Der erste Schnitt nimmt sie mit, zwischen den Gängen bleiben sie stehen."
          : "."
        : `; die Schneide hat Platz für ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `Mit ${w.angle(d.angle)} verletzen die Schnitte die fertige Flanke: höchstens der halbe Spitzenwinkel, ${w.angle(d.most)}.` +
    nearest(d.nearest, w.angle),
  runOutTooLong: (d, w) =>
    `Der Auslauf von ${w.size(d.size)} ist länger als das Gewinde: höchstens ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) =>
    `Das Gewinde muss vom Start zum Ende entlang ${d.axis} weiterlaufen: Diese Achse ist mit der Spindel gekoppelt.`,
  runInBlocked: (d, w) =>
    `Wo der Anlauf beginnt, bei ${w.place(d.x, d.z)}, stünde das Werkzeug im Material.${
      d.nearest === undefined ? ALL_ALONG : nearest(d.nearest, w.size)
    }`,
  threadSurfaceSpeed: (d, w) =>
    `Gewinde mit konstanter Schnittgeschwindigkeit (VCONST:ON, ${w.number(d.cuttingSpeed)} m/min): Die Drehzahl folgt dem Durchmesser${
      d.slow === undefined || d.fast === undefined ? "" : `, von ${w.number(d.slow)} bis ${w.number(d.fast)} 1/min`
    }; die Schnitte treffen womöglich nicht denselben Gang. VCONST:OFF mit S programmieren.`,
  threadOverruns: (d, w) =>
    `Das Gewinde endet bei ${placeOn(d.axis, d.end, w)} und läuft über bis ${placeOn(d.axis, d.to, w)}; ${
      d.meets === "shaft" ? "dort schneidet es" : "dort trifft eine Flanke der Schneide den Absatz und schneidet"
    } bei ${w.place(d.x, d.z)} ${w.area(
      d.area,
    )} des Fertigteils weg. Gewinde früher enden lassen (Q494), Gewindeauslauf (Q474) angeben oder ` +
    "vorher einen ausreichend breiten Freistich (DIN 76) drehen.",
  crestMissing: (d, w) =>
    `Den Gewindespitzen fehlen ${w.length(d.missing)}: Es ist zu wenig Material da. Richtig wäre ${
      "diameter" in d ? w.diameter(d.diameter) : `Z${w.signed(d.z)}`
    }.`,
  threadTooMany: (d, w) =>
    `${w.number(d.turns)} Spindelumdrehungen in allen Schnitten sind mehr als ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `Ein Winkel von ${w.angle(d.angle)} führt vom Anfang des Gewindes zu keinem Ende.`,
  threadFeedOverLimit: (d, w) =>
    `Drehzahl ${w.number(d.speed)} × Steigung ergibt ${w.number(d.feed)} mm/min, mehr als die Achse kann: ${w.number(d.most)}. Bis ` +
    `${w.number(d.upTo)} 1/min kann sie folgen.`,
  runInShort: (d, w) =>
    `Bei ${w.number(d.speed)} 1/min ist der Anlauf von ${w.size(d.runIn)} zu kurz für den Vorschub: Drehzahl × Steigung / 400 ergibt ` +
    `${w.length(d.needed)}. Unsere Faustregel.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;

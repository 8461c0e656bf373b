import type { MessagesTexts } from "../../message-texts.ts";

/** What a finding offers, where it offers something. */
const nearest = (
  value: number | undefined,
  say: (value: number) => string,
) => (value === undefined ? "" : ` Nächster möglicher Wert: ${say(value)}.`);

export const threads = {
  pitchZero: () => "Ein Gewinde braucht eine Steigung größer als 0.",
  depthFromPitch: (d, w) =>
    `Tiefe aus der Steigung, metrisches ISO-Profil: ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} im Radius.`,
  threadOverInsert: (d, w) => `${w.length(d.depth)} sind tiefer, als die Schneide hoch ist: ${w.length(d.most)}.`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `Im ${d.place === "before" ? "Anlauf" : "Überlauf"} läuft das Werkzeug ins Material. `}Bei ${
      w.place(d.x, d.z)
    } stehen ${w.length(d.over)} Material über den Gewindespitzen${
      d.most === undefined
        ? d.place === "over" ? ": Der erste Schnitt nimmt sie mit, zwischen den Gängen bleiben sie stehen." : "."
        : `; die Schneide hat Platz für ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `Mit ${w.angle(d.angle)} verletzen die Schnitte die fertige Flanke: höchstens der halbe Spitzenwinkel, ${w.angle(d.most)}.`
    + nearest(d.nearest, w.angle),
  runOutTooLong: (d, w) =>
    `Der Auslauf von ${w.size(d.size)} ist länger als das Gewinde: höchstens ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) => `Das Gewinde muss vom Start zum Ende entlang ${d.axis} weiterlaufen: Diese Achse ist mit der Spindel gekoppelt.`,
  runInBlocked: (d, w) => `Wo der Anlauf beginnt, bei ${w.place(d.x, d.z)}, stünde das Werkzeug im Material.${nearest(d.nearest, w.size)}`,
  threadTooMany: (d, w) => `${w.number(d.turns)} Spindelumdrehungen in allen Schnitten sind mehr als ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `Ein Winkel von ${w.angle(d.angle)} führt vom Anfang des Gewindes zu keinem Ende.`,
  threadFeedOverLimit: (d, w) =>
    `Drehzahl ${w.number(d.speed)} × Steigung ergibt ${w.number(d.feed)} mm/min, mehr als die Achse kann: ${w.number(d.most)}. Bis `
    + `${w.number(d.upTo)} 1/min kann sie folgen.`,
  runInShort: (d, w) =>
    `Bei ${w.number(d.speed)} 1/min ist der Anlauf von ${w.size(d.runIn)} zu kurz für den Vorschub: Drehzahl × Steigung / 400 ergibt `
    + `${w.length(d.needed)}. Unsere Faustregel.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;

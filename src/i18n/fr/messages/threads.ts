import type { MessagesTexts } from "../../message-texts.ts";

/** What a finding offers, where it offers something. */
const nearest = (
  value: number | undefined,
  say: (value: number) => string,
) => (value === undefined ? "" : ` Valeur possible la plus proche : ${say(value)}.`);

export const threads = {
  pitchZero: () => "Un filetage demande un pas supérieur à 0.",
  depthFromPitch: (d, w) =>
    `Profondeur d’après le pas, profil ISO métrique : ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} au rayon.`,
  threadOverInsert: (d, w) => `${w.length(d.depth)} dépassent la hauteur de la plaquette : ${w.length(d.most)}.`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `${d.place === "before" ? "À l’engagement" : "En fin de course"}, l’outil entre dans la matière. `}En ${
      w.place(d.x, d.z)
    }, ${w.length(d.over)} de matière dépassent le sommet du filet${
      d.most === undefined
        ? d.place === "over" ? " : la première passe les prend en plus, et ils restent entre les filets." : "."
        : ` ; la plaquette a de la place pour ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `Avec ${w.angle(d.angle)} les passes entament le flanc fini : au plus la moitié de l’angle de pointe, ${w.angle(d.most)}.`
    + nearest(d.nearest, w.angle),
  runOutTooLong: (d, w) =>
    `La sortie de ${w.size(d.size)} est plus longue que le filetage : au plus ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) => `Le filetage doit avancer selon ${d.axis} du début à la fin : cet axe est lié à la broche.`,
  runInBlocked: (d, w) => `Au début de l’engagement, en ${w.place(d.x, d.z)}, l’outil serait dans la matière.${nearest(d.nearest, w.size)}`,
  threadTooMany: (d, w) => `${w.number(d.turns)} tours de broche pour toutes les passes dépassent ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `Un angle de ${w.angle(d.angle)} ne mène du début du filet à aucune fin.`,
  threadFeedOverLimit: (d, w) =>
    `Vitesse ${w.number(d.speed)} × pas donne ${w.number(d.feed)} mm/min, plus que l’axe ne peut : ${w.number(d.most)}. Jusqu’à `
    + `${w.number(d.upTo)} tr/min il peut suivre.`,
  runInShort: (d, w) =>
    `À ${w.number(d.speed)} tr/min l’engagement de ${w.size(d.runIn)} est trop court pour atteindre l’avance : vitesse × pas / 400 donne `
    + `${w.length(d.needed)}. Notre règle empirique.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;

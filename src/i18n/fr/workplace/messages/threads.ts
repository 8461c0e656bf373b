import type { MessagesTexts } from "../../../message-texts.ts";
import type { Write } from "../../../write.ts";

/** What a finding offers, where it offers something. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Valeur possible la plus proche : ${say(value)}.`;

const ALL_ALONG =
  " Aucun engagement usuel ne l’évite : commencer le filetage à son extrémité libre, ou y tourner avant un dégagement.";
/** A place on the axis that a thread runs along: a Z, or in a face a diameter. */
const placeOn = (axis: "X" | "Z", value: number, w: Write): string =>
  axis === "X" ? `X${w.diameter(value)}` : `Z${w.signed(value)}`;

export const threads = {
  pitchZero: () => "Un filetage demande un pas supérieur à 0.",
  depthFromPitch: (d, w) =>
    `Profondeur d’après le pas, profil ISO métrique : ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} au rayon.`,
  depthOfOtherProfile: (d, w) =>
    `Q473 = 0 prend la profondeur du profil métrique : ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(
      d.depth,
    )}. Ce facteur est celui de ` +
    `60° ; cette plaquette a ${w.angle(d.angle)}. ${
      d.right === undefined
        ? "Indiquer la profondeur de son profil."
        : `Whitworth (55°) : ${w.number(d.right)} × le pas.`
    }${nearest(d.nearest, w.size)}`,
  toothAssumed: (d, w) =>
    `CUTLENGTH de l’outil à fileter est vide : la dent est supposée haute de ${w.length(d.height)}. Indiquer sa hauteur, pour que les ` +
    "épaulements voisins du filetage soient contrôlés avec la vraie plaquette.",
  threadOverInsert: (d, w) =>
    `${w.length(d.depth)} dépassent la hauteur de la plaquette : ${w.length(d.most)}. Prendre un outil à dent plus haute (CUTLENGTH).`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `${d.place === "before" ? "À l’engagement" : "En fin de course"}, l’outil entre dans la matière. `}En ${w.place(
      d.x,
      d.z,
    )}, ${w.length(d.over)} de matière dépassent le sommet du filet${
      d.most === undefined
        ? d.place === "over"
          ? " : la première passe les prend en plus, et ils restent entre les filets."
          : "."
        : ` ; la plaquette a de la place pour ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `Avec ${w.angle(d.angle)} les passes entament le flanc fini : au plus la moitié de l’angle de pointe, ${w.angle(d.most)}.` +
    nearest(d.nearest, w.angle),
  runOutTooLong: (d, w) =>
    `La sortie de ${w.size(d.size)} est plus longue que le filetage : au plus ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) => `Le filetage doit avancer selon ${d.axis} du début à la fin : cet axe est lié à la broche.`,
  runInBlocked: (d, w) =>
    `Au début de l’engagement, en ${w.place(d.x, d.z)}, l’outil serait dans la matière.${
      d.nearest === undefined ? ALL_ALONG : nearest(d.nearest, w.size)
    }`,
  threadSurfaceSpeed: (d, w) =>
    `Filetage à vitesse de coupe constante (VCONST:ON, ${w.number(d.cuttingSpeed)} m/min) : la vitesse de rotation suit le diamètre${
      d.slow === undefined || d.fast === undefined ? "" : `, de ${w.number(d.slow)} à ${w.number(d.fast)} tr/min`
    }, et les passes peuvent manquer le même filet. Programmer VCONST:OFF avec S.`,
  threadOverruns: (d, w) =>
    `Le filetage finit en ${placeOn(d.axis, d.end, w)} et dépasse jusqu’à ${placeOn(d.axis, d.to, w)} ; ${
      d.meets === "shaft" ? "là il enlève" : "là un flanc de la plaquette touche l’épaulement et enlève"
    } ${w.area(d.area)} de la pièce finie, en ${w.place(
      d.x,
      d.z,
    )}. Finir le filetage plus tôt (Q494), sortir progressivement (Q474) ou tourner ` +
    "avant un dégagement (DIN 76) assez large.",
  crestMissing: (d, w) =>
    `Il manque ${w.length(d.missing)} au sommet du filet : il n’y a pas assez de matière. Correct serait ${
      "diameter" in d ? w.diameter(d.diameter) : `Z${w.signed(d.z)}`
    }.`,
  threadTooMany: (d, w) => `${w.number(d.turns)} tours de broche pour toutes les passes dépassent ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `Un angle de ${w.angle(d.angle)} ne mène du début du filet à aucune fin.`,
  threadFeedOverLimit: (d, w) =>
    `Vitesse ${w.number(d.speed)} × pas donne ${w.number(d.feed)} mm/min, plus que l’axe ne peut : ${w.number(d.most)}. Jusqu’à ` +
    `${w.number(d.upTo)} tr/min il peut suivre.`,
  runInShort: (d, w) =>
    `À ${w.number(d.speed)} tr/min l’engagement de ${w.size(d.runIn)} est trop court pour atteindre l’avance : vitesse × pas / 400 donne ` +
    `${w.length(d.needed)}. Notre règle empirique.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;

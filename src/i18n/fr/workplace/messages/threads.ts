import type { MessagesTexts } from "../../../message-texts.ts";
import type { Write } from "../../../write.ts";

/** The value that a finding proposes, if any. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Proposé : ${say(value)}.`;

const ALL_ALONG =
  " Aucune course d’engagement usuelle ne l’évite : commencer le filetage à son extrémité libre, ou y tourner " +
  "avant un dégagement.";
/** A position on the synchronized axis of a thread: Z, or a diameter in a face. */
const placeOn = (axis: "X" | "Z", value: number, w: Write): string =>
  axis === "X" ? `X${w.diameter(value)}` : `Z${w.signed(value)}`;

export const threads = {
  pitchZero: () => "Un filetage exige un pas supérieur à 0.",
  depthFromPitch: (d, w) =>
    `Profondeur d’après le pas, profil ISO métrique : ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(d.depth)} au rayon.`,
  depthOfOtherProfile: (d, w) =>
    `Q473 = 0 utilise la profondeur du profil métrique : ${w.number(d.factor)} × ${w.size(d.pitch)} = ${w.length(
      d.depth,
    )}. Ce facteur vaut pour 60° ; la plaquette a ${w.angle(d.angle)}. ${
      d.right === undefined
        ? d.nearest === undefined
          ? "Indiquer la profondeur de ce profil."
          : "Filetage trapézoïdal (30°) : demi-pas plus jeu à fond de filet."
        : `Whitworth (55°) : ${w.number(d.right)} × le pas.`
    }${nearest(d.nearest, w.size)}`,
  toothAssumed: (d, w) =>
    `CUTLENGTH de l’outil à fileter est vide : hauteur de dent supposée ${w.length(d.height)}. Indiquer la hauteur pour contrôler les épaulements voisins avec la plaquette réelle.`,
  threadOverInsert: (d, w) =>
    `La profondeur ${w.length(d.depth)} dépasse la hauteur de dent ${w.length(d.most)}. Utiliser un outil à fileter à dent plus haute (CUTLENGTH).`,
  threadTooSteep: (d, w) =>
    `Le filet monte à ${w.angle(d.angle)} : les flancs de la plaquette permettent moins de ${w.angle(d.most)}. Entrer un cône plus plat ou changer l’axe du filet.`,
  threadMeets: (d, w) =>
    `${d.place === "over" ? "" : `${d.place === "before" ? "Dans l’engagement" : "Dans le dépassement"}, l’outil entre dans la matière. `}En ${w.place(
      d.x,
      d.z,
    )}, ${w.length(d.over)} de matière dépassent le sommet du filet${
      d.most === undefined
        ? d.place === "over"
          ? " : la première passe enlève aussi cette matière ; elle reste entre les filets."
          : "."
        : ` ; la plaquette a de la place pour ${w.size(d.most)}.`
    }`,
  flankInfeedTooSteep: (d, w) =>
    `Avec ${w.angle(d.angle)}, les passes endommagent le flanc fini : max. la moitié de l’angle de pointe, ${w.angle(d.most)}.` +
    nearest(d.nearest, w.angle),
  runOutTooLong: (d, w) =>
    `La sortie de ${w.size(d.size)} est plus longue que le filetage : max. ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
  threadTurnsBack: (d) =>
    `Le filetage doit avancer dans un seul sens selon ${d.axis}, du départ à la fin : cet axe est synchronisé avec la broche.`,
  runInBlocked: (d, w) =>
    `Au début de l’engagement, en ${w.place(d.x, d.z)}, l’outil serait dans la matière.${
      d.nearest === undefined ? ALL_ALONG : nearest(d.nearest, w.size)
    }`,
  threadSurfaceSpeed: (d, w) =>
    `Filetage à vitesse de coupe constante (VCONST:ON, ${w.number(d.cuttingSpeed)} m/min) : la vitesse de rotation suit le diamètre${
      d.slow === undefined || d.fast === undefined ? "" : `, de ${w.number(d.slow)} à ${w.number(d.fast)} tr/min`
    } ; les passes peuvent ne pas suivre le même filet. Programmer VCONST:OFF avec S.`,
  threadOverruns: (d, w) =>
    `Le filetage finit en ${placeOn(d.axis, d.end, w)} et dépasse jusqu’à ${placeOn(d.axis, d.to, w)} ; ${
      d.meets === "shaft"
        ? "violation de contour :"
        : "le flanc de la plaquette touche l’épaulement, violation de contour :"
    } ${w.area(d.area)} en ${w.place(
      d.x,
      d.z,
    )}. Finir le filetage plus tôt (Q494), sortir progressivement (Q474) ou tourner ` +
    "avant un dégagement (DIN 76) assez large.",
  crestMissing: (d, w) =>
    `Il manque ${w.length(d.missing)} au sommet du filet : pas assez de matière. Correct : ${
      "diameter" in d ? w.diameter(d.diameter) : `Z${w.signed(d.z)}`
    }.`,
  threadTooMany: (d, w) =>
    `${w.number(d.turns)} tours de broche pour toutes les passes dépassent le maximum de ${w.number(d.most)}.`,
  taperImpossible: (d, w) => `Avec un angle de ${w.angle(d.angle)}, le filetage n’a pas de point final.`,
  threadFeedOverLimit: (d, w) =>
    `Vitesse ${w.number(d.speed)} × pas = ${w.feed(d.feed, "mm/min")} dépasse l’avance maximale de l’axe ${w.feed(d.most, "mm/min")}. Max. ${w.number(d.upTo)} tr/min.`,
  runInShort: (d, w) =>
    `À ${w.number(d.speed)} tr/min l’engagement de ${w.size(d.runIn)} est trop court pour atteindre l’avance. Règle empirique : vitesse × pas / 400 = ${w.length(d.needed)}.${nearest(d.nearest, w.size)}`,
} satisfies Partial<MessagesTexts["of"]>;

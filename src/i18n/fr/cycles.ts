import type { CyclesTexts } from "../cycle-text.ts";

const turnMode = "Ne s'exécute qu'en FUNCTION MODE TURN. Sur une TNC7, le constructeur de la machine doit avoir activé la fonction.";
const safePosition =
  "Avant l'appel, positionner l'outil avec R0 à un endroit sûr : ce point est le départ du cycle et détermine ce qui est usiné.";
const edgeLength = "Une valeur CUTLENGTH du tableau d'outils limite la passe d'ébauche ; elle est alors réduite, avec un message.";

export const cycles = {
  groups: { shoulder: "Épaulements", contour: "Contours libres", recessTurning: "Tournage de gorge" },
  evidence: {
    A: "imprimé dans un manuel de cette commande",
    B: "imprimé pour une commande sœur",
    L: "repris des commandes de tour dont viennent ces cycles",
    I: "déduit de faits imprimés",
    K1: "de mémoire sûre, non vérifié sur une page imprimée",
    K2: "de mémoire, non vérifié sur une page imprimée",
    K3: "incertain, non vérifié sur une page imprimée",
  },
  kinds: {
    choice: "choix",
    diameter: "diamètre",
    oversizeDiameter: "surépaisseur au diamètre",
    radial: "au rayon",
    axial: "en Z",
    axialDepth: "profondeur en Z",
    length: "longueur",
    angle: "angle",
    feed: "avance",
  },
  roughStep: (step, of, text) => `Étape ${step} sur ${of} : ${text}`,
  finishStep: (step, of, text) => `Finition, étape ${step} sur ${of} : ${text}`,
  positioning: "Positionnement avant l'étape 1",
  of: {
    812: {
      name: "Épaulement longitudinal étendu",
      summary: "Tourne un épaulement dans le sens longitudinal, avec chanfreins, angles et rayon de coin.",
      description: [
        "Tourne un épaulement le long de l'axe. Les arêtes au départ et à la fin du contour peuvent recevoir un chanfrein ou un "
        + "arrondi, le pourtour et la face peuvent être inclinés, le coin intérieur peut être arrondi.",
        "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage extérieur. "
        + "Inférieur : usinage intérieur.",
        "Si le point de départ se trouve dans la zone à usiner, l'outil va d'abord en X, puis en Z, à la distance d'approche ; "
        + "pour la finition, d'abord en Z.",
      ],
      rough: [
        "prise de passe paraxiale en rapide",
        "coupe longitudinale à l'avance d'ébauche",
        "retrait de la valeur de passe",
        "retour au début de la coupe en rapide",
        "répéter jusqu'au contour",
        "retour au départ du cycle en rapide",
      ],
      finish: [
        "prise de passe paraxiale en rapide",
        "finition du contour, du départ à la fin",
        "retrait de la distance d'approche",
        "retour au départ du cycle en rapide",
      ],
      notes: [turnMode, safePosition, edgeLength],
    },
    820: {
      name: "Contour transversal",
      summary: "Tourne un contour libre d'un sous-programme, dans le sens transversal.",
      description: [
        "Tourne un contour quelconque en travers de l'axe. Le contour est un sous-programme de droites, d'arrondis, de chanfreins "
        + "et d'arcs, désigné par le cycle 14 ou par SEL CONTOUR.",
        "Ébauche en passes paraxiales, finition, ou les deux. Premier point du contour plus grand en X que le dernier : usinage "
        + "extérieur. Plus petit : usinage intérieur.",
        "Si le Z du point de départ est sous le départ du contour, l'outil va d'abord en Z au départ du contour ; pour la "
        + "finition, à la distance d'approche.",
      ],
      rough: [
        "prise de passe paraxiale en rapide",
        "coupe transversale à l'avance d'ébauche",
        "retrait de la valeur de passe",
        "retour au début de la coupe en rapide",
        "répéter jusqu'au contour",
        "retour au départ du cycle en rapide",
      ],
      finish: [
        "prise de passe en rapide",
        "finition du contour, du départ à la fin",
        "retrait de la distance d'approche",
        "retour au départ du cycle en rapide",
      ],
      notes: [
        "Risque de collision : la limite d'usinage restreint le contour usiné, mais l'approche et la sortie peuvent la franchir. "
        + "Placer l'outil, avant l'appel, du côté de la limite qui doit être usiné.",
        turnMode,
        safePosition,
        "La forme de la plaquette est prise en compte pour ne blesser aucun élément. Ce que l'outil n'atteint pas reste, avec un "
        + "avertissement.",
        "Le cycle 14 avec le label du contour, ou SEL CONTOUR avec son fichier, doit précéder l'appel.",
        "Les paramètres locaux (QL) du contour doivent être affectés dans le sous-programme lui-même.",
        edgeLength,
      ],
    },
    852: {
      name: "Tournage de gorge axial étendu",
      summary: "Tourne une gorge dans une face, avec flancs inclinés, chanfreins et rayons de fond.",
      description: [
        "Réalise une gorge dans une face par tournage de gorge : l'outil plonge à une profondeur puis tourne latéralement, avec "
        + "peu de dégagements. Les arêtes peuvent recevoir un chanfrein ou un arrondi, les deux flancs peuvent être inclinés, les "
        + "coins du fond arrondis.",
        "Ébauche en passes paraxiales, finition, ou les deux. Diamètre de départ supérieur au diamètre final : usinage extérieur. "
        + "Inférieur : usinage intérieur.",
        "Si le Z du point de départ est sous le départ du contour Q492, l'outil va d'abord en Z à Q492.",
      ],
      rough: [
        "plongée à la première profondeur",
        "coupe latérale entre départ et fin à l'avance d'ébauche",
        "éléments plongeants à leur propre avance",
        "relever, revenir et aborder de nouveau (un sens), ou prendre la passe aux deux bouts (deux sens)",
        "coupe à la profondeur suivante",
        "répéter jusqu'à la profondeur de la gorge",
        "rapide à la distance, puis une coupe le long de chaque paroi",
        "retour au départ du cycle en rapide",
      ],
      finish: [
        "rapide à la première paroi",
        "finition de la première paroi",
        "finition du fond ; avec un rayon de coin, toute la gorge d'un seul trait",
        "sortie de la gorge en rapide",
        "rapide à la deuxième paroi",
        "finition de la deuxième paroi",
        "retour au départ du cycle en rapide",
      ],
      notes: [
        turnMode,
        safePosition,
        "À partir de la deuxième passe, chaque coupe est raccourcie de 0,1 mm, ou de Q508 ; l'outil est ainsi soulagé "
        + "latéralement. Le reste part en une coupe à la fin de l'ébauche.",
        "Si le décalage dépasse 80 % de la largeur effective (largeur de la dent moins deux fois son rayon), la commande signale "
        + "une erreur.",
        edgeLength,
        "La page dit Q460 réservé et nomme pourtant la distance d'approche dans deux étapes ; nous y prenons une distance fixe.",
      ],
    },
  },
} satisfies CyclesTexts;

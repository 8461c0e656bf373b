import type { GuidePlacesTexts } from "../en/guide-places.ts";
import { typeset } from "./typography/typeset.ts";

export const guidePlaces: GuidePlacesTexts = typeset({
  other: "Autres questions",
  setup: "Préparation",
  approach: "Approche et sortie",
  contour: "Contour",
  ownCycles: "Vos cycles",
  runWith: "Le cycle simulé avec chacune de ces valeurs.",
  places: {
    "blank.outside": {
      about:
        "⌀ de la pièce brute : D dans BLK FORM CYLINDER. Utilisé pour la simulation seulement ; la machine ne " +
        "l’utilise pas.",
      mistakes: [
        "Le ⌀ fini est saisi : il manque de la matière dans la simulation, une avance rapide dans cette matière " +
          "n’est pas détectée.",
        "Barres et pièces moulées dépassent leur cote nominale : ajouter la tolérance.",
      ],
    },
    "blank.bore": {
      about: "⌀ d’un alésage existant : DI dans BLK FORM CYLINDER. Les cycles intérieurs partent de cet alésage.",
      mistakes: [
        "0 malgré un perçage existant : la vérification trouve la barre d’alésage en pleine matière.",
        "L’alésage est plus étroit que l’outil et son corps : contact à l’entrée.",
      ],
    },
    "blank.length": {
      about: "Longueur totale de la pièce brute : L dans BLK FORM CYLINDER, partie serrée comprise.",
      mistakes: ["Seule la longueur libre est saisie : les mors gênent l’outil.", "La longueur de tronçonnage manque."],
    },
    "blank.allowance": {
      about: "Surépaisseur de la face devant l’origine pièce : DIST. Z0 est en général la face finie.",
      mistakes: [
        "0 alors que la face est brute : devant Z0, l’outil heurte la matière en avance rapide.",
        "Valeur négative : la pièce brute commence derrière Z0, les premières passes sont des passes à vide.",
      ],
    },
    tool: {
      about:
        "TOOL CALL sélectionne dans le tableau une plaquette avec son rayon de bec et son orientation TO. Les " +
        "mêmes valeurs avec une autre plaquette donnent une autre pièce : le rayon de bec reste dans les coins, " +
        "les arêtes limitent les flancs.",
      mistakes: [
        "Numéro d’outil et poste de tourelle sont confondus : une autre plaquette coupe.",
        "Un outil extérieur est appelé pour un contour intérieur : son orientation ne convient pas.",
      ],
    },
    "start.x": {
      about:
        "Position X de la pointe d’outil à l’appel du cycle, en ⌀. Les cycles sans diamètre de départ commencent " +
        "leur contour ici ; tous partent de cette position et y reviennent.",
      mistakes: [
        "Dans la pièce brute : la première avance rapide traverse la matière.",
        "Un rayon est saisi : l’outil est à la moitié de la distance à l’axe.",
      ],
    },
    "start.z": {
      about: "Position Z de la pointe d’outil à l’appel du cycle : devant la matière, du côté d’où le cycle usine.",
      mistakes: [
        "Derrière un collet : le trajet vers la première passe traverse le collet.",
        "Mauvais côté : un cycle qui usine vers le mandrin s’appelle depuis la droite.",
      ],
    },
    "spindle.cuttingSpeed": {
      about:
        "VC en m/min : la commande adapte la vitesse de rotation au ⌀, n = 1000 · vc / (π · d). La trajectoire " +
        "reste la même ; temps, chaleur et état de surface changent.",
      mistakes: [
        "SMAX manque : vers l’axe, la broche tourne à sa vitesse maximale.",
        "Une vitesse de rotation est saisie : 1500 m/min est bien trop rapide pour l’acier.",
      ],
    },
    "spindle.speed": {
      about:
        "S en tours par minute, la même à chaque ⌀ : nécessaire pour les filetages. Vers l’axe, la vitesse de " +
        "coupe tombe à zéro.",
      mistakes: [
        "Reprise d’une pièce mince : sur un grand ⌀, la vitesse de coupe est trop élevée.",
        "Utilisée pour le dressage : vers le centre, l’état de surface se dégrade.",
      ],
    },
    "spindle.limit": {
      about:
        "SMAX en tours par minute : vitesse maximale avec vitesse de coupe constante. Mandrin, serrage et " +
        "balourd la déterminent, pas la plaquette.",
      mistakes: [
        "La limite du mandrin est ignorée : les mors perdent leur serrage quand la vitesse monte.",
        "Trop basse : la vitesse de coupe n’est atteinte que sur le plus grand ⌀.",
      ],
    },
    perRevolution: {
      about: "Avec M136, les avances sont en mm par tour, sinon en mm par minute.",
      mistakes: [
        "M136 manque : 0,3 veut dire 0,3 mm par minute, et l’outil semble arrêté.",
        "Avance par minute non modifiée : 200 mm par tour.",
      ],
    },
    rapid: {
      about: "Vitesse d’avance rapide de la machine. Utilisée seulement pour le temps estimé ; absente du programme.",
      mistakes: [
        "Confondue avec une avance : en avance rapide, l’outil ne coupe jamais.",
        "Les temps de deux machines sont comparés avec la vitesse de l’une.",
      ],
    },
  },
  on: "actif",
  off: "inactif",
  form: {
    points: "Points",
    of: {
      PS: "Programmé juste avant APPR, avec R0.",
      PH: "Calculé par la commande d’après la forme et les valeurs.",
      PA: "Programmé dans la séquence APPR.",
      PE: "Programmé dans la dernière séquence du contour.",
      PN: "Hors du contour : programmé avec DEP LCT, calculé sinon.",
    },
    polar: "Le point est défini depuis le pôle CC par la distance PR et l’angle PA.",
    ownLead: "Représenté au contour de votre séquence.",
    sampleLead: "Représenté à un coin, avec un rayon d’outil de 8 mm.",
    way: "Trajectoire",
    danger: "Pourquoi PS→PH est dangereux",
    dangers: [
      "De PS à PH la commande ne contrôle pas si le contour est endommagé.",
      "Avec LT, LN et CT, à la dernière avance programmée : après FMAX, en avance rapide. Avec LCT, à l’avance " +
        "de la séquence APPR.",
      "Placer PS du côté où commence le contour, pour que la droite vers PH soit libre. L’application contrôle " +
        "cette droite.",
    ],
    leaving: "Après PN, la séquence suivante est exécutée : PN doit être dégagé de la pièce et du mandrin.",
    mistakes: {
      all: "RL et RR sont inversés : l’outil coupe sa propre largeur dans la pièce.",
      LT: "Le prolongement de l’élément n’est pas libre : la droite traverse un épaulement.",
      LN: "L’outil change de direction de 90° au contour et s’arrête brièvement : il marque une face finie.",
      CT: "La séquence a R0 : un arc exige RL ou RR. Un R négatif place l’arc du côté de la pièce.",
      LCT: "Le point extérieur est dans le cercle de R : aucune tangente n’est possible.",
    },
    others: "Autres formes",
  },
  elements: {
    lead:
      "Le contour est un sous-programme après le programme principal, sous le label sélectionné par CYCL DEF 14. " +
      "Le sens du contour détermine le sens d’usinage.",
    title: "Éléments",
    of: {
      L: "Droite jusqu’au point final. Une coordonnée absente reste inchangée.",
      RND: "Arrondit le coin entre l’élément précédent et le suivant.",
      CHF: "Chanfreine le coin, de la même longueur des deux côtés.",
      CR: "Arc jusqu’au point final avec un rayon ; un rayon négatif donne le grand arc.",
      CC: "Centre du C suivant, et pôle des éléments polaires.",
      C: "Arc autour de CC jusqu’au point final, dans le sens DR.",
      CT: "Arc jusqu’au point final avec raccordement tangentiel.",
      LP: "Droite vers un point défini par distance et angle depuis CC.",
      CP: "Arc autour de CC jusqu’à un angle.",
      CTP: "Arc avec raccordement tangentiel vers un point défini depuis CC.",
      UDC: "Dégagement de forme normalisée entre deux éléments.",
      GRV: "Gorge au milieu d’un élément droit.",
    },
    mistakes: [
      "La première ligne est prise pour un élément : elle n’est que le point de départ.",
      "X est saisi comme rayon ; c’est un ⌀.",
      "RND ou CHF est au début ou à la fin : il n’y a pas de coin.",
      "Un arrondi est trop grand pour les éléments voisins.",
      "Le contour continue dans le mandrin.",
    ],
  },
});

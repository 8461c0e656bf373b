import type { GuidePlacesTexts } from "../en/guide-places.ts";
import { typeset } from "./typography/typeset.ts";

export const guidePlaces: GuidePlacesTexts = typeset({
  other: "Autres questions",
  setup: "Réglages",
  approach: "Approche et sortie",
  contour: "Contour",
  ownCycles: "Vos cycles",
  runWith: "Le noyau a exécuté le cycle avec chacun d’eux.",
  places: {
    "blank.outside": {
      about:
        "Le ⌀ de la barre brute : D dans BLK FORM CYLINDER. Le contrôle y enlève la matière ; la machine ne le voit jamais.",
      mistakes: [
        "Le ⌀ fini est saisi : l’image n’a pas la matière qu’a la machine, et un rapide qui la touche n’est pas trouvé.",
        "Barre et fonte sont plus fortes que leur cote nominale : la tolérance en fait partie.",
      ],
    },
    "blank.bore": {
      about: "⌀ d’un trou présent avant le tournage : DI dans BLK FORM CYLINDER. Les cycles intérieurs en partent.",
      mistakes: [
        "0 reste alors que c’est percé : le contrôle trouve la barre d’alésage en pleine matière.",
        "Le trou est plus étroit que l’outil avec son corps : ils frottent en entrant.",
      ],
    },
    "blank.length": {
      about: "Longueur totale du brut : L dans BLK FORM CYLINDER, avec la partie que tient le mandrin.",
      mistakes: [
        "Seule la longueur libre est saisie : les mors gênent l’outil.",
        "La longueur pour tronçonner est oubliée.",
      ],
    },
    "blank.allowance": {
      about: "Distance dont la face du brut dépasse devant le zéro pièce : DIST. Z0 est en général la face finie.",
      mistakes: [
        "0 alors que la face est brute : devant Z0 l’outil rencontre la matière en rapide.",
        "Un signe moins : le brut commence derrière Z0, et les premières passes coupent l’air.",
      ],
    },
    tool: {
      about:
        "TOOL CALL prend dans le tableau une plaquette avec son rayon de bec et son orientation TO. Les mêmes valeurs avec une autre " +
        "plaquette font une autre pièce : le bec reste dans les coins, les arêtes limitent les flancs.",
      mistakes: [
        "Numéro d’outil et poste de tourelle sont confondus : une autre plaquette coupe.",
        "Un outil extérieur est appelé pour un contour intérieur : son orientation ne convient pas.",
      ],
    },
    "start.x": {
      about:
        "Position transversale de la pointe à l’appel du cycle, en ⌀. Les cycles sans diamètre de départ commencent leur contour ici ; " +
        "tous partent d’ici et y reviennent.",
      mistakes: [
        "Il est dans le brut : le premier rapide traverse la matière.",
        "Un rayon est saisi : l’outil est à la moitié de la distance à l’axe.",
      ],
    },
    "start.z": {
      about: "Position longitudinale de la pointe à l’appel du cycle : devant la matière, du côté d’où le cycle usine.",
      mistakes: [
        "Il est derrière un collet : le chemin vers la première passe le traverse.",
        "Le côté est faux : un cycle qui coupe vers le mandrin s’appelle depuis la droite.",
      ],
    },
    "spindle.cuttingSpeed": {
      about:
        "VC en m/min : la commande adapte la vitesse de rotation au ⌀, n = 1000 · vc / (π · d). La trajectoire reste ; temps, chaleur et " +
        "état de surface changent.",
      mistakes: [
        "Il manque SMAX : vers l’axe la broche tourne aussi vite qu’elle peut.",
        "Des tours sont saisis : 1500 m/min est bien trop rapide pour l’acier.",
      ],
    },
    "spindle.speed": {
      about:
        "S en tours par minute, la même à chaque ⌀ : juste pour les filetages. Vers l’axe la vitesse de coupe tombe à rien.",
      mistakes: [
        "Elle vient d’une pièce mince : sur un grand ⌀ l’arête va trop vite.",
        "On dresse avec elle : vers le centre l’état de surface se dégrade.",
      ],
    },
    "spindle.limit": {
      about:
        "SMAX en tours par minute : la vitesse de coupe constante ne tourne jamais plus vite. Mandrin, serrage et balourd en décident, " +
        "pas la plaquette.",
      mistakes: [
        "La limite du mandrin est oubliée : les mors perdent leur serrage quand la vitesse monte.",
        "Elle est si basse que la vitesse de coupe n’est tenue que sur le plus grand ⌀.",
      ],
    },
    perRevolution: {
      about: "Avec M136 les avances comptent en mm par tour, sans lui en mm par minute.",
      mistakes: [
        "M136 manque : 0,3 veut dire 0,3 mm par minute, et l’outil semble arrêté.",
        "Une avance par minute est restée : 200 mm par tour.",
      ],
    },
    rapid: {
      about: "Vitesse de la machine en rapide. Seul le temps estimé en dépend ; le programme ne la contient pas.",
      mistakes: [
        "Elle est prise pour une avance : elle ne coupe jamais.",
        "Les temps de deux machines sont comparés avec le rapide de l’une.",
      ],
    },
  },
  on: "actif",
  off: "inactif",
  form: {
    points: "Ses points",
    of: {
      PS: "Programmé juste avant APPR, avec R0.",
      PH: "Calculé par la commande d’après la forme et les valeurs.",
      PA: "Figure dans la séquence APPR.",
      PE: "Figure dans la dernière séquence du contour.",
      PN: "À l’extérieur : DEP LCT le nomme, les autres le calculent.",
    },
    polar: "Le point est donné depuis le pôle CC : par la distance PR et l’angle PA.",
    ownLead: "Dessiné au contour de votre séquence.",
    sampleLead: "Dessiné à un angle, avec un outil de 8 mm de rayon.",
    way: "Trajet",
    danger: "Pourquoi PS→PH est dangereux",
    dangers: [
      "De PS à PH la commande ne contrôle pas si le contour est endommagé.",
      "Avec LT, LN et CT ce trajet se fait à la dernière avance programmée : après FMAX en rapide. Avec LCT à l’avance de sa séquence.",
      "Placez PS du côté où commence le contour, pour que la droite vers PH soit libre. L’app vérifie cette droite.",
    ],
    leaving: "Après PN la séquence suivante va son chemin : PN doit être dégagé de la pièce et du mandrin.",
    mistakes: {
      all: "RL et RR sont inversés : l’outil coupe sa propre largeur dans la pièce.",
      LT: "Le prolongement de l’élément n’est pas libre : le segment droit traverse un épaulement.",
      LN: "L’outil tourne de 90° au contour et s’arrête un instant : il marque une face finie.",
      CT: "La séquence a R0 : un arc exige RL ou RR. Un moins devant R place l’arc du côté de la pièce.",
      LCT: "Le point extérieur est dans le cercle de R : il n’y a pas de tangente.",
    },
    others: "Les autres formes",
  },
  elements: {
    lead: "Le contour est derrière le programme principal, sous un label que nomme CYCL DEF 14. Son sens décide d’où il est usiné.",
    title: "Ses éléments",
    of: {
      L: "Droite jusqu’au point final. Une coordonnée absente reste comme elle était.",
      RND: "Arrondit l’angle entre les éléments avant et après.",
      CHF: "Coupe l’angle, de la même longueur des deux côtés.",
      CR: "Arc jusqu’au point final avec un rayon ; un moins prend le long chemin.",
      CC: "Centre du C suivant, et pôle des éléments polaires.",
      C: "Arc autour de CC jusqu’au point final, dans le sens DR.",
      CT: "Arc jusqu’au point final qui prolonge sans angle l’élément d’avant.",
      LP: "Droite vers un point donné par distance et angle depuis CC.",
      CP: "Arc autour de CC jusqu’à un angle.",
      CTP: "Arc sans angle vers un point donné depuis CC.",
      UDC: "Dégagement de forme normalisée entre deux éléments.",
      GRV: "Gorge au milieu d’un élément droit.",
    },
    mistakes: [
      "La première ligne est prise pour un élément : elle n’est que le point de départ.",
      "X est saisi comme rayon ; c’est un ⌀.",
      "RND ou CHF est au début ou à la fin : il n’y a pas d’angle.",
      "Un arrondi est plus long que les éléments voisins.",
      "Le contour continue dans le mandrin.",
    ],
  },
});

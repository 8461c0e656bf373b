import type { MistakesTexts } from "../mistakes-text.ts";
import { typeset } from "./typography/typeset.ts";

export const mistakes: MistakesTexts = typeset({
  kinds: {
    choice: ["Un nombre est repris d’un autre programme sans vérifier sa signification dans ce cycle."],
    diameter: [
      "Un rayon est saisi au lieu d’un diamètre : la pièce devient deux fois trop mince.",
      "Le signe est confondu avec le côté de l’axe : X est normalement positif.",
    ],
    oversizeDiameter: ["Comprise comme valeur par côté : il ne reste que la moitié de chaque côté."],
    radial: ["Prise pour un diamètre : la passe est deux fois plus profonde que voulu."],
    axial: ["Le signe moins manque : devant Z0 il n’y a pas de pièce."],
    axialDepth: ["Valeur négative : les profondeurs sont positives, le sens vient du contour."],
    length: ["Une coordonnée absolue est saisie au lieu d’une longueur."],
    angle: [
      "L’angle est mesuré depuis le mauvais axe.",
      "Le flanc est trop raide pour l’arête : il reste de la matière résiduelle.",
    ],
    feed: [
      "M136 manque : 0,2 signifie alors 0,2 mm par minute et l’outil semble arrêté.",
      "Une avance par minute est saisie alors que M136 est actif.",
    ],
    count: ["Le nombre est bien trop grand : des minutes de passes à vide."],
    factor: ["Un pourcentage est saisi au lieu d’un facteur : 80 % s’écrit 0,8."],
    percent: ["Un facteur est saisi au lieu d’un pourcentage : 0,8 fait moins d’un pour cent."],
    revolutions: ["Prise pour des secondes : la durée dépend de la vitesse de rotation."],
  },
  of: {
    operation: [
      "0 malgré un outil de finition séparé : la plaquette d’ébauche exécute aussi la finition.",
      "2 est choisi sans ébauche préalable : toute la profondeur est usinée en une passe.",
    ],
    clearance: [
      "0 ou presque : l’outil va en avance rapide jusqu’à la matière et heurte une pièce brute un peu plus grande.",
      "Si grande que le point de départ est dans la distance d’approche : l’outil s’éloigne d’abord.",
    ],
    clearanceReserved: ["Modifiée pour plus de distance : sans effet ici. Modifier le point de départ."],
    startDiameter: [
      "Plus petit que le diamètre final par erreur : la commande usine alors un alésage.",
      "Plus petit que la pièce brute : un anneau reste devant le contour et la première passe est trop profonde.",
    ],
    endDiameter: [
      "Départ et fin sont égaux : il n’y a rien à usiner.",
      "La cote finie est saisie avec la surépaisseur : Q483 s’ajoute encore.",
    ],
    startZ: ["Z0 se trouve sur la face brute qui sera dressée plus tard : toutes les longueurs sont trop courtes."],
    endZ: [
      "La longueur de l’épaulement est saisie sans signe.",
      "Mandrin et mors sont ignorés : la fin se trouve derrière eux.",
    ],
    surfaceAngle: ["Angle et demi-angle du cône sont confondus : saisir l’angle à l’axe, soit le demi-angle."],
    faceAngle: ["L’angle est mesuré depuis l’axe ; il se mesure depuis la face perpendiculaire."],
    flankAngle: ["Les deux flancs sont inversés : Q495 est au départ du contour, Q496 à la fin."],
    secondFlankAngle: ["Les deux flancs sont inversés : Q495 est au départ du contour, Q496 à la fin."],
    startElement: [
      "Type 0 alors que Q502 a une taille : ni chanfrein ni arrondi.",
      "Un chanfrein est choisi là où le dessin indique un rayon.",
    ],
    startElementSize: ["L’élément est plus long que la paroi voisine."],
    endElement: ["Type 0 alors que Q504 a une taille : ni chanfrein ni arrondi."],
    endElementSize: [
      "Le chanfrein de fin se trouve au diamètre brut : avec une pièce brute plus grande, l’arête manque.",
    ],
    cornerRadius: [
      "Plus petit que le rayon de bec : le coin garde le rayon de bec, il reste de la matière résiduelle.",
      "Utilisé aussi pour les arêtes extérieures : utiliser Q502 et Q504.",
    ],
    infeedRadial: [
      "Prise pour la passe réelle : la profondeur est répartie uniformément, la passe est souvent plus petite.",
      "Plus d’un tiers de la longueur d’arête : la plaquette est surchargée.",
      "Doublée parce que le diamètre change du double.",
    ],
    infeedAxial: [
      "Une valeur radiale est reprise du tournage longitudinal : ici la prise de passe est en Z.",
      "0 est saisi pour « pas d’ébauche » : 0 signifie une seule passe.",
    ],
    infeedGroove: [
      "Aussi profonde que la gorge : le copeau ne sort plus.",
      "Prise pour un diamètre : dans une face, la prise de passe est en Z.",
    ],
    roughingFeed: [
      "Plus de 0,8 du rayon de bec : l’arête s’ébrèche et la surface ressemble à un filetage.",
      "Si petite que le copeau ne casse pas.",
    ],
    finishingFeed: [
      "L’avance d’ébauche est reprise : Rz croît avec le carré de l’avance.",
      "Une très petite avance pour un bon état de surface : sous l’épaisseur minimale de copeau, l’arête ne fait " +
        "que frotter.",
    ],
    oversizeZ: [
      "0 alors que Q483 est défini : la finition frotte sur la face sans couper.",
      "Plus grande que ne le permet le rayon de bec dans le coin : trop de matière pour la finition.",
    ],
    smoothing: [
      "2 est choisi pour gagner du temps : avec les marches, la profondeur de finition varie.",
      "Un autre contour fini est attendu : seul le trajet entre les passes change.",
    ],
    plunging: [
      "1 alors que la plaquette n’a pas de dépouille pour les flancs descendants : l’arête secondaire frotte.",
      "0 : le dégagement n’est pas usiné, sans message.",
    ],
    plungingFeed: [
      "0 est saisi pour « pas d’avance » : 0 signifie l’avance d’ébauche.",
      "Aussi rapide que l’avance d’ébauche alors que la lame coupe sur toute sa largeur.",
    ],
    limits: ["1, mais Q480 et Q482 ont les valeurs d’une autre pièce."],
    limitDiameter: ["Du mauvais côté du contour : il ne reste rien à usiner."],
    limitZ: ["Le signe manque et tout le contour se trouve au-delà de la limite."],
    reverseContour: [
      "2 est choisi sans outil coupant dans l’autre sens.",
      "Le contour est programmé à l’envers et encore inversé ici : les deux s’annulent.",
    ],
    direction: ["Les deux sens (0) avec une lame qui ne peut couper que dans un seul."],
    offsetWidth: [
      "Plus de 80 % de la largeur effective de la lame : des nervures resteraient, et la commande s’arrête.",
      "0 : le coin de la lame frotte contre la paroi à chaque passe.",
    ],
    depthCompensation: [
      "Une valeur positive pour une gorge plus profonde : positif reste au-dessus du fond.",
      "Utilisée pour corriger une longueur d’outil fausse : corriger le tableau d’outils.",
    ],
    blankAllowance: [
      "La surépaisseur de finition est saisie : il faut la surépaisseur de la pièce brute sur le contour.",
    ],
    threadPitch: ["Avec plusieurs filets, l’écart entre filets est saisi au lieu du pas hélicoïdal."],
    threadDepth: ["0 est saisi pour « pas de filet » : la commande calcule alors la profondeur d’après le pas."],
    firstInfeed: ["Prise pour chaque passe : les passes suivantes sont plus petites."],
    infeedAngle: ["Plus du demi-angle du filet : la plaquette endommage le flanc fini."],
    threadStarts: ["Le nombre de passes est saisi : il faut le nombre de filets."],
    airCuts: ["Le nombre de passes est saisi : ce sont des passes supplémentaires à la profondeur finie."],
    threadRunIn: ["Trop court pour la vitesse : l’axe n’a pas atteint l’avance au départ du filetage."],
    recessingOverlap: ["La largeur d’une plongée en mm est saisie au lieu du facteur de la largeur de lame."],
    plungeLimit: ["0 est saisi pour « pas de plongée » : 0 signifie une seule plongée à pleine profondeur."],
    dwellTurns: ["Temporisation trop longue : la lame frotte et écrouit la surface."],
  },
});

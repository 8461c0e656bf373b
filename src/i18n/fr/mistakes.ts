import type { MistakesTexts } from "../mistakes-text.ts";
import { typeset } from "./typography/typeset.ts";

export const mistakes: MistakesTexts = typeset({
  kinds: {
    choice: ["Un numéro est repris d’un autre programme sans vérifier ce qu’il signifie dans ce cycle."],
    diameter: [
      "Un rayon est entré là où la commande attend un diamètre : la pièce devient deux fois trop mince.",
      "Le signe est confondu avec le côté de l’axe : X est positif pour une pièce ordinaire.",
    ],
    oversizeDiameter: ["La valeur est comprise par côté : il n’en reste que la moitié de chaque côté."],
    radial: ["La valeur est prise pour un diamètre : la passe est deux fois plus profonde que voulu."],
    axial: ["Le signe moins est oublié : devant Z0 il n’y a pas de pièce."],
    axialDepth: ["Un signe moins est entré : les profondeurs sont positives, le sens vient du contour."],
    length: ["Une coordonnée absolue est entrée là où une longueur est demandée."],
    angle: [
      "L’angle est mesuré depuis le mauvais axe.",
      "Le flanc demandé est plus raide que ce que l’arête peut suivre : de la matière reste.",
    ],
    feed: [
      "M136 manque : 0,2 signifie alors 0,2 mm par minute et l’outil semble arrêté.",
      "Une avance par minute est entrée alors que M136 est actif.",
    ],
    count: ["Le nombre est bien plus grand que nécessaire, et le cycle tourne des minutes à vide."],
    factor: ["Un pourcentage est entré au lieu d’une part : 80 % s’écrit 0,8."],
    percent: ["Une part est entrée au lieu d’un pourcentage : 0,8 fait moins d’un pour cent."],
    revolutions: ["La valeur est prise pour des secondes : la durée dépend de la vitesse de rotation."],
  },
  of: {
    operation: [
      "0 est laissé alors que la finition a son propre outil : la plaquette d’ébauche finit aussi.",
      "2 est choisi sans ébauche préalable : toute la profondeur est prise en une fois.",
    ],
    clearance: [
      "0 ou presque : l’outil arrive en rapide contre la matière, et un brut un peu trop grand est heurté.",
      "Si grande que le point de départ s’y trouve : l’outil s’éloigne d’abord.",
    ],
    clearanceReserved: [
      "Elle est modifiée pour garder plus de distance : ici elle ne fait rien. Seul le point de départ aide.",
    ],
    startDiameter: [
      "Plus petit que le diamètre final par erreur : la commande y voit un alésage.",
      "Plus petit que le brut : une couronne reste devant le contour et la première passe est trop profonde.",
    ],
    endDiameter: [
      "Début et fin sont égaux : il n’y a rien à usiner.",
      "La cote finie est entrée avec sa surépaisseur : Q483 s’y ajoute encore.",
    ],
    startZ: ["Z0 se trouve sur la face brute qui sera dressée plus tard : toutes les longueurs sont trop courtes."],
    endZ: [
      "La longueur de l’épaulement est entrée sans son signe.",
      "Mandrin et mors sont oubliés : la fin se trouve derrière eux.",
    ],
    surfaceAngle: ["Angle et demi-angle du cône sont confondus : on demande l’angle à l’axe, soit le demi-angle."],
    faceAngle: ["L’angle est mesuré depuis l’axe ; il compte depuis la face droite."],
    flankAngle: ["Les deux flancs sont échangés : Q495 appartient au début du contour, Q496 à sa fin."],
    secondFlankAngle: ["Les deux flancs sont échangés : Q495 appartient au début du contour, Q496 à sa fin."],
    startElement: [
      "Le type 0 reste alors que Q502 a une taille : aucune arête n’est cassée.",
      "Un chanfrein est choisi là où le plan demande un rayon.",
    ],
    startElementSize: ["Il est plus long que la paroi qu’il casse."],
    endElement: ["Le type 0 reste alors que Q504 a une taille : aucune arête n’est cassée."],
    endElementSize: ["Le chanfrein de fin se trouve au diamètre brut : si le brut est plus grand, il reste en l’air."],
    cornerRadius: [
      "Plus petit que le rayon de bec : l’angle prend le rayon de la plaquette et de la matière reste.",
      "Il est utilisé aussi pour les arêtes : pour cela il y a Q502 et Q504.",
    ],
    infeedRadial: [
      "La valeur est prise pour la passe réelle : la profondeur est divisée également, la passe est souvent plus petite.",
      "Plus d’un tiers de la longueur d’arête : la plaquette est surchargée.",
      "Elle est doublée parce que le diamètre change du double.",
    ],
    infeedAxial: [
      "Une valeur radiale est reprise du chariotage : ici la passe va selon Z.",
      "0 est entré pour « pas d’ébauche » : cela signifie tout en une passe.",
    ],
    infeedGroove: [
      "Aussi profonde que la gorge : le copeau ne sort plus.",
      "On pense à un diamètre : en face, la prise de passe va selon Z.",
    ],
    roughingFeed: [
      "Plus de 0,8 du rayon de bec : l’arête s’ébrèche et la surface devient un filetage.",
      "Si petite que le copeau ne casse pas.",
    ],
    finishingFeed: [
      "L’avance d’ébauche est reprise : Rz croît avec le carré de l’avance.",
      "Une avance minuscule pour une belle surface : sous l’épaisseur minimale de copeau, l’arête ne fait que frotter.",
    ],
    oversizeZ: [
      "Reste à 0 alors que Q483 est donné : la finition frotte sur la face sans couper.",
      "Plus grande que ce que permet le rayon de bec dans l’angle : la finition rencontre un tas de matière.",
    ],
    smoothing: [
      "2 est pris pour gagner du temps alors que les marches font sauter la finition.",
      "On attend un autre contour fini : seul le trajet entre les passes change.",
    ],
    plunging: [
      "1 est laissé alors que la plaquette n’a pas de dépouille pour les flancs descendants : l’arête secondaire frotte.",
      "0 est donné, et le dégagement reste plein sans aucun message.",
    ],
    plungingFeed: [
      "0 est entré pour « pas d’avance » : cela signifie que l’avance d’ébauche compte.",
      "Aussi rapide que l’avance d’ébauche alors que la lame coupe sur toute sa largeur.",
    ],
    limits: ["1 est donné et Q480 et Q482 gardent les valeurs d’une autre pièce."],
    limitDiameter: ["Elle se trouve du mauvais côté du contour : il ne reste rien à usiner."],
    limitZ: ["Le signe est oublié et tout le contour se trouve au-delà de la limite."],
    reverseContour: [
      "2 est choisi sans outil coupant dans l’autre sens.",
      "Le contour est programmé à l’envers et encore inversé ici : les deux s’annulent.",
    ],
    direction: ["Les deux sens (0) avec une lame qui ne peut couper que dans un seul."],
    offsetWidth: [
      "Plus de 80 % de la largeur effective de la lame : des nervures resteraient, et la commande s’arrête.",
      "Reste à 0, et le coin de la lame frotte contre la paroi à chaque passe.",
    ],
    depthCompensation: [
      "Une valeur positive pour une gorge plus profonde : positif reste au-dessus du fond.",
      "Elle sert à corriger une longueur d’outil fausse : cela va dans le tableau d’outils.",
    ],
    blankAllowance: [
      "La surépaisseur de finition est entrée : il s’agit de l’épaisseur en plus du brut par rapport au contour.",
    ],
    threadPitch: ["Pour plusieurs filets, le pas hélicoïdal est entré au lieu du pas entre filets."],
    threadDepth: ["0 est compris comme « pas de filet » : la commande calcule alors la profondeur d’après le pas."],
    firstInfeed: ["La valeur est prise pour chaque passe : les suivantes diminuent."],
    infeedAngle: ["Plus du demi-angle du filet : la plaquette entame le flanc fini."],
    threadStarts: ["Le nombre de passes est entré : il s’agit du nombre de filets côte à côte."],
    airCuts: ["Le nombre de passes est entré : ce sont des passes en plus à la profondeur finie."],
    threadRunIn: ["Trop court pour la vitesse : l’axe n’a pas atteint le pas au début du filet."],
    recessingOverlap: ["La largeur d’une plongée en mm est entrée au lieu de la part de la largeur de lame."],
    plungeLimit: ["0 est compris comme « pas de plongée » : cela signifie une seule plongée à pleine profondeur."],
    dwellTurns: ["Une longue temporisation au fond : la lame frotte et écrouit la surface."],
  },
});

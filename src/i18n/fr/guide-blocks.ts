import type { GuideBlocksTexts } from "../en/guide-blocks.ts";
import { blockKinds } from "./guide-blocks/kinds.ts";
import { blockWords } from "./guide-blocks/words.ts";
import { typeset } from "./typography/typeset.ts";

export const guideBlocks: GuideBlocksTexts = typeset({
  title: "Séquences d’un programme",
  lead: "Ce que fait chaque séquence, et une page pour chacun de ses mots.",
  words: "Ses mots",
  toBlock: "La séquence",
  inProgram: "Dans le programme",
  rule: "Sur la commande",
  recalled: "De mémoire, non vérifié sur une page imprimée : à contrôler sur votre commande.",
  sampleLead: "Le noyau a exécuté un petit programme avec chacune de ces valeurs.",
  ownLead: "Le noyau a exécuté votre programme avec chacune de ces valeurs ; votre travail reste tel quel.",
  why: {
    name: "Pas d’image animée : un nom ne déplace rien. Il doit seulement être celui que l’on désigne ailleurs.",
    axis: "Pas d’image animée : le noyau coupe dans le plan Z/X, et cet axe n’y est pas.",
    milling: "Pas d’image animée : cela compte au fraisage, et le noyau montre ce que coupe le tournage.",
    free: "Pas d’image animée : un contour libre est gardé ici et n’est pas exécuté.",
    choice:
      "Pas d’image animée : un autre choix demande d’autres séquences autour de lui, et avec les mêmes il ne montre rien.",
    together: "Pas d’image animée : cette valeur va avec d’autres. Changée seule, la commande ne l’accepterait pas.",
    compensation:
      "Pas d’image animée ici : la correction commence et finit par une séquence droite. La page de L la montre.",
    functions:
      "Pas d’image animée ici : parmi les fonctions M, M136 et M137 changent la coupe. La page des fonctions M le montre.",
    same: "Pas d’image animée : avec d’autres valeurs l’outil suit la même trajectoire et laisse la même pièce.",
    yours:
      "Votre séquence n’est pas montrée : avec d’autres valeurs elle coupe la même chose, ou rien que le noyau sache couper," +
      " comme dans un plan fraisé.",
  },
  functions: "Fonctions M",
  kinds: blockKinds,
  of: blockWords,
  rules: {
    "blankCylinder.outside": "D est le ⌀, R le rayon. Il doit être plus grand que l’alésage.",
    "blankCylinder.length": "L compte de la face vers le mandrin.",
    "blankCylinder.distance": "DIST peut manquer : la face est alors en Z0.",
    "blankCylinder.inside": "DI peut manquer pour une barre pleine.",
    "toolCall.tool": "Un numéro, un nom entre guillemets ou un paramètre QS ; 5.1 est un indice de l’outil 5.",
    "spin.cuttingSpeed": "VC compte tant que VCONST est en marche.",
    "spin.speed": "S compte tant que VCONST est à l’arrêt.",
    "spin.speedLimit": "SMAX vaut jusqu’à ce qu’une autre séquence SPIN en donne un.",
    feed: "Une avance vaut jusqu’à la suivante ; une séquence sans F la garde.",
    X: "I devant l’axe le rend incrémental.",
    compensation: "Elle commence et finit par une droite. CC, RND et CHF la gardent.",
    label: "LBL 0 peut revenir autant qu’il faut ; aucun autre deux fois.",
    repeat: "Jusqu’à 65534.",
    target: "Q0 à Q99 sont libres pour l’opérateur.",
    functions: "Quatre au plus ; les fonctions M d’un groupe se remplacent.",
    polarAngle: "Entre −360° et +360°.",
    toolAxis: "Il décide du plan : avec Z c’est X/Y en fraisage, Z/X en tournage.",
  },
  m: {
    M0: "Arrête ; départ CN continue.",
    M1: "Arrête là où l’opérateur l’a activé.",
    M3: "Broche en marche, sens horaire.",
    M4: "Broche en marche, sens antihoraire.",
    M5: "Broche à l’arrêt.",
    M8: "Arrosage en marche.",
    M9: "Arrosage à l’arrêt.",
    M13: "Broche sens horaire et arrosage en marche.",
    M14: "Broche sens antihoraire et arrosage en marche.",
    M30: "Fin du programme, retour au début.",
    M89: "Appelle le cycle après chaque séquence de positionnement.",
    M91: "Les coordonnées de cette séquence comptent du point zéro machine. Où il est, personne ici ne le sait.",
    M92: "Les coordonnées de cette séquence comptent d’un point du constructeur.",
    M99: "Appelle le cycle après cette séquence.",
    M136: "Les avances comptent en mm par tour.",
    M137: "Les avances comptent de nouveau en mm par minute.",
    M140: "Recul de MB dans l’axe de l’outil.",
    M303: "Broche de la pièce en marche ; le constructeur fixe le sens.",
    M304: "Broche de la pièce en marche, dans l’autre sens.",
  },
});

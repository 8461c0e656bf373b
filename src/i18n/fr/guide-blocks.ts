import type { GuideBlocksTexts } from "../en/guide-blocks.ts";
import { blockKinds } from "./guide-blocks/kinds.ts";
import { blockWords } from "./guide-blocks/words.ts";
import { typeset } from "./typography/typeset.ts";

export const guideBlocks: GuideBlocksTexts = typeset({
  title: "Séquences d’un programme",
  lead: "Fonction de chaque séquence, et une page pour chaque mot.",
  words: "Mots",
  toBlock: "Séquence",
  inProgram: "Dans le programme",
  rule: "Sur la commande",
  recalled: "Non vérifié dans un manuel ; à vérifier sur la commande.",
  sampleLead: "Un petit programme simulé avec chacune de ces valeurs.",
  ownLead: "Votre programme simulé avec chacune de ces valeurs ; votre programme n’est pas modifié.",
  why: {
    name: "Pas d’animation : un nom n’a pas d’effet sur la trajectoire. Il doit correspondre au nom utilisé ailleurs.",
    axis: "Pas d’animation : la simulation est dans le plan Z/X, sans cet axe.",
    milling: "Pas d’animation : valable pour le fraisage ; seul le tournage est représenté.",
    free: "Pas d’animation : un contour libre est conservé, mais non simulé.",
    choice: "Pas d’animation : un autre choix exige d’autres séquences et reste sans effet avec celles-ci.",
    together:
      "Pas d’animation : cette valeur dépend d’autres valeurs. Modifiée seule, la commande refuserait la séquence.",
    compensation: "Pas d’animation ici : la correction commence et finit par une droite. Voir la page de L.",
    functions:
      "Pas d’animation ici : parmi les fonctions M, seules M136 et M137 changent la coupe. Voir la page des " +
      "fonctions M.",
    same: "Pas d’animation : d’autres valeurs donnent la même trajectoire et la même pièce.",
    yours:
      "Votre séquence n’est pas représentée : d’autres valeurs donnent la même coupe, ou une coupe non simulée, " +
      "comme en fraisage.",
  },
  functions: "Fonctions M",
  kinds: blockKinds,
  of: blockWords,
  rules: {
    "blankCylinder.outside": "D est le ⌀, R le rayon. Il doit être plus grand que l’alésage.",
    "blankCylinder.length": "L se mesure de la face vers le mandrin.",
    "blankCylinder.distance": "DIST peut être omis : la face est alors en Z0.",
    "blankCylinder.inside": "DI peut être omis pour une barre pleine.",
    "toolCall.tool": "Un numéro, un nom entre guillemets ou un paramètre QS ; 5.1 est un indice de l’outil 5.",
    "spin.cuttingSpeed": "VC s’applique tant que VCONST est actif.",
    "spin.speed": "S s’applique tant que VCONST est inactif.",
    "spin.speedLimit": "SMAX s’applique jusqu’à une autre séquence SPIN qui le modifie.",
    feed: "L’avance est modale ; une séquence sans F la conserve.",
    X: "I devant l’axe : valeur incrémentale.",
    compensation: "La correction commence et finit par une droite. CC, RND et CHF la conservent.",
    label: "LBL 0 peut être utilisé plusieurs fois ; les autres labels une seule fois.",
    repeat: "Jusqu’à 65534.",
    target: "Q0 à Q99 sont libres pour l’opérateur.",
    functions: "Max. quatre ; les fonctions M d’un groupe se remplacent.",
    polarAngle: "Entre −360° et +360°.",
    toolAxis: "Détermine le plan : avec Z, X/Y en fraisage, Z/X en tournage.",
  },
  m: {
    M0: "Arrêt du programme ; continuer avec Start CN.",
    M1: "Arrêt optionnel, si activé par l’opérateur.",
    M3: "Broche en marche, sens horaire.",
    M4: "Broche en marche, sens antihoraire.",
    M5: "Broche à l’arrêt.",
    M8: "Arrosage en marche.",
    M9: "Arrosage à l’arrêt.",
    M13: "Broche sens horaire et arrosage en marche.",
    M14: "Broche sens antihoraire et arrosage en marche.",
    M30: "Fin du programme, retour au début.",
    M89: "Appel de cycle modal après chaque séquence de positionnement.",
    M91: "Les coordonnées de la séquence se rapportent au point zéro machine. Sa position n’est pas connue ici.",
    M92: "Les coordonnées de la séquence se rapportent à un point défini par le constructeur.",
    M99: "Appel de cycle après cette séquence.",
    M136: "Avance en mm par tour.",
    M137: "Avance de nouveau en mm par minute.",
    M140: "Retrait de MB dans l’axe d’outil.",
    M303: "Broche de la pièce en marche ; le constructeur fixe le sens.",
    M304: "Broche de la pièce en marche, dans l’autre sens.",
  },
});

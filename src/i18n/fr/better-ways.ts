import type { BetterWaysTexts } from "../en/better-ways.ts";
import { typeset } from "./typography/typeset.ts";

export const betterWays = typeset<BetterWaysTexts>({
  title: "Améliorations",
  about:
    "Chaque proposition a été simulée : même pièce, surface pas plus rugueuse, aucun message de contrôle supplémentaire.",
  list: "Propositions",
  preparing: "Recherche de modifications…",
  trying: (tried, of) => `${tried} modifications simulées sur ${of}`,
  found: (n, of) =>
    n === 1 ? `1 amélioration ; ${of} modifications simulées.` : `${n} améliorations ; ${of} modifications simulées.`,
  none: (of) => `Aucune amélioration trouvée ; ${of} modifications simulées.`,
  nothing: "Il n’y a aucune modification à essayer dans ce programme.",
  stopped: (tried, of) => `Arrêt : ${tried} modifications simulées sur ${of}.`,
  failed: "Le programme n’a pas pu être calculé.",
  stop: "Arrêter",
  again: "Relancer la recherche",
  use: "Appliquer",
  useLong: (what) => `Appliquer : ${what}`,
  used: (what) => `Appliqué : ${what}.`,
  undo: "Annuler",
  updating: "Nouvelle simulation avec le programme modifié…",
  noTime: "Les données machine n’indiquent pas de temps de changement d’outil : un changement compte 0 s.",
  faulty:
    "Le programme comporte des erreurs : seules sont proposées les modifications qui améliorent le résultat du contrôle.",
  noMaterial: "Le programme n’indique pas de matière : aucune proposition de données de coupe.",
  and: (first, last) => `${first} et ${last}`,
  operation: (n, title) => (title === "" ? `Opération ${n}` : `Opération ${n} « ${title} »`),
  operations: (numbers) => `Opérations ${numbers}`,
  gains: {
    verdict: "Meilleur résultat du contrôle",
    residualGone: (tool) => (tool === "" ? "Sans matière résiduelle" : `Sans matière résiduelle avec l’outil ${tool}`),
    bendsLess: (length) => `Flexion de la pièce réduite de ${length}`,
    residualLess: (area) => `${area} de matière résiduelle en moins`,
    toolGone: (tool) => `Outil ${tool} inutile`,
    toolsLess: (n) => (n === 1 ? "1 outil en moins" : `${n} outils en moins`),
    changesLess: (n) => (n === 1 ? "1 changement d’outil en moins" : `${n} changements d’outil en moins`),
    shorter: (time) => `${time} de moins`,
  },
  measures: {
    seconds: "Temps",
    tools: "Outils",
    changes: "Changements d’outil",
    residual: "Matière résiduelle",
    bending: "Flexion",
  },
  kinds: {
    noCut: (operation) => `${operation} n’enlève rien : à supprimer.`,
    fewerTools: (operations, tool) => `${operations} avec l’outil ${tool}, que le programme appelle déjà.`,
    severalTools: (operations, tools) => `${operations} avec les outils ${tools}, que le programme appelle déjà.`,
    fewerChanges: (operation, next) => `${operation} à côté de ${next} : les deux ont le même outil.`,
    restOperation: (operation, tool) =>
      `${operation}, puis une opération de plus avec l’outil ${tool} pour la matière résiduelle.`,
    otherTool: (operation, tool, instead) => `${operation} avec l’outil ${tool} au lieu de ${instead}.`,
    otherCycle: (operation, cycle) => `${operation} avec le cycle ${cycle}.`,
    otherCycleAndTool: (operation, cycle, tool) => `${operation} avec le cycle ${cycle} et l’outil ${tool}.`,
    otherChoice: (operation, value) => `${operation} : ${value}.`,
    infeed: (operation, value, tool, most) =>
      `${operation} : ${value}. Limite prudente de l’outil ${tool}, selon l’arête, la puissance de broche et la rigidité : ${most}.`,
    stiffness: (operation, value, most) =>
      `${operation} : ${value}. La pièce est élancée ; sa flexion permet ${most} au plus.`,
    start: (operation, axis, from, to) =>
      `${operation} coupe d’abord dans le vide : point de départ ${axis} ${to} au lieu de ${from}.`,
    oneCall: (operations) => `${operations} en un seul appel, ébauche et finition.`,
    cuttingSpeed: (operations, from, to, material) =>
      `${operations} : vitesse de coupe ${from} → ${to} m/min, selon les données de coupe de ${material}.`,
    feed: (operation, value, material) =>
      `${operation} : ${value}, selon les données de coupe de ${material} et le rayon de bec.`,
  },
});

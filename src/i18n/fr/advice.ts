import type { AdviceTexts } from "../en/advice.ts";
import { typeset } from "./typography/typeset.ts";

export const advice: AdviceTexts = typeset({
  title: "Conseils",
  lead: "Règles du métier appliquées à vos valeurs. Ce sont des estimations : machine, revêtement et serrage ne sont pas connus ici.",
  none: "Rien à conseiller sur ces valeurs.",
  nothingOpen: "Ouvrez un travail pour obtenir des conseils sur ses valeurs.",
  mark: (n) => (n === 1 ? "1 conseil" : `${n} conseils`),
  show: "Donner des conseils",
  take: (value) => `Prendre ${value}`,
  operation: (n, cycle) => `Opération ${n}, cycle ${cycle}`,
  of: {
    depthOverEdge: (depth, edge, most) =>
      `La passe fait ${depth} mm, l’arête ${edge} mm. Deux tiers, soit ${most} mm, est ce qu’une arête devrait porter.`,
    feedOverNose: (feed, nose, most) =>
      `Une avance de ${feed} mm dépasse 0,8 du rayon de bec ${nose} mm. Jusqu’à ${most} mm, le bec tient.`,
    rough: (rz, feed, nose, wanted, better) =>
      `Avance ${feed} mm et bec ${nose} mm laissent Rz ${rz} µm (f² / 8r). Rz ${wanted} µm demande ${better} mm.`,
    power: (power, most, speed, better) =>
      `Environ ${power} kW à ${speed} m/min (Kienzle) ; la broche a ${most} kW. Une passe de ${better} mm s’en contente.`,
    speedLimited: (limit, held, smallest, left) =>
      `Avec SMAX ${limit}, la vitesse de coupe est tenue jusqu’à ⌀ ${held}. À ⌀ ${smallest}, il n’en reste que ${left} m/min.`,
    noLimit: (speed) =>
      `${speed} m/min sans SMAX : vers l’axe, la broche tourne aussi vite qu’elle peut. Donnez une limite.`,
    speedFar: (speed, usual) => `${speed} m/min est loin des ${usual} m/min usuels au départ pour cette matière.`,
  },
  material: "Matière",
  ofDevice: "celle de cet appareil",
  deviceMaterial: "Matière des travaux qui n’en nomment pas",
  groups: {
    P: "acier",
    M: "acier inoxydable",
    K: "fonte",
    N: "métal non ferreux",
    S: "difficile à usiner",
    H: "acier trempé",
  },
  starting: "Valeurs de départ",
  startingLead:
    "Pour carbure revêtu, CBN pour l’acier trempé, pour commencer ; le fabricant de la plaquette sait mieux.",
  start: (material, speeds) => `${material} : ${speeds} pour commencer.`,
  startSource: "Estimation d’après des manuels : carbure revêtu, CBN pour l’acier trempé.",
  startOwn: "D’après votre propre tableau.",
  values: {
    roughSpeed: "vc ébauche",
    roughFeed: "f ébauche",
    finishSpeed: "vc finition",
    finishFeed: "f finition",
    kc11: "kc1.1",
    mc: "mc",
  },
  units: { speed: "m/min", feed: "mm/tr", kc: "N/mm²" },
  spindle: "Vitesse de coupe",
  table: {
    title: "Données de coupe de l’atelier",
    lead:
      "Remplacez les valeurs par les vôtres ; elles restent sur cet appareil et vont dans le fichier de tout. " +
      "kc1.1 et mc d’origine suivent les tables de Röhm (aciers, fonte grise) et d’Iscar (les autres) : des estimations.",
    name: "Matière",
    group: "Groupe",
    power: "Puissance de la broche, kW",
    add: "Ajouter une matière",
    remove: (name) => `Supprimer ${name}`,
    reset: "Revenir aux valeurs fournies",
    save: "Enregistrer en fichier",
    open: "Depuis un fichier",
    taken: "Le fichier a été repris.",
    wrong: "Ce fichier ne contient pas de données de coupe.",
    cell: (what, name) => `${what}, ${name}`,
    newName: "Nouvelle matière",
    refused: "Cette valeur ne peut pas figurer ici ; la dernière possible compte.",
  },
} satisfies AdviceTexts);

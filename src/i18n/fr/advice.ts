import type { AdviceTexts } from "../en/advice.ts";
import { typeset } from "./typography/typeset.ts";

export const advice: AdviceTexts = typeset({
  title: "Conseils",
  lead: "Règles empiriques appliquées à vos valeurs. Estimations : machine, revêtement et serrage ne sont pas connus.",
  none: "Aucun conseil sur ces valeurs.",
  nothingOpen: "Ouvrir un programme pour obtenir des conseils sur ses valeurs.",
  mark: (n) => (n === 1 ? "1 conseil" : `${n} conseils`),
  show: "Afficher les conseils",
  take: (value) => `Utiliser ${value}`,
  operation: (n, cycle) => `Opération ${n}, cycle ${cycle}`,
  of: {
    depthOverEdge: (depth, edge, most) =>
      `La passe fait ${depth} mm, l’arête ${edge} mm. Max. deux tiers de l’arête : ${most} mm.`,
    feedOverNose: (feed, nose, most) => `L’avance ${feed} mm dépasse 0,8 × rayon de bec ${nose} mm. Max. ${most} mm.`,
    rough: (rz, feed, nose, wanted, better) =>
      `Avance ${feed} mm et rayon de bec ${nose} mm donnent Rz ${rz} µm (f² / 8r). Pour Rz ${wanted} µm : ${better} mm.`,
    power: (power, most, speed, better) =>
      `Environ ${power} kW à ${speed} m/min (Kienzle) ; la broche a ${most} kW. Suffisant pour une passe de ${better} mm.`,
    speedLimited: (limit, held, smallest, left) =>
      `Avec SMAX ${limit}, la vitesse de coupe est constante jusqu’à ⌀ ${held}. À ⌀ ${smallest}, il ne reste que ${left} m/min.`,
    noLimit: (speed) =>
      `${speed} m/min sans SMAX : vers l’axe, la broche tourne à sa vitesse maximale. Indiquer une limite.`,
    speedFar: (speed, usual) =>
      `${speed} m/min est loin de la valeur de départ usuelle pour cette matière : ${usual} m/min.`,
  },
  material: "Matière",
  ofDevice: (material) => `Par défaut : ${material}`,
  deviceMaterial: "Matière par défaut",
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
    "Pour carbure revêtu, CBN pour l’acier trempé. Valeurs de départ ; suivre les données du fabricant de la " +
    "plaquette.",
  start: (material, speeds) => `${material} : ${speeds} pour commencer.`,
  startSource: "Estimation d’après des manuels : carbure revêtu, CBN pour l’acier trempé.",
  startOwn: "D’après votre tableau.",
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
      "Remplacer les valeurs par les vôtres ; elles sont enregistrées sur cet appareil et font partie de la " +
      "sauvegarde. kc1.1 et mc par défaut suivent les tables de Röhm (aciers, fonte grise) et d’Iscar (les " +
      "autres) : des estimations.",
    name: "Matière",
    group: "Groupe",
    power: "Puissance de la broche, kW",
    add: "Ajouter une matière",
    remove: (name) => `Supprimer ${name}`,
    reset: "Restaurer les valeurs par défaut",
    save: "Exporter",
    open: "Importer",
    taken: "Le fichier a été importé.",
    wrong: "Ce fichier ne contient pas de données de coupe.",
    cell: (what, name) => `${what}, ${name}`,
    newName: "Nouvelle matière",
    refused: "Valeur non valide ; la dernière valeur valide s’applique.",
  },
} satisfies AdviceTexts);

import type { HandedTexts } from "../en/handed.ts";

const tools = (n: number) => (n === 1 ? "1 outil" : `${n} outils`);

export const handed = {
  title: "Transmettre",
  lead:
    "Qui l’ouvre voit la même image, les mêmes nombres et le même verdict. Aucun serveur n’intervient : tout est dans le lien, ou dans " +
    "le fichier.",
  working: "Recherche des outils nécessaires …",
  along: "Ce qui est transmis",
  facts: {
    name: "Nom",
    kind: "Type",
    blocks: "Séquences",
    files: "Fichiers joints",
    tools: "Outils",
    control: "Commande",
    machine: "Machine",
    size: "Taille",
  },
  program: "Programme entier",
  cycle: (number, name) => `Cycle ${number}, ${name}`,
  none: "aucun",
  kilobytes: (n) => `${n} ko`,
  link: "Lien",
  copyLink: "Copier le lien",
  linkLong: "Beaucoup de messageries coupent un lien de cette longueur. Transmettre plutôt le fichier.",
  hereOnly:
    "Cette page n’existe que sur cet appareil : un autre ne peut pas ouvrir le lien. Transmettre plutôt le fichier.",
  linkTooLong: "Le lien serait trop long pour un navigateur. Transmettre plutôt le fichier.",
  qr: "Code QR",
  qrName: (name) => `Code QR du lien vers ${name}`,
  qrHint: "Viser avec la caméra d’une tablette.",
  qrTooLong: (length, most) =>
    `Avec ${length} caractères, le lien est trop long pour un code lisible par une caméra ; ${most} au plus.`,
  share: "Partager …",
  files: "Fichiers",
  file: "En fichier",
  report: "Rapport (JSON)",
  reportHint:
    "Le rapport est le même à l’octet près partout où ce travail est ouvert sans être modifié : comparer les deux fichiers.",
  noReport: "Le calcul n’a pas donné de rapport ; tous les outils du tableau sont donc transmis.",

  inside: (name) => `Ouvrir ${name} ?`,
  from: { link: "Ce lien contient un travail.", file: "Ce fichier contient un travail." },
  open: "Ouvrir",
  notNow: "Pas maintenant",
  ofItsOwn: "Il devient un travail à part ; rien de ce qui existe n’est modifié.",
  bare: "aucun : utilise les outils de cet appareil",
  tool: (number, name) => `T${number} ${name}`.trim(),
  state: {
    same: "comme dans votre tableau",
    free: "absent de votre tableau",
    differs: "autres valeurs que les vôtres",
  },
  sameControl: "comme sur cet appareil",
  otherControl: (mine) => `cet appareil : ${mine}`,

  bar: (n) => `Le travail ouvert utilise ${n === 1 ? "son propre outil" : `ses ${n} propres outils`}.`,
  barControl: (control) => `Le travail ouvert s’exécute comme sur une ${control}, tel qu’il a été transmis.`,
  barMachine: (machine) =>
    `Les temps du programme ouvert utilisent d’autres données machine que celles de cet appareil : ${machine}.`,
  ofWork: "Outils de ce travail",
  ofWorkLead: "Il a été transmis avec ces outils et les utilise à la place du tableau de cet appareil.",
  theirs: "Avec le travail",
  mine: "Dans votre tableau",
  column: "Colonne",
  becomes: (tool) => `Ce que devient ${tool}`,
  as: { mine: "Garder le mien", theirs: "Prendre le sien", free: "Mettre le sien sous un numéro libre" },
  keep: "Garder ces outils dans mon tableau",
  kept: (added, replaced) =>
    [
      added > 0 && `${tools(added)} ajouté${added === 1 ? "" : "s"} à votre tableau`,
      replaced > 0 && `${tools(replaced)} remplacé${replaced === 1 ? "" : "s"}`,
    ]
      .filter(Boolean)
      .join(", ") + ".",
  nothingToKeep: "Rien à faire : votre tableauau reste tel quel.",
  allMine: "Votre tableau les contient tous, tels quels.",
  moved: (from, to) =>
    `L’outil ${from} du travail est l’outil ${to} dans votre tableau : TOOL CALL doit y nommer ${to}.`,
  changeCalls: (n) => (n === 1 ? "Le modifier dans 1 TOOL CALL" : `Le modifier dans ${n} TOOL CALL`),
  callsChanged: "Le programme appelle les nouveaux numéros.",
  useMine: "Utiliser plutôt mon tableau",
  control: (its, mine) => `Commande de ce travail : ${its}. Cet appareil : ${mine}.`,
  useControl: (mine) => `Utiliser plutôt ${mine}`,
  machine: (its, mine) => `Machine de ce programme : ${its}. Cet appareil : ${mine}.`,
  useMachine: "Utiliser les données machine de cet appareil",
  noMachine: "aucune",
} satisfies HandedTexts;

import type { HandedTexts } from "../en/handed.ts";
import { typeset } from "./typography/typeset.ts";

const tools = (n: number) => (n === 1 ? "1 outil" : `${n} outils`);

export const handed = typeset<HandedTexts>({
  title: "Partager",
  lead: "Le destinataire voit la même simulation et le même résultat. Aucun serveur n’intervient.",
  working: "Recherche des outils nécessaires …",
  contents: "Contenu",
  facts: {
    name: "Nom",
    kind: "Type",
    blocks: "Séquences",
    files: "Autres fichiers",
    tools: "Outils",
    control: "Commande",
    machine: "Machine",
    size: "Taille",
  },
  program: "Programme CN",
  cycle: (number, name) => `Cycle ${number}, ${name}`,
  none: "aucun",
  kilobytes: (n) => `${n} ko`,
  link: "Lien",
  copyLink: "Copier le lien",
  linkLong: "Beaucoup de messageries coupent un lien de cette longueur. Partager plutôt le fichier.",
  hereOnly:
    "Cette page est sur cet appareil seulement : un autre appareil ne peut pas ouvrir le lien. Partager plutôt le fichier.",
  linkTooLong: "Le lien est trop long pour un navigateur. Partager plutôt le fichier.",
  qr: "Code QR",
  qrName: (name) => `Code QR du lien vers ${name}`,
  qrEnlarge: "Afficher le code QR en plein écran",
  qrHint: "Scanner avec la caméra d’une tablette.",
  qrTooLong: (length, most) =>
    `Le lien est trop long pour un code QR : ${length} caractères, max. ${most}. Partager le lien ou le fichier.`,
  share: "Partager …",
  files: "Fichiers",
  file: "En fichier",
  report: "Rapport (JSON)",
  reportHint:
    "Le rapport est identique à l’octet près partout où ce programme est ouvert sans modification : comparer les deux fichiers.",
  noReport: "Aucun rapport disponible ; tous les outils du tableau sont donc inclus.",

  inside: (name) => `Ouvrir ${name} ?`,
  from: { link: "Ce lien contient un programme.", file: "Ce fichier contient un programme." },
  open: "Ouvrir",
  notNow: "Pas maintenant",
  opensSeparately: "S’ouvre comme programme à part ; vos programmes restent inchangés.",
  bare: "aucun : utilise les outils de cet appareil",
  tool: (number, name) => `T${number} ${name}`.trim(),
  state: {
    same: "comme dans votre tableau",
    free: "absent de votre tableau",
    differs: "autres valeurs que les vôtres",
  },
  sameControl: "comme sur cet appareil",
  otherControl: (mine) => `cet appareil : ${mine}`,

  bar: (n) => `Le programme ouvert utilise ${n === 1 ? "son propre outil" : `ses ${n} propres outils`}.`,
  barControl: (control) => `Le programme ouvert est simulé pour une ${control}, tel que partagé.`,
  barMachine: (machine) =>
    `Les temps du programme ouvert utilisent d’autres données machine que celles de cet appareil : ${machine}.`,
  ofWork: "Outils de ce programme",
  ofWorkLead: "Ce programme a été partagé avec ces outils et les utilise, pas le tableau de cet appareil.",
  theirs: "Avec le programme",
  mine: "Dans votre tableau",
  column: "Colonne",
  becomes: (tool) => `Action pour ${tool}`,
  as: { mine: "Garder le mien", theirs: "Utiliser le sien", free: "Ajouter le sien sous un numéro libre" },
  keep: "Ajouter ces outils à mon tableau",
  kept: (added, replaced) =>
    [
      added > 0 && `${tools(added)} ajouté${added === 1 ? "" : "s"} à votre tableau`,
      replaced > 0 && `${tools(replaced)} remplacé${replaced === 1 ? "" : "s"}`,
    ]
      .filter(Boolean)
      .join(", ") + ".",
  nothingToKeep: "Votre tableau reste inchangé.",
  allMine: "Votre tableau contient déjà ces outils avec les mêmes valeurs.",
  moved: (from, to) =>
    `L’outil ${from} du programme est l’outil ${to} dans votre tableau : TOOL CALL doit y nommer ${to}.`,
  changeCalls: (n) => (n === 1 ? "Modifier 1 TOOL CALL" : `Modifier ${n} TOOL CALL`),
  callsChanged: "Le programme appelle les nouveaux numéros.",
  useMine: "Utiliser plutôt mon tableau",
  control: (its, mine) => `Commande de ce programme : ${its}. Cet appareil : ${mine}.`,
  useControl: (mine) => `Utiliser plutôt ${mine}`,
  machine: (its, mine) => `Machine de ce programme : ${its}. Cet appareil : ${mine}.`,
  useMachine: "Utiliser les données machine de cet appareil",
  noMachine: "aucune",
});

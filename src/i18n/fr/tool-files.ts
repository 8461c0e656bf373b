import type { ToolFileTexts } from "../tool-file-text.ts";
import { typeset } from "./typography/typeset.ts";

export const toolFiles = typeset<ToolFileTexts>({
  title: (files) => `Importation de ${files}`,
  fresh: (n) => `${n} nouveaux`,
  changed: (n) => `${n} modifiés`,
  same: (n) => `${n} inchangés`,
  wrong: (n) => `${n} avec erreur`,
  nothing: "Aucune modification.",
  more: (n) => `et ${n} autres`,
  empty: "vide",
  outline: "contour",
  newOutline: "nouveau contour",
  takeAll: (n) => `Tout importer (${n})`,
  takeNew: (n) => `Seulement les nouveaux (${n})`,
  changeColumns: "Modifier les colonnes",
  cancel: "Annuler",
  keptInFile: (names) => `Colonnes non affichées ici : ${names}. Elles restent avec le fichier et sont réexportées.`,
  leftOut: (names) => `Colonnes inconnues : ${names}.`,
  taken: (files, fresh, changed) => `${files} : ${fresh} nouveaux, ${changed} modifiés.`,
  export: "Exporter",
  exportLong: "Exporter le tableau d’outils dans un fichier",
  exportTitle: "Quel fichier ?",
  again: (file) => `${file} tel qu’importé, avec les modifications`,
  againHint:
    "Seuls les outils modifiés sont réécrits ; toutes les autres lignes, colonnes et caractères sont conservés.",
  againDone: (file, changed, added, removed) =>
    `${file} : ${changed} modifiés, ${added} ajoutés, ${removed} retirés ; le reste inchangé.`,
  againShipped: (n) =>
    n === 1
      ? "1 outil standard n’est pas écrit dans le fichier."
      : `${n} outils standard ne sont pas écrits dans le fichier.`,
  tooLong: (cells) => `Plus long que la colonne, laissé inchangé : ${cells}.`,
  notEncodable: "Des caractères d’un nom manquent dans le codage du fichier : enregistré en UTF-8.",
  turning: "TOOLTURN.TRN, outils de tournage",
  milling: "TOOL.T, outils de fraisage et de perçage",
  sheet: "TOOLS.csv, pour un tableur",
  json: "TOOLS.json, tout",
  noHolders: "Porte-outils et limites non inclus.",
  roundsHint: "Longueurs à quatre décimales, angles à trois.",
  sheetHint: "Toutes les colonnes et les porte-outils ; séparateurs pour les tableurs de votre langue.",
  jsonHint: "Toutes les colonnes et les porte-outils, rien d’arrondi ; lu par la commande verify.",
  noTools: "aucun outil",
  importLong: "Importer des outils de fichiers : tables d’outils, listes et bibliothèques",
  notATable: (file) =>
    `${file} ne contient pas d’outils sous une forme connue : tableau de la commande, JSON, liste avec une colonne T, LinuxCNC, Fusion, HSMWorks, FreeCAD, DIN 4000 ou ISO 13399.`,
});

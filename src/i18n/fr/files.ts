import type { FilesTexts } from "../en/files.ts";
import { typeset } from "./typography/typeset.ts";

export const files = typeset<FilesTexts>({
  changed: {
    title: (file) => `${file} a changé sur l’appareil`,
    text: "Le fichier diffère de la version ouverte ou enregistrée ici. Rien n’a été écrit.",
  },
  gone: {
    title: (file) => `${file} n’est plus là`,
    text: "Le fichier a été déplacé, renommé ou supprimé. Rien n’a été écrit.",
  },
  refused: {
    title: (file) => `Pas le droit d’écrire ${file}`,
    text: "Le navigateur n’a pas l’autorisation d’écrire le fichier.",
  },
  failed: {
    title: (file) => `${file} n’a pas pu être écrit`,
    text: "L’appareil a refusé le fichier. Le programme est toujours ouvert ici.",
  },
  compare: "Comparer",
  overwrite: "Remplacer",
  elsewhere: "Enregistrer dans un autre fichier",
  download: "Télécharger",
  cancel: "Annuler",
  choose: {
    title: "Quel programme ?",
    lead: (programs) =>
      `${programs} programmes ne sont appelés par aucun autre. Chacun s’ouvre à part, avec les fichiers qu’il appelle.`,
    open: (file) => `Ouvrir ${file}`,
    with: (count) => (count === 1 ? "avec 1 fichier" : `avec ${count} fichiers`),
    alone: "n’appelle aucun fichier",
    all: (count) => `Ouvrir les ${count}`,
    together: "Tout ouvrir comme un seul programme",
    skipped: (count) =>
      count === 1
        ? "1 fichier n’est pas un texte de programme et a été ignoré."
        : `${count} fichiers ne sont pas des textes de programme et ont été ignorés.`,
    cut: "Le dossier contient trop de fichiers pour une seule ouverture. Le reste a été ignoré.",
  },
});

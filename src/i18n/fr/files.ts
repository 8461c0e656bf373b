import type { FilesTexts } from "../en/files.ts";

export const files: FilesTexts = {
  changed: {
    title: (file) => `${file} a changé sur l’appareil`,
    text: "Le fichier contient autre chose que ce qui a été lu ou enregistré ici. Rien n’a été écrit.",
  },
  gone: {
    title: (file) => `${file} n’est plus là`,
    text: "Le fichier a été déplacé, renommé ou supprimé. Rien n’a été écrit.",
  },
  refused: { title: (file) => `${file} ne peut pas être écrit`, text: "Le navigateur n’en a pas reçu le droit." },
  failed: {
    title: (file) => `${file} n’a pas pu être écrit`,
    text: "L’appareil n’a pas accepté le fichier. Le programme est toujours ici.",
  },
  compare: "Comparer avec lui",
  overwrite: "Écraser",
  elsewhere: "Enregistrer dans un autre fichier",
  download: "Télécharger",
  cancel: "Annuler",
  choose: {
    title: "Quel programme ?",
    lead: (programs) =>
      `${programs} programmes qu’aucun autre n’appelle. Chacun devient un travail à part, avec les fichiers qu’il appelle.`,
    open: (file) => `Ouvrir ${file}`,
    with: (count) => (count === 1 ? "avec 1 fichier" : `avec ${count} fichiers`),
    alone: "n’appelle rien",
    all: (count) => `Ouvrir les ${count}`,
    together: "Tout ouvrir comme un seul travail",
    skipped: (count) =>
      count === 1
        ? "1 fichier n’est pas un texte de programme et a été laissé."
        : `${count} fichiers ne sont pas des textes de programme et ont été laissés.`,
    cut: "Le dossier contient plus que ce qui s’ouvre d’un coup. Le reste a été laissé.",
  },
};

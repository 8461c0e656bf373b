import type { DeviceTexts } from "../en/device.ts";
import { typeset } from "./typography/typeset.ts";

export const device = typeset<DeviceTexts>({
  works: {
    count: (n) => (n === 1 ? "1 programme sur cet appareil" : `${n} programmes sur cet appareil`),
    found: (n, of) => `${n} sur ${of}`,
    none: "Aucun programme n’est encore enregistré sur cet appareil.",
    noMatch: "Aucun programme n’a ces mots dans son nom.",
    back: "Page d’accueil",
    search: "Chercher un programme par nom ou cycle",
    sort: "Ordre",
    orders: { newest: "Récents d’abord", name: "Par nom", kind: "Par type", size: "Les plus grands d’abord" },
    list: "Programmes",
    program: "Programme CN",
    open: (name) => `Ouvrir ${name}`,
    rename: (name) => `Renommer ${name} (F2)`,
    newName: (name) => `Nouveau nom de ${name}`,
    duplicate: (name) => `Dupliquer ${name}`,
    remove: (name) => `Supprimer ${name}`,
    select: (name) => `Sélectionner ${name}`,
    more: (n) => `Afficher ${n} de plus`,
    selectAll: "Tout sélectionner",
    selected: (n) => (n === 1 ? "1 sélectionné" : `${n} sélectionnés`),
    removeSelected: "Supprimer",
    saveSelected: "Sauvegarder",
    removed: (n, name) => (n === 1 ? `${name} a été supprimé.` : `${n} programmes ont été supprimés.`),
    removing: (n) => `Suppression de ${n} programmes …`,
    notRemoved: (n) =>
      n === 1 ? "L’appareil n’a pas supprimé 1 programme." : `L’appareil n’a pas supprimé ${n} programmes.`,
    renamed: (name) => `Renommé en ${name}.`,
    duplicated: (name) => `${name} a été créé.`,
    saved: (n) =>
      n === 1
        ? "1 programme a été sauvegardé dans les téléchargements."
        : `${n} programmes ont été sauvegardés dans les téléchargements.`,
    nameTaken: (name) => `Un autre fichier de ce programme s’appelle ${name}.`,
    leftOut: (n) =>
      n === 1
        ? "1 programme est ouvert dans un autre onglet et n’a pas changé."
        : `${n} programmes sont ouverts dans d’autres onglets et n’ont pas changé.`,
    unread: {
      title: "Données illisibles",
      lead: "Conservées sur cet appareil jusqu’à ce que vous les supprimiez.",
      damaged: "illisible",
      newer: "d’une version plus récente de cette page",
      save: (name) => `Télécharger ${name} tel qu’enregistré`,
    },
    failed: "L’appareil a refusé la modification. Tout est inchangé.",
  },
  here: {
    title: "Cet appareil",
    forGood: "Les programmes restent jusqu’à leur suppression.",
    mayGo: "Si la place manque, le navigateur peut effacer les programmes.",
    unsure: "Ce navigateur ne dit pas s’il peut effacer les programmes.",
    ask: "Conserver les données",
    refused: "Le navigateur ne garantit pas la conservation. Sauvegarder de temps en temps.",
    used: (used, of) => `${used} utilisés sur ${of}`,
    exportAll: "Tout sauvegarder",
    exportLong:
      "Sauvegarder tous les programmes, outils, cycles personnalisés, réglages et données du cours dans un fichier",
    importAll: "Restaurer",
    importLong:
      "Restaurer programmes, outils, cycles personnalisés, réglages et données du cours depuis une sauvegarde",
    exported: (n, files) =>
      `${n === 1 ? "1 programme" : `${n} programmes`}, outils, cycles personnalisés, réglages et données du cours ont été sauvegardés dans les téléchargements${files > 1 ? `, en ${files} fichiers` : ""}.`,
    notExported: "La sauvegarde n’a pas pu être créée.",
  },
  restore: {
    busy: "Restauration en cours …",
    title: (name) => `Contenu de ${name}`,
    works: (n) => (n === 1 ? "1 programme" : `${n} programmes`),
    all: "Tous",
    states: { fresh: "nouveau", same: "déjà ici", beside: "ajouté comme second programme du même nom" },
    allSame: "Tout le contenu est déjà sur cet appareil.",
    tools: (n) => `Tableau d’outils : ${n} ${n === 1 ? "outil" : "outils"}`,
    own: (n) => `Cycles personnalisés : ${n}`,
    parts: (n) => `Pièces finies : ${n}`,
    keep: "Garder les miens",
    missing: (n) => (n === 1 ? "Ajouter celui qui manque ici" : `Ajouter les ${n} qui manquent ici`),
    replace: "Remplacer les miens par ceux-ci",
    sameTable: "identique à ici",
    course: "Cours : avancement, exercices de votre formateur, formulaires et résultats",
    courseLong: "Les meilleurs résultats de cet appareil sont conservés",
    settings: "Restaurer aussi les réglages",
    settingsLong: "Langue, apparence et options d’affichage",
    unread: (n, names) =>
      n === 1 ? `1 programme est illisible : ${names}` : `${n} programmes sont illisibles : ${names}`,
    unreadRows: (n, names) =>
      n === 1
        ? `1 entrée est illisible et laissée de côté : ${names}`
        : `${n} entrées sont illisibles et laissées de côté : ${names}`,
    unreadParts: {
      tools: "Le tableau d’outils de la sauvegarde est illisible.",
      own: "Les cycles personnalisés de la sauvegarde sont illisibles.",
      parts: "Les pièces finies de la sauvegarde sont illisibles.",
      settings: "Les réglages de la sauvegarde sont illisibles.",
      course: "L’avancement du cours de la sauvegarde est illisible.",
      taught: "Les exercices du formateur de la sauvegarde sont illisibles.",
      sets: "Les séries d’exercices du formateur de la sauvegarde sont illisibles.",
      exams: "Les examens de la sauvegarde sont illisibles.",
      forms: "Les formulaires d’exercices de la sauvegarde sont illisibles.",
      worked: "Les temps de travail des exercices de la sauvegarde sont illisibles.",
      results: "Les résultats des apprenants de la sauvegarde sont illisibles.",
      columns: "Les colonnes attribuées des listes d’outils de la sauvegarde sont illisibles.",
    },
    take: "Restaurer",
    nothing: "Aucune sélection",
    done: (n) => (n === 1 ? "1 programme a été restauré." : `${n} programmes ont été restaurés.`),
    doneBeside: "Les autres données choisies ont été restaurées.",
    notKept: (n) =>
      n === 1
        ? "Pas de place sur cet appareil pour 1 programme."
        : `Pas de place sur cet appareil pour ${n} programmes.`,
    showAll: "Afficher tous les programmes",
    problems: {
      notAnArchive: (name) => `${name} ne contient aucun programme de Turnwise.`,
      damaged: (name) => `${name} est endommagé : rien n’a été restauré.`,
      tooLarge: (name) => `${name} contient trop de données pour une seule restauration.`,
      newer: (name) =>
        `${name} vient d’une version plus récente de cette page. Recharger la page pour obtenir cette version.`,
      unreadable: (name) => `${name} n’a pas pu être lu.`,
    },
  },
  elsewhere: {
    isOpen: (name) => `${name} est ouvert dans un autre onglet`,
    isOpenLead: "Un seul onglet peut modifier un programme, pour que rien ne se perde.",
    wasTaken: (name) => `${name} est maintenant modifié dans un autre onglet`,
    wasTakenLead: "La version la plus récente a été transférée ; rien n’est perdu.",
    take: "Modifier ici",
    editAgain: "Modifier de nouveau ici",
    takeLong: "L’autre onglet transfère sa version la plus récente et cesse de modifier.",
    copy: "Modifier une copie",
    copyLong: "Les deux sont conservés, la copie sous son propre nom.",
    taking: "En attente de l’autre onglet",
  },
  died: {
    title: (name) => `${name} était ouvert lorsque la page s’est arrêtée de façon inattendue`,
    lead: "Le programme n’a pas été rouvert, car il peut en être la cause. Tout ce qui avait été saisi est conservé.",
    open: "Ouvrir quand même",
    copy: "Copier le texte",
    copied: "Copié",
    notCopied: "Non copié : sélectionnez le texte et copiez-le à la main.",
    save: "Télécharger en fichier",
    text: "Texte du programme",
  },
  reports: {
    title: "Rapports d’erreurs",
    lead: "Enregistrés sur cet appareil seulement. Une copie aide à corriger l’erreur.",
    none: "Aucun rapport.",
    text: "Texte du rapport",
    copy: "Copier le rapport",
    copied: "Copié",
    notCopied: "Non copié : sélectionner le texte et le copier à la main.",
    remove: "Supprimer les rapports",
    withProgram: "Avec le programme",
    work: "Télécharger le programme",
  },
});

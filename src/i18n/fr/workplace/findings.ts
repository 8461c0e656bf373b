import type { FindingsTexts } from "../../en/workplace/findings.ts";

export const findings = {
  title: "Constats",
  list: "Constats, les plus graves d’abord",
  none: "Aucun constat.",
  count: (n) => (n === 1 ? "1 constat" : `${n} constats`),
  more: (n) => (n === 1 ? "1 autre constat n’est pas listé." : `${n} autres constats ne sont pas listés.`),
  severities: { error: "Erreur", warning: "Avertissement", info: "Remarque" },
  inBlock: (block) => `séquence ${block}`,
  blockOf: (block, file) => `séquence ${block} de ${file}`,
  lineOf: (line, file) => `ligne ${line} de ${file}`,
  goTo: (place) => `Aller à ${place}`,
  show: (mark) => `Montrer ${mark} dans la vue du tour`,
  places: {
    tool: "Outil",
    startX: "Départ X",
    startZ: "Départ Z",
    contour: "Contour",
    blank: "Brut",
    spindle: "Broche",
  },
  fix: "Corriger",
  insert: (text) => `Insérer ${text}`,
  write: (text, block) => `Écrire ${text} dans la séquence ${block}`,
  meant: "Cette passe est voulue",
  remove: (text) => `Supprimer ${text}`,
  residue: {
    askCycle: "Quel cycle l’enlève ?",
    thick: (mm) => `Son épaisseur atteint ${mm} mm.`,
    ask: "Quel outil l’enlève ?",
    trying: "Les outils du tableau sont essayés.",
    all: (tool) => `L’outil ${tool} ne laisse rien ici.`,
    leaves: (tool, area) => `L’outil ${tool} laisse ${area}.`,
    none: "Aucun outil du tableau n’en enlève davantage.",
  },
  verdict: {
    title: "Contrôle",
    none: "–",
    proved: "Contrôlé : contour intact, aucun rapide dans la matière",
    stays: (area) => `Contrôlé ; il reste ${area} de matière`,
    warnings: (n) => (n === 1 ? "Contrôlé, avec 1 avertissement" : `Contrôlé, avec ${n} avertissements`),
    holderUnknown: "Trajectoire contrôlée, porte-outil non contrôlé",
    faults: (n) => (n === 1 ? "1 défaut" : `${n} défauts`),
    unproved: "Tout n’a pas été simulé",
    nothingCut: "Un usinage n’a rien enlevé",
    noCycle: "Sans cycle : aucun rapide dans la matière",
    noOperation: "Rien n’est contrôlé",
    milling: "Le fraisage n’est pas contrôlé",
    flanksUnknown: "Trajectoire contrôlée, flancs non contrôlés",
    curvatureUnknown: "Trajectoire contrôlée, courbure de lame non contrôlée",
    faultsIn: (n, file) => (n === 1 ? `1 défaut, dans ${file}` : `${n} défauts, le premier dans ${file}`),
    unprovedIn: (file) => `Tout n’a pas été simulé dans ${file}`,
    notes: "Trajectoire vérifiée, voir les remarques",
    because: {
      notes: {
        feed: "Une avance n’est guère voulue ainsi.",
        air: "La plupart des passes d’une opération usinent dans le vide.",
        residue: "Il reste plus de 1 mm² de matière qui n’est pas demandé.",
        cutLength: "L’arête est trop courte pour la profondeur d’une opération.",
      },
      whatIn: (what, file) => `${what} dans ${file}`,
      unproved: (what, block) => `À partir de la séquence ${block}, rien n’est contrôlé : ${what} n’est pas simulé.`,
      unprovedAnywhere: (what) => `${what} n’est pas simulé : rien n’est contrôlé.`,
      nothingCut: (cycle, block) => `Le cycle ${cycle}, appelé dans la séquence ${block}, n’a rien enlevé.`,
      milling: (block) => `Le fraisage à partir de la séquence ${block} modifie le brut et n’est pas contrôlé.`,
      noCycle:
        "Aucun cycle de tournage n’a été exécuté : les rapides sont contrôlés, mais aucun contour n’est connu pour contrôler la pièce.",
      noOperation: "Aucun cycle de tournage n’a été exécuté : il n’y a rien à contrôler.",
      approachesClear: "L’approche et la sortie sont libres.",
      holderUnknown: (tools) =>
        `Le porte-outil n’a pas été contrôlé pour l’outil ${tools} : le tableau n’en décrit aucun.`,
      flanksUnknown: (tools) =>
        `Les flancs n’ont pas été contrôlés pour l’outil ${tools} : T-ANGLE ou P-ANGLE est vide.`,
      curvatureUnknown: (tools) => `Aucune plage de diamètres n’est indiquée pour la lame axiale de l’outil ${tools}.`,
    },
  },
  leaving: {
    title: "Ce programme a des défauts",
    lead: (n) =>
      n === 1
        ? "Il ne doit pas tourner ainsi sur une machine. Un défaut a été trouvé :"
        : `Il ne doit pas tourner ainsi sur une machine. ${n} défauts ont été trouvés :`,
    unchecked: "Ce programme n’est pas encore contrôlé",
    uncheckedLead: "Le calcul n’est pas terminé. Personne ne sait s’il contient des défauts.",
    go: {
      copy: "Copier quand même",
      save: "Enregistrer quand même",
      download: "Télécharger quand même",
      share: "Partager quand même",
    },
    look: "Montrer les constats",
    cancel: "Annuler",
    withFaults: (n) => (n === 1 ? "Il a 1 défaut." : `Il a ${n} défauts.`),
  },
  done: {
    contour: "Le contour manque encore",
    toContour: "Saisir le contour",
    faults: (n) =>
      n === 1
        ? "Toutes les réponses y sont, mais 1 défaut a été trouvé"
        : `Toutes les réponses y sont, mais ${n} défauts ont été trouvés`,
  },
} satisfies FindingsTexts;

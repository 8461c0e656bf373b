import type { PageTexts } from "../../en/first/page.ts";

export const page = {
  product: "Turnwise",
  home: "Turnwise, page d’accueil",
  promise: "Programmer des cycles de tournage HEIDENHAIN : voir chaque passe, contrôler, exporter le programme.",
  skipToPrompts: "Aller au dialogue",
  header: "Programme et réglages",
  keys: "Raccourcis clavier",
  commands: "Commandes",
  undo: "Annuler",
  redo: "Rétablir",
  newProgram: "Nouveau programme",
  settings: "Réglages",
  close: "Fermer",
  screenLanguage: "Langue de l’écran",
  control: "Commande (APPR et DEP avec Z)",
  controls: { "TNC 640": "TNC 640 : d’abord dans le plan, puis en Z", TNC7: "TNC7 : tous les axes à la fois" },
  theme: "Apparence",
  themes: { system: "Système", light: "Clair", dark: "Sombre" },
  motion: "Animation",
  size: "Taille du texte",
  sizes: { usual: "Standard", presentation: "Présentation" },
  motions: { system: "Système", reduced: "Aucune" },
  gallery: "Galerie des cycles",
  disclaimer:
    "D’après les manuels imprimés des cycles ; ce n’est pas un produit HEIDENHAIN. Vérifier chaque programme sur la commande avant d’usiner.",

  sections: "Parties du programme",
  prompts: "Dialogue",
  setup: "Préparation",
  contour: "Contour",
  program: "Programme",
  lathe: "Tour",
  timeline: "Chronologie",

  columns: {
    left: "Largeur de la colonne de gauche",
    right: "Largeur du texte du programme",
    hint: "Glisser, ou touches fléchées. Double-clic ou Entrée : largeur par défaut",
  },

  start: {
    which: "Trouver un cycle",
    title: "Programmer les cycles de tournage HEIDENHAIN pour TNC 640 et TNC7 et voir chaque passe",
    choose: "Choisir un cycle",
    chooseLead: "Choisir un cycle pour commencer avec ses valeurs d’exemple, ou « Sans valeurs ».",
    search: "Chercher dans les cycles, les exemples et vos programmes",
    found: (n) => (n === 1 ? "1 trouvé." : `${n} trouvés.`),
    foundWork: (name) => `Programme enregistré : ${name}`,
    foundExample: (title) => `Exemple : ${title}`,
    withExample: "Commencer avec les valeurs d’exemple",
    empty: "Commencer sans valeurs",
    cycle: (number, name) => `Cycle ${number}, ${name}`,
    kept: "Enregistrés sur cet appareil",
    allWorks: (n) => `Tous les programmes (${n})`,
    isElsewhere: "ouvert dans un autre onglet",
    task: "Exercice",
    program: "Programme CN",
    exercises: (count) => `Exercices (${count})`,
    continueWork: (name) => `Continuer ${name}`,
    forget: (name) => `Retirer ${name} de la liste`,
    removed: (name) => `${name} a été retiré.`,
    changed: (when) => `modifié ${when}`,
  },

  programs: {
    title: "Programmes CN",
    openFile: "Ouvrir un programme",
    openFolder: "Ouvrir un dossier",
    paste: "Coller un programme",
    create: "Nouveau programme",
    drop: "ou déposer des fichiers, coller un texte ici",
    dropHere: "Déposer ici le programme, avec les fichiers qu’il appelle",
    examples: "Exemples",
    example: (title) => `Ouvrir l’exemple ${title}`,
    fromJob: "Convertir en programme CN",
    fromJobLong: "Convertir en programme CN ; le cycle et ses valeurs restent un programme à part",
    pasteTitle: "Coller un programme",
    pasteLabel: "Texte du programme",
    pasteOpen: "Ouvrir",
    cancel: "Annuler",
    unreadable: "Ce fichier n’a pas pu être lu.",
    tooLarge: "Plus de 20 Mo.",
  },
  examples: {
    flange: "Bride : six outils, huit cycles",
    shaft: "Arbre : dix opérations, dix outils ; cône, dégagement, gorges, filetages extérieur et intérieur",
    shoulder: "Exemple du manuel 812 (français)",
    contour: "Exemple du manuel 820 (français)",
    contourEnglish: "Exemple du manuel 820 (anglais)",
    groove: "Exemple du manuel 852 (français)",
    plate: "Plaque fraisée : approche et sortie",
  },
  loading: "Chargement de l’éditeur …",
  readingDevice: "Lecture des programmes de cet appareil …",
  tools: {
    title: "Tableau d’outils",
    open: "Outils",
    openLong: "Ouvrir le tableau d’outils",
  },
  own: { title: "Cycles personnalisés" },
  works: { title: "Tous les programmes" },

  effect: {
    title: "Effet de ces valeurs",
    passes: "Passes",
    infeed: "Prise de passe",
    infeedUnit: "mm par passe",
    time: "Temps",
    chip: "Section copeau",
    residual: "Matière résiduelle",
    none: "aucune",
    unknown: "–",
    waiting: "Pas de trajectoire avec ces valeurs ; la dernière simulation valide est affichée.",
    duration: (minutes, seconds) =>
      minutes < 60
        ? minutes > 0
          ? `${minutes} min ${seconds} s`
          : `${seconds} s`
        : `${Math.floor(minutes / 60)} h ${minutes % 60} min`,
    faults: "Violations de contour et collisions",
    pin: {
      make: "Garder comme référence",
      title: "Référence gardée",
      pinned: "Référence",
      now: "Maintenant",
      back: "Restaurer",
      letGo: "Retirer",
      fold: "Masquer la comparaison",
      unfold: "Afficher la comparaison",
    },
  },

  text: {
    title: "Texte du programme",
    name: "Nom du programme",
    layout: "Présentation",
    layouts: { tnc640: "TNC 640", tnc7: "TNC7", iso: "DIN/ISO", manual: "Comme au manuel" },
    files: { tnc640: "Fichier Klartext pour TNC 640", tnc7: "Fichier Klartext pour TNC7", iso: "Fichier DIN/ISO" },
    manualView:
      "Affiché comme imprimé dans le manuel, sans ~. Une commande ne charge pas cette forme ; Copier et Télécharger donnent le fichier.",
    showFile: "Afficher le fichier",
    untied: "Listes de cycle sans ~ : une commande ne charge pas ce programme.",
    tie: "Ajouter ~",
    isoKept: (blocks) => `Sans équivalent DIN/ISO, reste en Klartext : ${blocks}.`,
    isoUnverified: "L’ordre des mots d’une séquence n’est pas vérifié ; à comparer sur la commande.",
    output: "Sortie CN",
    asIso: "Fichier DIN/ISO",
    language: "Textes",
    languageLong: "Langue du texte du programme",
    noChinese: "Aucun manuel connu n’imprime de textes chinois ; le manuel chinois de la TNC7 a les textes anglais.",
    copy: "Copier",
    copyLong: "Copier le programme",
    copied: "Copié",
    copiedLong: (blocks) => `Programme copié dans le presse-papiers : ${blocks} séquences.`,
    download: (file) => `Télécharger ${file}`,
    fold: "Masquer le programme",
    unfold: "Afficher le programme",
    exportMenu: "Exporter",
    setupSheet: "Fiche de réglage",
    clamping: "Matière, serrage",
    workshopDrawing: "Dessin d’atelier",
    handOn: "Partager",
    exportPart: "Exporter la pièce",
    turnRound: "Retourner la pièce",
    makeTask: "Créer un exercice",
    compare: "Comparer",
    blocks: "Séquences du programme",
    running: "en cours",
    refusedTitle: "Copier à la main",
    refused:
      "Le navigateur refuse l’accès au presse-papiers. Le texte ci-dessous est sélectionné : Ctrl+C, ou appui long puis Copier.",
    incomplete: "Programme incomplet",
  },

  notice: {
    dismiss: "Masquer",
    damaged: (n) =>
      n === 1
        ? "Un programme enregistré était illisible. Il a été mis de côté, rien n’a été effacé."
        : `${n} programmes enregistrés étaient illisibles. Ils ont été mis de côté, rien n’a été effacé.`,
    notKept:
      "Ce navigateur n’enregistre rien sur l’appareil. Copier ou télécharger le programme avant de fermer la page.",
    storageFull:
      "La mémoire de l’appareil est pleine : les dernières modifications ne sont pas enregistrées. Télécharger le programme, ou retirer des programmes sur la page d’accueil.",
    storageSilent:
      "La mémoire du navigateur ne répond pas. Vous pouvez continuer, mais les modifications n’existent que dans cette page jusqu’à sa réponse : téléchargez le programme avant de fermer la page.",
    newerData:
      "Certaines données de cet appareil ont été enregistrées par une version plus récente de cette page. Elles restent telles quelles, et leurs modifications ne sont pas enregistrées. Rechargez la page pour obtenir cette version.",
    rowsAside:
      "Certaines entrées de vos tableaux étaient illisibles. Elles ont été mises de côté : voir la page de tous les programmes. Rien n’a été effacé.",
    rowUnreadable: (name) => `${name} ne peut pas être affiché.`,
    newerWorks:
      "Certains programmes enregistrés viennent d’une version plus récente de cette page. Ils figurent sous la liste de tous les programmes ; rien n’a été effacé.",
    downloadUnkept: "Télécharger le programme",
    archiveUnkept: "Sauvegarder dans un fichier",
    copyOfOtherTab:
      "Ce programme est ouvert dans un autre onglet. Ici, on modifie une copie ; les deux sont conservés.",
    workNotHere: "Le programme de cette adresse n’est pas sur cet appareil : autre navigateur, ou retiré de la liste.",
    linkDamaged: "Le lien ne contient aucune donnée lisible.",
    linkNewer: "Le lien vient d’une version plus récente de cette page. Recharger la page et rouvrir le lien.",
    linkTooLarge: "Le programme du lien dépasse 20 Mo et n’a pas été ouvert. Votre programme est inchangé.",
    fileTooLarge: "Le fichier dépasse 20 Mo et n’a pas été ouvert. Votre programme est inchangé.",
    fileUnreadable: "Le fichier n’a pas pu être lu et n’a pas été ouvert. Votre programme est inchangé.",
    engineFailed: "Le calcul s’est interrompu. Les valeurs sont conservées ; le calcul peut être relancé.",
    toolsDamaged:
      "Le tableau d’outils enregistré est illisible. Il a été mis de côté ; les outils standard sont utilisés.",
    filesLeftOut:
      "Tous les fichiers du dossier n’ont pas été ouverts : ceux sans texte de programme ou au-delà de la limite ont été ignorés.",
    isoRead: "Le programme DIN/ISO a été converti en Klartext pour l’édition. « Fichier DIN/ISO » le reconvertit.",
    mainUnsure:
      "Aucun programme ici n’appelle tous les autres. Pour en exécuter un autre, le choisir dans la liste des fichiers au-dessus du texte.",
    toolsNotKept:
      "Ce navigateur n’enregistre pas le tableau d’outils sur l’appareil. L’exporter avant de fermer la page.",
    ownDamaged:
      "Les cycles personnalisés enregistrés étaient illisibles. Ils ont été mis de côté, rien n’a été effacé.",
    ownNotKept:
      "Ce navigateur n’enregistre pas les cycles personnalisés sur l’appareil. Les exporter avant de fermer la page.",
    crashTitle: "Une erreur est survenue sur cette page",
    crash: "Le programme est enregistré sur cet appareil.",
    missing: {
      offline:
        "Cette partie de la page n’a pas pu être chargée : pas de réseau. Les programmes ouverts sont conservés ; la partie se charge dès que le réseau revient.",
      gone: "Cette partie de la page n’a pas pu être chargée depuis le serveur. Les programmes ouverts sont conservés, même si la page est rechargée.",
    },
    tryAgain: "Réessayer",
    reload: "Recharger la page",
    startOver: "Aller à la page d’accueil",
  },
} satisfies PageTexts;

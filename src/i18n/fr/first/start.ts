import type { StartTexts } from "../../en/first/start.ts";

export const start = {
  hint: "Taper n’importe où sur cette page lance la recherche, p. ex. 812. Dans les quatre langues.",
  doors: {
    title: "Par où commencer",
    guide: "Aide",
    glossary: "Glossaire",
    program: "Programmer un cycle",
    programHow: "Répondre comme sur la commande ; le tour montre chaque valeur",
    openHow: "Klartext ou DIN/ISO : vérifier, modifier par dialogue, exporter",
    plan: "Gamme d’usinage de la pièce",
  },
  hero: {
    name: (n) => `Un arbre est usiné en ${n} opérations : l’outil se déplace et enlève la matière`,
    play: "Lecture",
    pause: "Pause",
    finish: "finition",
    position: "positionnement",
    proved: "vérifié",
    open: "Ouvrir ce programme",
    pass: (n, of) => `passe ${n} sur ${of}`,
    facts: (operations, tools) => `${operations} opérations · ${tools} outils`,
  },
  beyond: "Au-delà de la commande",
  beyondAll: {
    values: {
      what: "Trois valeurs côte à côte",
      how: "un paramètre avec une petite valeur, une courante et une grande, toutes simulées",
    },
    steps: { what: "Pas à pas", how: "chaque étape d’un cycle, jouée seule" },
    advice: { what: "Conditions de coupe et conseils", how: "valeurs de départ selon matière, outil et plaquette" },
    which: { what: "Trouver un cycle", how: "indiquer la forme : chaque solution est simulée et comparée" },
    code: { what: "Outils d’après les codes ISO", how: "une ligne comme CNMG 120408 remplit l’outil" },
    contour: { what: "Contours à inconnues", how: "les cotes manquantes sont calculées à partir des autres" },
    approach: { what: "APPR et DEP", how: "les huit fonctions, sur votre contour" },
    compare: { what: "Comparer des programmes", how: "selon leur effet, avec le temps que coûte une modification" },
    drawing: { what: "Plan d’atelier", how: "de tout programme, avec cotes, à imprimer" },
    share: { what: "Partager par code QR", how: "programme, outils et résultat du contrôle dans un lien" },
    verify: { what: "Vérifier en ligne de commande", how: "node verify.mjs PROGRAMME.H, sans navigateur" },
  },
} satisfies StartTexts;

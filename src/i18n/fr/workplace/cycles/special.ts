import type { CycleTexts } from "../../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "Adapter le système de coordonnées",
    summary: "Adapte le système de coordonnées du tournage à un outil incliné ou tourné.",
    description: [
      "Dit comment l’outil se tient par rapport à la pièce : tourné autour de son axe, retourné, incliné. Il agit là où il " +
        "se trouve dans le programme et n’a pas besoin d’appel.",
      "À placer avant le tournage et après chaque changement d’outil.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Avec tous les angles à 0, sans outil retourné et avec Q535 = 0 ou 3, il ne change rien et le programme continue. Avec " +
        "toute autre valeur, la séquence est conservée et rien n’est contrôlé après elle.",
      "Un logiciel plus récent ajoute un paramètre de retrait Q599 ; il est conservé.",
    ],
  },
  801: {
    name: "Réinitialiser le système de coordonnées",
    summary: "Annule ce que le cycle 800 a adapté.",
    description: [
      "Rétablit le système de coordonnées du tournage. Il n’a pas de paramètres, agit là où il se trouve dans le programme " +
        "et n’a pas besoin d’appel.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Ce que le cycle 800 a laissé sans contrôle le reste : où se trouve alors la machine, personne ici ne le sait.",
    ],
  },
} satisfies CycleTexts;

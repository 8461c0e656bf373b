import type { CycleTexts } from "../../../cycle-text.ts";
import { turnMode } from "./notes.ts";

export const special = {
  800: {
    name: "Adapter le système de coordonnées",
    summary: "Adapte le système de coordonnées du tournage à un outil incliné ou tourné.",
    description: [
      "Décrit la position de l’outil par rapport à la pièce : tourné autour de son axe, inversé, incliné. Le " +
        "cycle est actif dès sa définition, sans appel.",
      "À programmer avant le tournage et après chaque changement d’outil.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Avec tous les angles à 0, sans outil inversé et avec Q535 = 0 ou 3, le cycle ne change rien. Avec " +
        "d’autres valeurs, la séquence est conservée sans être simulée et le programme est non vérifié à partir " +
        "d’ici.",
      "Un logiciel plus récent ajoute le paramètre de retrait Q599 ; ce paramètre est conservé.",
    ],
  },
  801: {
    name: "Réinitialiser le système de coordonnées",
    summary: "Annule l’adaptation faite par le cycle 800.",
    description: [
      "Réinitialise le système de coordonnées du tournage. Le cycle n’a pas de paramètres et est actif dès sa " +
        "définition, sans appel.",
    ],
    rough: [],
    finish: [],
    notes: [
      turnMode,
      "Un programme non vérifié après le cycle 800 le reste : la position de la machine n’est pas connue ici.",
    ],
  },
} satisfies CycleTexts;

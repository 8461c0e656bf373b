import type { OutputTexts } from "../en/output.ts";
import { typeset } from "./typography/typeset.ts";

export const output = typeset<OutputTexts>({
  title: "Sortie CN",
  lead: "Écriture du programme pour votre machine. Les réglages sont enregistrés et partagés avec le programme.",
  leadProgram: "S’applique aux opérations insérées. Le texte existant reste inchangé.",
  preset: "Modèle",
  presets: {
    manual: "Comme dans les exemples du manuel : M303, M305",
    mainSpindle: "La broche principale entraîne la pièce : M3, M5",
    transfer: "Transfert plus ancien : M3, M5, CR LF, sans numéros de séquence, majuscules",
    own: "Propre à la machine",
  },
  spindleOn: "Marche broche",
  spindleOff: "Arrêt broche à la fin",
  spindleOffHint: "Vide : M30 ou M2 arrête la broche.",
  functionWrong: "Un nombre de 0 à 999",
  retract: "Dégagement à la fin",
  retracts: {
    position: "Position de sécurité au-dessus de la pièce brute",
    limit: "Fin de course dans l’axe d’outil (M140 MB MAX)",
  },
  end: "Fin du programme",
  ends: { 30: "M30", 2: "M2" },
  numbered: "Numéros de séquence",
  newLine: "Fin de ligne",
  newLines: { "\n": "LF", "\r\n": "CR LF" },
  name: "Nom du programme",
  names: { typed: "Tel que saisi", capitals: "Majuscules" },
  makeDefault: "Utiliser pour les nouveaux programmes",
  isDefault: "Utilisé pour les nouveaux programmes.",
  unverified: "Les fonctions M qui entraînent la broche dépendent de la machine : voir le manuel de la machine.",
});

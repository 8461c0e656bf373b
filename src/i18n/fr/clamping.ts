import type { ClampingTexts } from "../en/clamping.ts";
import { typeset } from "./typography/typeset.ts";

export const clamping = typeset<ClampingTexts>({
  title: "Serrage",
  unstated:
    "Non indiqué : le brut est supposé serré à son extrémité arrière. Le contact avec mors, mandrin ou contre-poupée n’est pas contrôlé.",
  state: "Indiquer un serrage",
  remove: "Retirer le serrage",
  kind: "Tenue par",
  kinds: {
    chuckOutside: "Mandrin, extérieur",
    chuckInside: "Mandrin, intérieur",
    softJaws: "Mors doux",
    collet: "Pince",
    centres: "Entre pointes",
  },
  grips: {
    chuckOutside: "⌀ serré, extérieur",
    chuckInside: "⌀ serré, intérieur",
    softJaws: "⌀ serré, extérieur",
    collet: "⌀ serré",
    centres: "⌀ de l’entraîneur",
  },
  nose: "⌀ du nez",
  words: {
    D: "⌀ serré",
    LENGTH: "Longueur serrée",
    FACE: "Z de la face avant",
    SIZE: "⌀ du mandrin",
    QUILL: "⌀ du fourreau",
    TIP: "Z de la pointe",
    ANGLE: "Angle de la pointe",
    LIMITZ: "Limite : rien à gauche de Z",
    LIMITX: "Limite : rien en dessous de ⌀",
  },
  tailstock: "Avec contre-poupée",
  known:
    "Dessiné à l’échelle ; le contact de l’outil ou du porte-outil est une erreur. Mors de mandrins usuels : mesurer les vôtres.",
  inProgram: "Enregistré dans le programme en commentaire, ;\u00A0CLAMPING …, que la commande ignore.",
  units: { mm: { diameter: "mm ⌀", length: "mm" }, inch: { diameter: "pouce ⌀", length: "pouce" } },
});

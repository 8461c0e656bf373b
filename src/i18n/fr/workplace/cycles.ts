import type { CyclesTexts } from "../../cycle-text.ts";
import { longitudinal } from "./cycles/longitudinal.ts";
import { transverse } from "./cycles/transverse.ts";
import { recessTurning } from "./cycles/recess-turning.ts";
import { recessing } from "./cycles/recessing.ts";
import { threads } from "./cycles/threads.ts";
import { special } from "./cycles/special.ts";

export const cycles = {
  groups: {
    special: "Cycles spéciaux",
    longitudinal: "Tournage longitudinal",
    transverse: "Tournage transversal",
    recessTurning: "Tournage de gorge",
    recessing: "Usinage de gorge",
    thread: "Filetage",
  },
  evidence: {
    A: "imprimé dans un manuel de cette commande",
    B: "imprimé pour une commande apparentée",
    L: "repris des commandes de tour dont ces cycles sont issus",
    I: "déduit de faits imprimés",
    K1: "non vérifié dans un manuel, plutôt sûr",
    K2: "non vérifié dans un manuel",
    K3: "non vérifié dans un manuel, incertain",
  },
  kinds: {
    choice: "choix",
    diameter: "diamètre",
    oversizeDiameter: "surépaisseur au diamètre",
    radial: "au rayon",
    axial: "en Z",
    axialDepth: "profondeur en Z",
    length: "longueur",
    angle: "angle",
    feed: "avance",
    count: "nombre",
    factor: "facteur",
    percent: "pour cent",
    revolutions: "tours",
  },
  roughStep: (step, of, text) => `Étape ${step}/${of} : ${text}`,
  finishStep: (step, of, text) => `Finition, étape ${step}/${of} : ${text}`,
  positioning: "Positionnement avant l’étape 1",
  kept: {
    880: "Taillage d’engrenage à la fraise-mère",
    882: "Ébauche simultanée",
    883: "Finition simultanée",
    892: "Contrôler le balourd",
  },
  of: { ...special, ...longitudinal, ...transverse, ...recessTurning, ...recessing, ...threads },
} satisfies CyclesTexts;

import type { CyclesTexts } from "../../cycle-text.ts";
import { longitudinal } from "./cycles/longitudinal.ts";
import { transverse } from "./cycles/transverse.ts";
import { recessTurning } from "./cycles/recess-turning.ts";
import { recessing } from "./cycles/recessing.ts";
import { threads } from "./cycles/threads.ts";
import { special } from "./cycles/special.ts";

export const cycles = {
  groups: {
    special: "Sonderzyklen",
    longitudinal: "Längsdrehen",
    transverse: "Plandrehen",
    recessTurning: "Stechdrehen",
    recessing: "Stechen",
    thread: "Gewinde",
  },
  evidence: {
    A: "gedruckt in einem Handbuch dieser Steuerung",
    B: "gedruckt für eine verwandte Steuerung",
    L: "von den Drehmaschinensteuerungen, aus denen diese Zyklen stammen",
    I: "aus gedruckten Angaben abgeleitet",
    K1: "nicht am Handbuch geprüft, recht sicher",
    K2: "nicht am Handbuch geprüft",
    K3: "nicht am Handbuch geprüft, unsicher",
  },
  kinds: {
    choice: "Auswahl",
    diameter: "Durchmesser",
    oversizeDiameter: "Aufmaß auf den Durchmesser",
    radial: "auf den Radius",
    axial: "in Z",
    axialDepth: "Tiefe in Z",
    length: "Länge",
    angle: "Winkel",
    feed: "Vorschub",
    count: "Anzahl",
    factor: "Faktor",
    percent: "Prozent",
    revolutions: "Umdrehungen",
  },
  roughStep: (step, of, text) => `Schritt ${step} von ${of}: ${text}`,
  finishStep: (step, of, text) => `Schlichten, Schritt ${step} von ${of}: ${text}`,
  positioning: "Positionieren vor Schritt 1",
  kept: { 880: "Abwälzfräsen", 882: "Simultanschruppen", 883: "Simultanschlichten", 892: "Unwucht prüfen" },
  of: { ...special, ...longitudinal, ...transverse, ...recessTurning, ...recessing, ...threads },
} satisfies CyclesTexts;

/** The words that the glossary explains, by a key that is part of their address. */
export const TERMS = [
  "blank",
  "stock",
  "finishedPart",
  "residue",
  "contour",
  "cornerElement",
  "shoulder",
  "face",
  "recess",
  "undercut",
  "thread",
  "pitch",
  "runIn",
  "oversize",
  "workpieceZero",
  "diameter",
  "radius",
  "theoreticalTip",
  "cuttingPoint",
  "tipOrientation",
  "noseRadius",
  "compensation",
  "insert",
  "mainEdge",
  "secondaryEdge",
  "edgeLength",
  "holder",
  "pass",
  "infeed",
  "roughing",
  "finishing",
  "setupClearance",
  "startPoint",
  "rapid",
  "feedPerTurn",
  "cuttingSpeed",
  "speedLimit",
  "chip",
  "cuttingForce",
  "roughness",
  "gouge",
  "airPass",
  "plunging",
  "limit",
  "program",
  "block",
  "cycle",
  "call",
  "verdict",
] as const;

export type TermId = (typeof TERMS)[number];

/** A word and what it means, in one to three sentences. */
export interface Term {
  readonly name: string;
  readonly text: string;
  /** Another word that means it as well: what is said in the shop. */
  readonly also?: string;
  /** A pattern of what stands before the name where it is this term, for a name that mostly means something else. */
  readonly where?: string;
}

/** How names of the glossary stand in sentences of a language. */
export interface WordForms {
  /** A pattern of a name and of what becomes of it in a sentence. */
  readonly formsOf: (name: string) => string;
  /** Names have capitals, and a word that is spelled alike without one is another. */
  readonly capitals: boolean;
  /** Words stand apart from each other. */
  readonly apart: boolean;
}

export interface GlossaryTexts extends Readonly<Record<TermId, Term>> {
  readonly words: WordForms;
}

/** The terms of the glossary, by a key that is part of their address. */
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

/** A term and its meaning, in one to three sentences. */
export interface Term {
  readonly name: string;
  readonly text: string;
  /** A synonym: the shop word. */
  readonly also?: string;
  /** A pattern for the text before the name, for a name that usually has another meaning. */
  readonly where?: string;
}

/** How glossary names appear in sentences of a language. */
export interface WordForms {
  /** A pattern that matches a name and its inflected forms. */
  readonly formsOf: (name: string) => string;
  /** Names are capitalized, and a word without its capital is another word. */
  readonly capitals: boolean;
  /** Words are separated by spaces. */
  readonly apart: boolean;
}

export interface GlossaryTexts extends Readonly<Record<TermId, Term>> {
  readonly words: WordForms;
}

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
}

export type GlossaryTexts = Readonly<Record<TermId, Term>>;

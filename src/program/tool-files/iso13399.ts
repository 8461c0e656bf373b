import { INSERT_SHAPES } from "../iso-codes/insert-facts.ts";
import type { Hand } from "../iso-codes/code-part.ts";
import type { LengthUnit } from "../../kernel/units.ts";
import { PropertyReader, type Fact, type Facts, type FileProperties, type FileTool, type Vocabulary } from "./facts.ts";

/*
 * Properties of ISO 13399 by their symbols. Meanings: lists of the makers; sources in docs/decisions, tool files of
 * other systems. A symbol that is not here is named and not guessed.
 */

const VOCABULARY: Vocabulary = {
  nose: ["RE", "REL", "RER"],
  circle: ["IC"],
  edge: ["L"],
  point: ["EPSR"],
  setting: ["KAPR"],
  width: ["CW"],
  depth: ["CDX"],
  profile: ["PNA"],
  pitch: ["TP"],
  cutter: ["DC", "TD"],
  drillPoint: ["SIG"],
  flute: ["LCF", "LU"],
  shank: ["B"],
  reach: ["WF"],
  head: ["LH"],
  overall: ["LF"],
  axialFrom: ["DAXN"],
  axialTo: ["DAXX"],
  partOff: ["CUTDIA"],
  bore: ["DMIN", "DMIN1"],
  pointLength: ["PL"],
};
/** A bar has a diameter in place of a width. */
const BAR = ["DMM", "DCONMS", "DCON"];

/** Symbols by which a list of properties is recognised. */
export const ISO13399_SYMBOLS: ReadonlySet<string> = new Set([
  ...Object.values(VOCABULARY).flat(),
  ...BAR,
  ...["PSIR", "HAND", "SC", "S", "INSL", "APMX", "LE", "H", "HF", "LPR", "OAL", "CWX", "CWN", "TPN", "TPX", "NOF"],
]);

const oneOf = <T extends string>(fact: Fact<string> | undefined, form: RegExp): Fact<T> | undefined => {
  const found = form.exec(fact?.value ?? "")?.[1]?.toUpperCase();
  return fact && found !== undefined ? { value: found as T, from: fact.from } : undefined;
};

/** A tool from its properties. `unitAsked`: whether one of its lengths has no unit. */
export function isoTool(
  properties: FileProperties,
  unit: LengthUnit,
  about: { readonly label: string; readonly texts: readonly string[] },
): { readonly tool: FileTool; readonly unitAsked: boolean } {
  const reader = new PropertyReader(properties, unit);
  const read = reader.sizes(VOCABULARY);
  const lead = read.setting ? undefined : reader.number("PSIR");
  const hand = oneOf<Hand>(reader.text("HAND"), /^\s*([RLN])(?:ight|eft|eutral)?\s*$/i);
  const shape = oneOf<string>(reader.text("SC"), /^\s*([A-Z])\s*$/i);
  const face = read.axialFrom ?? read.axialTo;
  const bar = read.shank ? undefined : reader.length(BAR);
  const side = face ?? read.bore;
  const facts: Facts = {
    name: { value: about.label, from: about.label },
    ...read,
    ...(lead && { setting: { value: 90 - lead.value, from: lead.from } }),
    ...(hand && { hand }),
    ...(shape && INSERT_SHAPES[shape.value] && { shape }),
    ...(bar && !read.cutter && { shank: bar }),
    ...(side && { side: { value: face ? "face" : "inside", from: side.from } }),
  };
  return {
    tool: { label: about.label, facts, texts: about.texts, unused: reader.unused },
    unitAsked: reader.unitAsked,
  };
}

/** Whether the facts of a tool are those of an insert alone, or of its holder alone. */
export const partOf = ({ facts }: FileTool): "insert" | "holder" | null => {
  const insert = facts.nose ?? facts.circle ?? facts.edge;
  const holder = facts.setting ?? facts.reach ?? facts.overall;
  if (facts.cutter || Boolean(insert) === Boolean(holder)) return null;
  return insert ? "insert" : "holder";
};

/** An insert in its holder, when a set consists of exactly one of each. */
export function mounted(tools: readonly FileTool[]): readonly FileTool[] {
  const insert = tools.find((tool) => partOf(tool) === "insert");
  const holder = tools.find((tool) => partOf(tool) === "holder");
  if (tools.length !== 2 || !insert || !holder) return tools;
  return [
    {
      label: `${insert.label} + ${holder.label}`,
      facts: { ...holder.facts, ...insert.facts, ...(holder.facts.hand && { hand: holder.facts.hand }) },
      texts: [...insert.texts, ...holder.texts],
      unused: [...new Set([...insert.unused, ...holder.unused])],
    },
  ];
}

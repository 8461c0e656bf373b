import type { LengthUnit } from "../../kernel/units.ts";
import {
  PropertyReader,
  type FileProperties,
  type FileTool,
  type FileToolKind,
  type RefusedItem,
  type Vocabulary,
} from "./facts.ts";

/*
 * DIN 4000: each list of properties (NSM) has letters of its own, so a list that is not here is named and not guessed.
 * Only letters whose meaning real files and two published readings agree on; sources in docs/decisions, tool files of
 * other systems.
 */

interface List {
  readonly kinds: Readonly<Record<string, FileToolKind>>;
  readonly vocabulary: Vocabulary;
}

/** Lists by their part of DIN 4000; kinds by the figure (BLD), "" for all others. */
const LISTS: Readonly<Record<string, List>> = {
  "80": { kinds: { "": "tap" }, vocabulary: { cutter: ["A21", "A1"], pitch: ["A3"], flute: ["B1"] } },
  "81": {
    kinds: { "1": "drill", "6": "center", "7": "center" },
    vocabulary: { cutter: ["A11"], drillPoint: ["E1"], flute: ["B6"], pointLength: ["B7"] },
  },
  "82": { kinds: { "": "mill" }, vocabulary: { cutter: ["A1"] } },
};
/** Centre drills with a pilot: the body is what a centre drill of the table has. */
const PILOTED: Vocabulary = { cutter: ["A11_2"], drillPoint: ["E4_2"] };

const IDLE = ["NSM", "BLD", "J21", "J22", "J23", "J3", "J6", "J7", "J8", "F8", "HAS3D", "DIM"];

/** Whether properties are those of a list of DIN 4000. */
export const isDin4000 = (properties: FileProperties): boolean =>
  /^DIN\s?4000-/i.test(String(properties.get("NSM")?.value ?? ""));

/** A tool of a list of DIN 4000, or why it is none. The unit is millimetres (DIN 4000-100). */
export function dinTool(properties: FileProperties): FileTool | RefusedItem {
  const unit: LengthUnit = "mm";
  const reader = new PropertyReader(properties, unit);
  const [list, figure, product, name, order] = ["NSM", "BLD", "J22", "J23", "J21"].map(
    (letter) => reader.text(letter)?.value ?? "",
  );
  const label = [name, product, order].find((text) => text !== "") ?? list ?? "";
  const part = /^DIN\s?4000-(\d+)/i.exec(list ?? "")?.[1] ?? "";
  const found = LISTS[part];
  const kind = found?.kinds[figure ?? ""] ?? found?.kinds[""];
  if (!found || !kind) return { label, why: "unknownList", kind: `${list} ${figure}`.trim() };
  const piloted = part === "81" && properties.has("A11_2");
  const sizes = reader.sizes(piloted ? PILOTED : found.vocabulary);
  reader.pass(...IDLE);
  const cutter = piloted && sizes.cutter ? { cutter: { ...sizes.cutter, why: "bodyAsCentre" as const } } : {};
  return {
    label,
    facts: {
      name: { value: label, from: label },
      kind: { value: kind, from: `${list} ${figure}`.trim() },
      ...sizes,
      ...cutter,
    },
    texts: [],
    unused: reader.unused,
  };
}

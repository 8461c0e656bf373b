import type { BladeSupport, DrillType, ToolType } from "../../kernel/plan/tool.ts";
import { isMillType, isToolType, type MILL } from "../tools/tool-columns.ts";

/*
 * Words by which shops name the kind and the orientation of a tool, in six languages. They only give proposals; each word
 * can be assigned by hand.
 */

type AnyType = ToolType | DrillType | typeof MILL;

/** The first line that fits decides: a boring bar is no drill, a tap no thread insert. */
const TYPES: readonly (readonly [AnyType, RegExp])[] = [
  ["TAP", /\btap\b|gewindebohr|taraud|maschio|\bmacho\b|丝锥/i],
  ["REAM", /\bream|reibahle|al[ée]soir|alesatore|escariador|铰刀/i],
  ["ROUGH", /schrupp|rough|[ée]bauche|sgross|desbast|粗/i],
  ["FINISH", /schlicht|finish|finition|finitura|acabado|精/i],
  ["CENTER", /zentrier|anbohr|\bcent(?:er|re|rage)\b|spot|pointer|centrino|中心钻/i],
  ["ROUGH", /bohrstange|\bboring\b|ausdreh|innendreh|al[ée]sage|alesatura|mandrin|镗/i],
  ["DRILL", /bohr|drill|\bforet|per[cç]age|\bpunta\b|\bbroca\b|钻/i],
  ["MILL", /fr[äa]s|\b(?:end)?mill|frais|fresa|铣/i],
  ["RECTURN", /stechdreh|(?:groove|recess)[\s-]*turn|切槽车/i],
  [
    "RECESS",
    /stech|groov|recess|part(?:ing)?[\s-]*off|parting|cut[\s-]*off|gorge|tron[cç]on|scanal|troncatura|ranur|tronzad|切槽|切断/i,
  ],
  ["THREAD", /gewinde|thread|filet|rosca|螺纹/i],
  ["BUTTON", /pilz|button|round|rund|\brond|tond[oa]|redond|圆刀/i],
  ["ROUGH", /dreh|turn|chariot|tornit|tornead|车/i],
];

/** Proposed type of a word; null for none. */
export function typeOfWord(word: string): AnyType | null {
  const upper = word.trim().toUpperCase();
  if (isToolType(upper) || isMillType(upper)) return upper as AnyType;
  return TYPES.find(([, words]) => words.test(word.slice(0, 200)))?.[0] ?? null;
}

const SUPPORTS: readonly (readonly [BladeSupport, RegExp])[] = [
  ["NONE", /^(?:no|none|ohne|keine?|sans|aucun|senza|nessuno|sin|ninguno|无|-)$/i],
  ["CURVED", /curv|courb|gebogen|gekrümm|axial|弧|弯/i],
  ["STRAIGHT", /straight|gerade|droit|dritt|recto|radial|直/i],
];

/** Support of a blade in the words of a shop; any other text stays as it is, to be refused by the table. */
export const supportOfWord = (word: string): string =>
  SUPPORTS.find(([, words]) => words.test(word.trim().slice(0, 200)))?.[0] ?? word;

/** An arrow for each orientation, as it points on the lathe: Z to the right, X up. */
export const ARROWS = ["↙", "↓", "↘", "→", "↗", "↑", "↖", "←", "○"] as const;
const DIRECTIONS = ["-z-x", "-x", "+z-x", "+z", "+z+x", "+x", "-z+x", "-z"];
const SIDES: readonly (readonly [number, RegExp])[] = [
  [8, /axial|stirn|\bface|frontal|端面/i],
  [7, /innen|inside|internal|\bI\.?D\.?\b|int[ée]rieur|interno|interior|内/i],
  [3, /links|\bleft|gauche|sinistr|izquierd|左/i],
  [2, /neutral|radial|mitte|middle|neutre/i],
  [
    1,
    /au(?:ß|ss)en|rechts|outside|external|\bO\.?D\.?\b|\bright|droite|ext[ée]rieur|destr|esterno|derech|exterior|外|右/i,
  ],
];

/** Proposed orientation of a word, a sign or a number, 1 to 9; null for none. */
export function orientationOfWord(word: string): number | null {
  const text = word.trim();
  if (/^[1-9](?:[.,]0+)?$/.test(text)) return Number(text[0]);
  const arrow = ARROWS.findIndex((each) => text.includes(each));
  if (arrow >= 0) return arrow + 1;
  const signs = text
    .toLowerCase()
    .replaceAll("−", "-")
    .replaceAll(/[\s,;/]+/g, "");
  const at = DIRECTIONS.findIndex((each) => each === signs || each === `${signs.slice(2)}${signs.slice(0, 2)}`);
  if (at >= 0) return at + 1;
  return SIDES.find(([, words]) => words.test(text.slice(0, 200)))?.[0] ?? null;
}

import type { FileToolKind, WorkSide } from "./facts.ts";

/*
 * Words by which people name their tools, in the four languages of the page. They only ever give proposals.
 */

const KINDS: readonly (readonly [FileToolKind, RegExp])[] = [
  ["tap", /\btaps?\b|gewindebohr|taraud|丝锥/i],
  [
    "center",
    /\bcent(?:er|re)[\s-]?drill|\bspot(?:ting)?[\s-]?drill|zentrier|anbohr|foret (?:à|a) (?:centrer|pointer)|中心钻/i,
  ],
  ["reamer", /\breamer|reibahle|al[ée]soir|铰刀/i],
  ["drill", /drill|bohrer|\bforet\b|钻/i],
  ["parting", /\bpart(?:ing)?[\s-]?off|\bparting\b|\bcut[\s-]?off|abstech|tron[cç]on|切断/i],
  ["grooving", /groov|recess|einstech|stechdreh|\bstech|\bgorges?\b|切槽/i],
  ["threading", /thread|gewinde|filet|螺纹/i],
  ["mill", /\b(?:end)?mills?\b|fr[äa]s(?:er|e)|fraise|铣/i],
  [
    "turning",
    /turn|\bboring\b|rough|finish|\bfacing\b|dreh|schrupp|schlicht|chariot|[ée]bauche|finition|al[ée]sage|车|镗/i,
  ],
];
const SIDES: readonly (readonly [WorkSide, RegExp])[] = [
  ["face", /\b(?:face|axial)[\s-]*groov|axialstech|stirn(?:ein)?stech|gorge frontale|端面切槽/i],
  ["inside", /internal|inside|\bI\.?D\.?\b|\bboring\b|innen|ausdreh|int[ée]rieur|al[ée]sage|内|镗/i],
  ["outside", /external|outside|\bO\.?D\.?\b|au(?:ß|ss)en|ext[ée]rieur|外/i],
];
const FINISHING = /finish|schlicht|finition|精/i;

const named = <T>(list: readonly (readonly [T, RegExp])[], text: string): T | null =>
  list.find(([, words]) => words.test(text.slice(0, 200)))?.[0] ?? null;

export const kindOfWords = (text: string): FileToolKind | null => named(KINDS, text);
export const sideOfWords = (text: string): WorkSide | null => named(SIDES, text);
export const saysFinishing = (text: string): boolean => FINISHING.test(text.slice(0, 200));

const PLAIN: Readonly<Record<string, string>> = { Ä: "AE", Ö: "OE", Ü: "UE", ß: "SS", ä: "AE", ö: "OE", ü: "UE" };
const LONGEST_NAME = 32;

/** A text as a tool name of the control: capital letters, its characters only, at most 32. */
export const controlName = (text: string): string =>
  text
    .slice(0, 200)
    .replace(/[ÄÖÜßäöü]/g, (c) => PLAIN[c] ?? c)
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toUpperCase()
    .replace(/[^A-Z0-9#$%&,\-._]+/g, "-")
    .slice(0, LONGEST_NAME)
    .replace(/^-+|(?<!-)-+$/g, "");

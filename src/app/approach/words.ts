import type { Texts } from "../../i18n/index.ts";
import { formatSigned } from "../../i18n/number.ts";
import type { Language } from "../../i18n/languages.ts";
import type { ApproachStatement } from "../../program/approach-draft.ts";
import type { ApproachField, ApproachWord, WorkingPlane } from "../../program/approach-fields.ts";
import type { FieldReading } from "../../program/field.ts";

/** The block as its function is called: "APPR LT", "DEP PLCT". */
export const blockName = ({ departing, form }: Pick<ApproachStatement, "departing" | "form">): string => `${departing ? "DEP" : "APPR"} ${form}`;

/** How a word is written on the screen; the compensation has no letter of its own. */
export const wordName = (word: ApproachWord): string => (word === "SIDE" ? "RL/RR" : word);

/** Prompt, label and explanation of a word. */
export function wordTexts(t: Texts, word: ApproachWord, plane: WorkingPlane) {
  const { words } = t.approach;
  return plane === "ZX" && word === "Z" ? words.turningZ : words[word];
}

/** What a word is measured in. */
export function unitText(t: Texts, f: ApproachField, inch: boolean): string {
  const long = inch ? "inch" : "mm";
  switch (f.kind) {
    case "length": return long;
    case "diameter": return inch ? `${long} ⌀` : t.dialog.units.diameter;
    case "angle": return "°";
    case "feed": return `${long}/min`;
    case "side": case "functions": return "";
  }
}

/** What was typed, as the list of prompts shows it. */
export function shownWord(t: Texts, language: Language, f: ApproachField, typed: string, reading: FieldReading | undefined): string {
  const text = typed.trim();
  if (text === "") return f.optional ? t.approach.left : t.approach.empty;
  if (f.kind === "side" || f.kind === "functions" || !reading || reading.value === null || typeof reading.written !== "number") return text;
  return (reading.incremental ? "I" : "") + (f.range[0] < 0 ? formatSigned(language, reading.value) : text);
}

import type { FieldFacts, Spread } from "../../../nc/blocks/define.ts";

/** The word of a field id: `word DZL` gives DZL. */
export const wordOfField = ({ id }: Pick<FieldFacts, "id">): string => id.replace(/^word /, "");

/** Sample values for the guide's pictures of a word; null if it changes neither path nor part. */
export function spreadOf({ spread, noPicture, choices }: FieldFacts): Spread | null {
  if (spread) return spread;
  const shown = noPicture ? [] : (choices ?? []).filter((choice) => choice !== "");
  return shown.length === 0 ? null : { choices: shown };
}

/** The letters before a value; empty if the block implies them. */
export const letterOf = (field: Pick<FieldFacts, "id" | "letter">): string => {
  const word = wordOfField(field);
  return field.letter ?? (/^[A-Z_]+\d*$/.test(word) ? word : "");
};

const PLACES = 3;
const rounded = (n: number): string => String(Number(n.toFixed(PLACES)));

/** Sample texts of a word in ascending order, including the usual one; only that one if it is no plain number. */
export function textsBeside(spread: Spread, usual: string): readonly string[] {
  if ("choices" in spread) return spread.choices.includes(usual) ? spread.choices : [usual, ...spread.choices];
  if ("tools" in spread) return [usual];
  if ("swap" in spread) {
    const [a, b] = spread.swap,
      other = usual.includes(a) ? usual.replace(a, b) : usual.replace(b, a);
    return [...new Set([usual, other])];
  }
  const value = usual.trim() === "" ? NaN : Number(usual);
  if (!Number.isFinite(value)) return [usual];
  const others = "times" in spread ? spread.times.map((by) => value * by) : spread.plus.map((by) => value + by);
  const all = [...new Set([usual, ...others.map(rounded)])];
  return all.toSorted((a, b) => Number(a) - Number(b));
}

import type { FieldFacts, Spread } from "../../../nc/blocks/define.ts";

/** A word of a block without what stands in front of it in its id: `word DZL` is DZL. */
export const wordOfField = ({ id }: Pick<FieldFacts, "id">): string => id.replace(/^word /, "");

/** How the values lie that a word is shown with; null where it makes no other path and no other part. */
export function spreadOf({ spread, unseen, choices }: FieldFacts): Spread | null {
  if (spread) return spread;
  const shown = unseen ? [] : (choices ?? []).filter((choice) => choice !== "");
  return shown.length === 0 ? null : { choices: shown };
}

/** How a word of a block is written in front of its value; empty where only the block says it. */
export const letterOf = (field: Pick<FieldFacts, "id" | "letter">): string => {
  const word = wordOfField(field);
  return field.letter ?? (/^[A-Z_]+\d*$/.test(word) ? word : "");
};

const PLACES = 3;
const rounded = (n: number): string => String(Number(n.toFixed(PLACES)));

/**
 * The texts that a word is shown with, the usual one among them, in their order; only that one where it is no plain
 * number.
 */
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

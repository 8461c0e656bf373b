import type { Block, Program } from "./program.ts";
import { LAYOUTS, type Style } from "./style.ts";
import { NUMBER_PARAMETER } from "./value.ts";

/** How many blocks around a block may define its style. */
const NEIGHBOURS = 40;

/** A style choice from the texts of blocks, nearest first; the first that shows it decides. */
function seen<T>(texts: readonly string[], show: (raw: string) => T | null, otherwise: T): T {
  for (const raw of texts) {
    const found = show(raw);
    if (found !== null) return found;
  }
  return otherwise;
}

const INDENTED = new RegExp(String.raw`[\r\n]([ \t]*)${NUMBER_PARAMETER}[ \t]*=`, "i");
/** The text without comments and names, which show no style: M48X2 is no X. */
const code = (raw: string) => raw.replace(/;[^\r\n]*/g, "").replace(/(?:\b(?:BEGIN|END) PGM |\* - )[^\r\n]*/gi, "");
const newLine = (raw: string) => (/\r\n|\n|\r/.exec(raw)?.[0] as Style["newLine"] | undefined) ?? null;
const wide = (raw: string) =>
  /^\/?\d+ +(?:CYCL DEF \d+(?:\.\d+)?|L|LBL|RND|CHF) {2}/m.test(code(raw))
    ? true
    : /^\/?\d+ (?:CYCL DEF \d+|L|RND|CHF) \S/m.test(code(raw))
      ? false
      : null;
/** An axis or a value of a cycle; the X of SMAX2500 is neither. */
const plus = (raw: string) =>
  /(?:(?<![A-Z])I?[XYZ]|=)\+[\d.,]/.test(code(raw)) ? true : /(?:(?<![A-Z])I?[XYZ]|=)\d/.test(code(raw)) ? false : null;
const decimal = (raw: string): "," | "." | null =>
  /\d,\d/.test(code(raw))
    ? ","
    : /[A-Z=+-]\d*\.\d/.test(code(raw).replace(/CYCL DEF \d+\.\d+[^\r\n]*|BLK FORM 0\.[12]/g, ""))
      ? "."
      : null;
const indent = (raw: string) => INDENTED.exec(raw)?.[1] ?? null;
const rapid = (raw: string) => (/F MAX/.test(raw) ? ("F MAX" as const) : /FMAX/.test(raw) ? ("FMAX" as const) : null);
const spacedWords = (raw: string) =>
  /(?:LEN|CCA) [\d+]/.test(raw) ? true : /(?:LEN|CCA)[\d+]/.test(raw) ? false : null;

/**
 * The style a block is written in: its own where it shows, else that of its surroundings, else the control's newest.
 */
export function styleAt(program: Program, index: number): Style {
  const { blocks } = program;
  const near: Block[] = [];
  for (let d = 0; d <= NEIGHBOURS; d += 1)
    for (const i of d === 0 ? [index] : [index - d, index + d]) if (blocks[i]) near.push(blocks[i]);
  const texts = near.map((b) => b.raw);
  const base = LAYOUTS.tnc7;
  return {
    newLine: seen(texts, newLine, base.newLine),
    wide: seen(texts, wide, base.wide),
    // Regardless of surrounding lists: a written list must load.
    continued: true,
    plus: seen(texts, plus, base.plus),
    decimal: seen(texts, decimal, base.decimal),
    indent: seen(texts, indent, base.indent),
    rapid: seen(texts, rapid, base.rapid),
    spacedWords: seen(texts, spacedWords, base.spacedWords),
  };
}

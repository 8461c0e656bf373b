import type { Statement, StatementOf } from "../statement.ts";
import type { AxisName, AxisWord, Value } from "../words.ts";
import { readValue, VALUE } from "../value.ts";
import { coordinateTexts, type IsoCoordinate } from "./coordinates.ts";
import { olderTitle, type IsoNames } from "./names.ts";
import { bareValue, signedValue } from "./print-words.ts";
import type { IsoToken } from "./tokens.ts";
import { isoWordFor } from "./words.ts";

/* Cycles with numbered lines (7.0, 7.1 …): several Klartext blocks are one block of DIN/ISO. */

type Line = Pick<StatementOf<"cycleLine">, "line" | "text">;

const SHIFT = new RegExp(String.raw`^(I?)([XYZABCUVW])[ \t]*(${VALUE})$`, "i");
const TABLE_ROW = new RegExp(String.raw`^#[ \t]*(${VALUE})$`, "i");
const MIRRORED = /^(?:[XYZABCUVW](?:[ \t]+[XYZABCUVW])*)?$/i;
const DWELL = new RegExp(String.raw`^[A-Z][A-Z.]*?(?<!\.)[ \t]*(${VALUE})$`, "i");
const TURNED = new RegExp(String.raw`^(I?)ROT[ \t]*(${VALUE})$`, "i");
const SCALED = new RegExp(String.raw`^SCL[ \t]*(${VALUE})$`, "i");
const CALLED = /^(?:PGM[ \t]+)?([^\s"*;]+)$/i;
const ORIENTED = new RegExp(String.raw`^(?:ANGLE|WINKEL)[ \t]*(${VALUE})$`, "i");
const LABEL = String.raw`(?:\d{1,9}|"[^"]*")`;
const LABELS = new RegExp(String.raw`^[^\d"]*?(?<!Q[LRS]?)(${LABEL}(?:[ \t]*/[ \t]*${LABEL})*)$`);
const PLANE_ANGLES = new RegExp(String.raw`^(?:[ABC][ \t]*${VALUE}[ \t]*)*$`, "i");
const PLANE_ANGLE = new RegExp(String.raw`([ABC])[ \t]*(${VALUE})`, "gi");
const TOLERANCE = new RegExp(String.raw`^T[ \t]*(${VALUE})$`, "i");
const HSC = new RegExp(String.raw`^HSC-MODE[ \t]*:[ \t]*([01])(?:[ \t]+TA[ \t]*(${VALUE}))?$`, "i");

/** Number of a parameter word: P01, P02. */
export const parameterWord = (i: number) => `P${String(i).padStart(2, "0")}`;

const valueIn = (m: RegExpExecArray | null, group = 1): Value | null =>
  m?.[group] === undefined ? null : readValue(m[group]);
const axisOf = (letter: string) => letter.toUpperCase() as AxisName;

function shifted(lines: readonly Line[]): AxisWord[] | null {
  const axes: AxisWord[] = [];
  for (const { text } of lines) {
    const m = SHIFT.exec(text);
    const value = valueIn(m, 3);
    if (!m || value === null) return null;
    axes.push({ axis: axisOf(m[2] ?? ""), value, incremental: m[1] !== "" });
  }
  return axes.length > 0 ? axes : null;
}

/** Words after the G word of a cycle; null where a line has no DIN/ISO word. */
function wordsOf(cycle: number, first: string, lines: readonly Line[]): string[] | null {
  const only = lines.length === 1;
  const one = (pattern: RegExp, write: (value: Value) => string): string[] | null => {
    const value = only ? valueIn(pattern.exec(first)) : null;
    return value === null ? null : [write(value)];
  };
  switch (cycle) {
    case 8:
      return only && MIRRORED.test(first)
        ? first
            .toUpperCase()
            .split(/[ \t]+/)
            .filter((w) => w !== "")
        : null;
    case 9:
      return one(DWELL, (v) => `F${bareValue(v)}`);
    case 10: {
      const m = TURNED.exec(first);
      const value = valueIn(m, 2);
      return m && only && value !== null ? coordinateTexts([{ name: "H", value, incremental: m[1] !== "" }]) : null;
    }
    case 11:
      return one(SCALED, (v) => `F${bareValue(v)}`);
    case 12: {
      const name = only ? CALLED.exec(first)?.[1] : undefined;
      return name === undefined ? null : [`P01 ${name}`];
    }
    case 13:
      return one(ORIENTED, (v) => `S${bareValue(v)}`);
    case 14: {
      const list = only ? LABELS.exec(first)?.[1] : undefined;
      return list?.match(new RegExp(LABEL, "g"))?.map((label, i) => `${parameterWord(i + 1)} ${label}`) ?? null;
    }
    case 19:
      return only && PLANE_ANGLES.test(first)
        ? [...first.matchAll(PLANE_ANGLE)].map((m) => `${axisOf(m[1] ?? "")}${signedValue(readValue(m[2] ?? "") ?? 0)}`)
        : null;
    case 32: {
      const tolerance = valueIn(TOLERANCE.exec(first));
      if (tolerance === null || lines.length > 2) return null;
      const words = [`T${bareValue(tolerance)}`];
      if (only) return words;
      const mode = HSC.exec(lines[1]?.text ?? "");
      const angle = valueIn(mode, 2);
      return mode ? [...words, `P01 ${mode[1]}`, ...(angle === null ? [] : [`P02 ${bareValue(angle)}`])] : null;
    }
    default:
      return null;
  }
}

/**
 * The DIN/ISO block for the lines of an older cycle, numbered consecutively from `.0`. Null where a line has no DIN/ISO
 * word.
 */
export function isoOfOlderCycle(cycle: number, lines: readonly Line[]): string | null {
  const rest = lines.slice(1);
  const first = rest[0]?.text ?? null;
  if (first === null) return null;
  const row = cycle === 7 && rest.length === 1 ? valueIn(TABLE_ROW.exec(first)) : null;
  if (row !== null) return `${isoWordFor({ kind: "olderCycle", cycle, row: true })} P01 ${bareValue(row)}`;
  const axes = cycle === 7 ? shifted(rest) : null;
  const words = axes ? coordinateTexts(axes.map((w) => ({ ...w, name: w.axis }))) : wordsOf(cycle, first, rest);
  const word = isoWordFor({ kind: "olderCycle", cycle });
  return words && word ? [word, ...words].join(" ") : null;
}

/** The words after the G word of an older cycle. */
interface OlderWords {
  /** All words except G90 and G91. */
  readonly tokens: readonly IsoToken[];
  readonly coordinates: readonly IsoCoordinate[];
}

const parameterIn = (token: IsoToken | undefined, index: number): Value | null =>
  token?.letter === "P" && token.number === index ? token.value : null;

function labelOf(token: IsoToken): string | null {
  if (token.letter !== "P") return null;
  return token.text === null ? (token.value === null ? null : bareValue(token.value)) : `"${token.text}"`;
}

function toleranceTexts([tolerance, mode, angle, ...more]: readonly IsoToken[]): string[] | null {
  if (tolerance?.letter !== "T" || tolerance.value === null || more.length > 0) return null;
  const first = `T${bareValue(tolerance.value)}`;
  if (!mode) return [first];
  const [of, by] = [parameterIn(mode, 1), parameterIn(angle, 2)];
  if (of === null || (angle && by === null)) return null;
  return [first, `HSC-MODE:${bareValue(of)}${by === null ? "" : ` TA${bareValue(by)}`}`];
}

/** The texts of the lines 1, 2 …; null when a word is missing or unknown. */
function textsOf(
  cycle: number,
  row: boolean,
  { tokens, coordinates }: OlderWords,
  names: IsoNames,
): (string | null)[] | null {
  const only = tokens.length === 1 ? tokens[0] : undefined;
  const one = (front: string, value: Value | null | undefined) =>
    value === null || value === undefined ? null : [front + bareValue(value)];
  const valueOf = (letter: string) => (only?.letter === letter ? only.value : null);
  if (row) return one("#", parameterIn(only, 1));
  switch (cycle) {
    case 7:
      return tokens.map((t, i) => {
        const w = /^[XYZABCUVW]$/.test(t.letter) ? coordinates[i] : undefined;
        return w ? `${w.incremental ? "I" : ""}${w.name}${signedValue(w.value)}` : null;
      });
    case 8:
      return [
        tokens.every((t) => t.raw.length === 1 && /[XYZABCUVW]/.test(t.letter))
          ? tokens.map((t) => t.letter).join(" ")
          : null,
      ];
    case 9:
      return one("DWELL ", valueOf("F"));
    case 10: {
      const [w] = only?.letter === "H" ? coordinates : [];
      return w ? [`${w.incremental ? "I" : ""}ROT${signedValue(w.value)}`] : null;
    }
    case 11:
      return one("SCL ", valueOf("F"));
    case 13:
      return one("ANGLE ", valueOf("S"));
    case 14: {
      const labels = tokens.map(labelOf);
      return labels.length === 0 || labels.includes(null) ? null : [`${names.contour.label}${labels.join(" /")}`];
    }
    case 19:
      return [
        tokens.every((t) => /^[ABC]$/.test(t.letter) && t.value !== null)
          ? tokens.map((t) => `${t.letter}${signedValue(t.value ?? 0)}`).join(" ")
          : null,
      ];
    case 32:
      return toleranceTexts(tokens);
    default:
      return null;
  }
}

/** The Klartext blocks of a cycle of numbered lines. */
const blocksOf = (cycle: number, title: string, texts: readonly string[]): Statement[] =>
  [title, ...texts].map((text, line) => ({ kind: "cycleLine", cycle, line, text }));

/** The Klartext blocks of an older cycle, from the words after its G word; null where they do not fit the cycle. */
export function olderCycleOfIso(cycle: number, row: boolean, words: OlderWords, names: IsoNames): Statement[] | null {
  const read = textsOf(cycle, row, words, names) ?? [];
  const texts = read.filter((text) => text !== null);
  return texts.length > 0 && texts.length === read.length
    ? blocksOf(cycle, cycle === 14 ? names.contour.title : olderTitle(cycle, names), texts)
    : null;
}

const CALLS_PROGRAM = /^G[ \t]*39[ \t]*P[ \t]*01[ \t]+(\S+)$/i;

/** `G39 P01 NAME`: the name is no word, so the block is read as text. Null for any other block. */
export function programCycleOfIso(text: string, names: IsoNames): Statement[] | null {
  const name = CALLS_PROGRAM.exec(text)?.[1];
  return name === undefined ? null : blocksOf(12, olderTitle(12, names), [`PGM ${name}`]);
}

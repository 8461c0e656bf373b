import type { Statement } from "./statement.ts";
import type { AxisName, AxisWord, Compensation, FeedWord, Words } from "./words.ts";

const NUMBER = String.raw`([+-]?\d+(?:[.,]\d+)?)`;
const axis = (name: string) => String.raw`(?:(I?)${name}${NUMBER}[ \t]*)?`;
/** A straight line in its usual form, up to the end of its text line. */
const LINE = new RegExp(
  String.raw`L[ \t]+${axis("X")}${axis("Y")}${axis("Z")}(?:(R0|(?:RL|RR)(?![A-Z]))[ \t]*)?` +
    String.raw`(?:F(?:(MAX|AUTO)(?![A-Z])|(\d+(?:[.,]\d+)?))[ \t]*)?(?:M(\d{1,4})[ \t]*)?(?:M(\d{1,4})[ \t]*)?(?![^\r\n])`,
  "y",
);
const AXES: readonly AxisName[] = ["X", "Y", "Z"];

/** The number matched by NUMBER; null beyond the safe range. Never -0. */
function number(text: string): number | null {
  const n = Number(text.includes(",") ? text.replace(",", ".") : text);
  return n === 0 ? 0 : Number.isFinite(n) ? n : null;
}

/** Recent coordinates: long programs repeat them, and equal ones are one object. */
const RECENT_BITS = 12;
const recent = new Array<AxisWord | undefined>(2 ** RECENT_BITS).fill(undefined);

function axisWord(axis: AxisName, value: number, incremental: boolean): AxisWord {
  // Coordinates have at most four decimals; the multiplier spreads them and their axes over the table.
  const at = Math.imul(Math.round(value * 10_000) ^ axis.charCodeAt(0), 0x9e3779b1) >>> (32 - RECENT_BITS);
  const known = recent[at];
  if (known && known.value === value && known.axis === axis && known.incremental === incremental) return known;
  return (recent[at] = { axis, value, incremental });
}

/** Shared empty list: most lines have none of these words. */
const NONE: readonly never[] = [];

/**
 * Reads a straight line in its usual form in one step, exactly as the word-by-word reader would; null for any other,
 * which that reader handles. Long programs consist mostly of such lines, and a program just opened is read before the
 * engine has warmed up.
 */
export function readLine(text: string, at: number): Statement | null {
  LINE.lastIndex = at;
  const m = LINE.exec(text);
  if (!m) return null;
  const axes: AxisWord[] = [];
  for (let i = 0; i < 3; i += 1) {
    const digits = m[2 * i + 2];
    if (digits === undefined) continue;
    const value = number(digits);
    if (value === null) return null;
    axes.push(axisWord(AXES[i] ?? "X", value, m[2 * i + 1] === "I"));
  }
  // A copy has no room for more: that room would be a fifth of a long program.
  const words: { -readonly [K in keyof Words]: Words[K] } = {
    axes: axes.slice(),
    functions: NONE,
  };
  if (m[7] !== undefined) words.compensation = m[7] as Compensation;
  if (m[8] !== undefined) words.feed = m[8] === "MAX" ? "max" : "auto";
  else if (m[9] !== undefined) {
    const value = number(m[9]);
    if (value === null) return null;
    words.feed = { value, unit: "F" } satisfies FeedWord;
  }
  if (m[10] !== undefined) words.functions = m[11] === undefined ? [Number(m[10])] : [Number(m[10]), Number(m[11])];
  return { kind: "path", path: "L", words };
}

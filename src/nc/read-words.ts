import type { Scan } from "./scan.ts";
import type { AxisName, AxisWord, Compensation, FeedWord, Words } from "./words.ts";
import { VALUE } from "./value.ts";

const FEED = /(?:(F[ \t]*MAX)|(F[ \t]*AUTO))(?![A-Z])/iy;
const WORD = new RegExp(
  String.raw`(LIN_[XYZABCUVW]|CCA|LEN|IP[RA]|P[RA]|I?[XYZABCUVW]|F[UZ]?|MB|M|R)[ \t]*(?:(MAX)(?![A-Z])|(${VALUE}))`,
  "iy",
);
const COMPENSATION = /R[ \t]?0(?![\d.,])|(?:RL|RR)(?![A-Z])/iy;
const SIDE = /(RL|RR)(?![A-Z])/iy;
/** Older controls print R, F and M even without a value: the modal state stays unchanged. */
const UNTYPED = /[RFM](?![^ \t\u00a0])/iy;
const TURN = /DR[ \t]*([+-])/iy;

type Building = { -readonly [K in keyof Words]: Words[K] };

/** True when `code` could start one of the words that patterns before WORD take. */
const isLetter = (scan: Scan, letter: number) => (scan.text.charCodeAt(scan.at) | 32) === letter;

export const axisName = (letter: string) => letter.toUpperCase() as AxisName;

/** Functions with a feed of their own: an F after them belongs to them. */
const WITH_FEED: ReadonlySet<number> = new Set([128, 140]);
const feedKey = (functions: readonly number[]) => (functions.some((m) => WITH_FEED.has(m)) ? "functionFeed" : "feed");

const feedUnit = (letters: string) => letters as "F" | "FU" | "FZ";

/**
 * Reads the words of a path block up to its end. `radiusFirst`: an R word is a radius before it can be a compensation,
 * as in `RND R0.5`.
 */
export function readWords(scan: Scan, radiusFirst = false): Words {
  const axes: AxisWord[] = [];
  const linear: AxisWord[] = [];
  const functions: number[] = [];
  const extra: string[] = [];
  const words: Building = { axes, functions };
  const put = <K extends keyof Words>(key: K, word: string, value: Words[K], length: number) => {
    if (words[key] !== undefined) scan.issue({ code: "wordTwice", severity: "warning", data: { word } }, length);
    words[key] = value;
  };
  while (!scan.done) {
    let m: RegExpExecArray | null = null;
    if (isLetter(scan, 102) && (m = scan.take(FEED))) {
      put(feedKey(functions), "F", m[1] ? "max" : "auto", m[0].length);
    } else if (
      isLetter(scan, 114) &&
      (m = scan.take(radiusFirst && words.radius === undefined ? SIDE : COMPENSATION))
    ) {
      put("compensation", "R", m[0].replace(/[ \t]/, "").toUpperCase() as Compensation, m[0].length);
    } else if (isLetter(scan, 100) && (m = scan.take(TURN))) {
      put("turn", "DR", m[1] === "+" ? "ccw" : "cw", m[0].length);
    } else if ((m = scan.take(WORD))) {
      readWord(scan, m, { axes, linear, functions, extra }, put);
    } else if (!scan.take(UNTYPED)) {
      const word = scan.word();
      extra.push(word);
      scan.issue({ code: "wordNotUnderstood", severity: "warning", data: { text: word.slice(0, 40) } }, word.length);
    }
  }
  if (linear.length > 0) words.linear = linear;
  if (extra.length > 0) words.extra = extra;
  return words;
}

interface Lists {
  readonly axes: AxisWord[];
  readonly linear: AxisWord[];
  readonly functions: number[];
  readonly extra: string[];
}
type Put = <K extends keyof Words>(key: K, word: string, value: Words[K], length: number) => void;

function readWord(scan: Scan, m: RegExpExecArray, lists: Lists, put: Put): void {
  const name = (m[1] ?? "").toUpperCase();
  const length = m[0].length;
  if (m[2] !== undefined && name !== "MB") return unread(scan, m[0], lists.extra);
  const value = m[3] === undefined ? null : scan.value(m[3]);
  if (name === "MB")
    return void (m[2] !== undefined
      ? put("retract", name, "max", length)
      : value !== null && put("retract", name, value, length));
  if (value === null) return unread(scan, m[0], lists.extra, false);
  switch (name) {
    case "F":
    case "FU":
    case "FZ":
      return put(feedKey(lists.functions), "F", { value, unit: feedUnit(name) } satisfies FeedWord, length);
    case "M":
      if (typeof value === "number") lists.functions.push(value);
      else unread(scan, m[0], lists.extra);
      return;
    case "R":
      return put("radius", "R", value, length);
    case "CCA":
      return put("centreAngle", name, value, length);
    case "LEN":
      return put("length", name, value, length);
    case "PR":
    case "IPR":
      return put("polarRadius", name, { value, incremental: name === "IPR" }, length);
    case "PA":
    case "IPA":
      return put("polarAngle", name, { value, incremental: name === "IPA" }, length);
    default: {
      const incremental = name.startsWith("I");
      if (name.startsWith("LIN_"))
        return void lists.linear.push({ axis: axisName(name.slice(4)), value, incremental: false });
      const axis = axisName(incremental ? name.slice(1) : name);
      const before = lists.axes.findIndex((w) => w.axis === axis);
      if (before >= 0) scan.issue({ code: "wordTwice", severity: "warning", data: { word: axis } }, length);
      lists.axes.splice(before < 0 ? lists.axes.length : before, before < 0 ? 0 : 1, { axis, value, incremental });
    }
  }
}

function unread(scan: Scan, word: string, extra: string[], say = true): void {
  extra.push(word);
  if (say)
    scan.issue({ code: "wordNotUnderstood", severity: "warning", data: { text: word.slice(0, 40) } }, word.length);
}

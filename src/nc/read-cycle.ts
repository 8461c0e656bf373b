import type { BlockIssue } from "./issue.ts";
import { Scan } from "./scan.ts";
import type { CycleParameter } from "./words.ts";
import { NUMBER_PARAMETER, VALUE } from "./value.ts";

/** One line of a block: its text without comment and continuation mark, where it starts, and its comment. */
export interface BlockLine {
  readonly text: string;
  readonly offset: number;
  readonly comment: string | null;
}

/** The number of a cycle and of its line; some posts leave a blank before the point. */
const NUMBER = /(?:(\d{1,2})[ \t]+\.(\d{1,3})(?!\S)|(\d{1,9})(?:\.(\d{1,3}))?(?![\d.]))/y;
const Q_HEAD = new RegExp(String.raw`(${NUMBER_PARAMETER})([ \t]*)(=?)[ \t]*`, "iy");
const Q_VALUE = new RegExp(String.raw`(?:F?[ \t]*(MAX|AUTO)(?![A-Z])|F?[ \t]*(${VALUE}))`, "iy");

/** The number of a cycle, and of its line if present; null without a number. */
export function takeCycleNumber(scan: Scan): { readonly cycle: number; readonly line: number | null } | null {
  const m = scan.take(NUMBER);
  if (!m) return null;
  const line = m[2] ?? m[4];
  return { cycle: Number(m[1] ?? m[3]), line: line === undefined ? null : Number(line) };
}

/** Reads the parameters of one line, usually one. The comment belongs to the last of them. */
export function readParameters(line: BlockLine, parameters: CycleParameter[], issues: BlockIssue[]): void {
  const scan = new Scan(line.text, line.offset);
  const from = parameters.length;
  while (!scan.done) {
    const head = scan.take(Q_HEAD);
    if (!head) {
      const word = scan.word();
      scan.issue({ code: "wordNotUnderstood", severity: "warning", data: { text: word.slice(0, 40) } }, word.length);
      continue;
    }
    const q = (head[1] ?? "").toUpperCase();
    const [gap, equals] = [head[2] ?? "", head[3] ?? ""];
    const bare = head[0].trimEnd();
    const start = scan.at - head[0].length + (head[1] ?? "").length;
    if (!equals)
      scan.issue({ code: "equalsMissing", severity: "warning", data: { text: q } }, head[0].length, {
        from: start,
        length: gap.length,
        text: "=",
      });
    else if (gap)
      scan.issue({ code: "blankBeforeEquals", severity: "info", data: { text: bare } }, head[0].length, {
        from: start,
        length: gap.length,
        text: "",
      });
    const m = scan.take(Q_VALUE);
    const word = m?.[1]?.toUpperCase();
    const value = word ? (word === "MAX" ? "max" : "auto") : m ? scan.value(m[2] ?? "") : null;
    if (!m) {
      const text = scan.done ? "" : scan.word();
      if (text === "") scan.issue({ code: "wordMissing", severity: "error", data: { word: q } });
      else scan.issue({ code: "badNumber", severity: "error", data: { text: text.slice(0, 40) } }, text.length);
    }
    parameters.push({ q, value, label: null });
  }
  const last = parameters.length > from ? parameters.pop() : undefined;
  if (last) parameters.push({ ...last, label: line.comment });
  for (const i of scan.issues) issues.push(i);
}

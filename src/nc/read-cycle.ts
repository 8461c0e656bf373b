import type { BlockIssue } from "./program.ts";
import { Scan } from "./scan.ts";
import type { CycleParameter, Statement } from "./statement.ts";
import { NUMBER_PARAMETER, VALUE } from "./value.ts";

/** One line of a block: its text without comment and continuation mark, where it starts, and its comment. */
export interface BlockLine {
  readonly text: string;
  readonly offset: number;
  readonly comment: string | null;
}

/** Of a cycle, and of its line; some posts leave a blank before the point. */
const NUMBER = /(?:(\d{1,2})[ \t]+\.(\d{1,3})(?!\S)|(\d{1,9})(?:\.(\d{1,3}))?(?![\d.]))/y;
const Q_HEAD = new RegExp(String.raw`(${NUMBER_PARAMETER})([ \t]*)(=?)[ \t]*`, "iy");
const Q_INLINE = new RegExp(String.raw`\s${NUMBER_PARAMETER}[ \t]*=`, "i");
const Q_VALUE = new RegExp(String.raw`(?:F?[ \t]*(MAX|AUTO)(?![A-Z])|F?[ \t]*(${VALUE}))`, "iy");

/** Everything behind CYCL DEF; null when no cycle number stands there. */
export function readCycle(scan: Scan, lines: readonly BlockLine[], issues: BlockIssue[]): Statement | null {
  const number = scan.take(NUMBER);
  if (!number) return null;
  const cycle = Number(number[1] ?? number[3]);
  const numbered = number[2] ?? number[4];
  if (numbered !== undefined) {
    const text = scan.rest;
    scan.at = scan.text.length;
    return { kind: "cycleLine", cycle, line: Number(numbered), text };
  }
  const inline = Q_INLINE.exec(scan.text.slice(scan.at));
  const end = inline ? scan.at + inline.index : scan.text.length;
  let name = scan.text.slice(scan.at, end).trim();
  const parameters: CycleParameter[] = [];
  const read = (line: BlockLine) => readParameters(line, parameters, issues);
  if (inline) read({ text: scan.text.slice(end), offset: scan.offset + end, comment: lines[0]?.comment ?? null });
  scan.at = scan.text.length;
  for (const line of lines.slice(1)) {
    const text = line.text.trim();
    if (text === "" || /^Q[LR]?\d/i.test(text)) read(line);
    else if (parameters.length === 0) name = `${name} ${text}`.trim();
    else {
      const last = parameters.pop();
      if (last) parameters.push({ ...last, label: `${last.label ?? ""} ${text}`.trim() });
    }
  }
  return { kind: "cycle", cycle, name, parameters };
}

/** Reads the parameters of one line, usually one. The comment belongs to the last of them. */
function readParameters(line: BlockLine, parameters: CycleParameter[], issues: BlockIssue[]): void {
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

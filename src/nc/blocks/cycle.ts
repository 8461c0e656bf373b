import { parameterValueText } from "../print-words.ts";
import { readParameters, takeCycleNumber, type BlockLine } from "../read-cycle.ts";
import type { CycleParameter } from "../words.ts";
import { defineBlock, type BlockReading } from "./define.ts";
import { BARE, plainText, type ComparedWords } from "./compared-words.ts";
import { property } from "./words.ts";
import { NUMBER_PARAMETER } from "../value.ts";

const INLINE = new RegExp(String.raw`\s${NUMBER_PARAMETER}[ \t]*=`, "i");
type Parameters = readonly CycleParameter[];

/** Name and parameters after the number, on one line or several. */
function read({ scan, lines, issues }: BlockReading): { readonly name: string; readonly parameters: Parameters } {
  const inline = INLINE.exec(scan.text.slice(scan.at));
  const end = inline ? scan.at + inline.index : scan.text.length;
  let name = scan.text.slice(scan.at, end).trim();
  const parameters: CycleParameter[] = [];
  const take = (line: BlockLine) => readParameters(line, parameters, issues);
  if (inline) take({ text: scan.text.slice(end), offset: scan.offset + end, comment: lines[0]?.comment ?? null });
  scan.at = scan.text.length;
  for (const line of lines.slice(1)) {
    const text = line.text.trim();
    if (text === "" || /^Q[LR]?\d/i.test(text)) take(line);
    else if (parameters.length === 0) name = `${name} ${text}`.trim();
    else {
      const last = parameters.pop();
      if (last) parameters.push({ ...last, label: `${last.label ?? ""} ${text}`.trim() });
    }
  }
  return { name, parameters };
}

/** Unreadable values of a cycle, as written. */
function unread(raw: string, q: string): string {
  const found = new RegExp(String.raw`(?:^|[^A-Z\d])${q}[ \t]*=?[ \t]*([^;~\r\n]*)`, "i").exec(raw);
  return plainText(found?.[1] ?? "");
}

/** A cycle with Q parameters. */
export const cycle = defineBlock({
  kind: "cycle",
  keyword: "CYCL DEF",
  begins: String.raw`CYCLE?[ \t]*DEF(?![A-Z_])`,
  words: [
    property<number>()("cycle"),
    property<string>()("name"),
    property<Parameters>()<"parameters", never>("parameters", {
      fields: (parameters) =>
        parameters.map(({ q, label }) => ({
          id: q,
          name: { word: `${q} ${(label ?? "").trim()}`.trim() },
          about: "parameter",
          entry: "parameter",
          get: (all) => all.find((each) => each.q === q)?.value ?? null,
          put: (all, value) =>
            value === null ? undefined : all.map((each) => (each.q === q ? { ...each, value } : each)),
        })),
    }),
  ],
  read(reading) {
    const number = takeCycleNumber(reading.scan);
    return number && number.line === null ? { kind: "cycle", cycle: number.cycle, ...read(reading) } : null;
  },
  print(s, style) {
    const lines = [
      `CYCL DEF ${s.cycle}${s.name === "" ? "" : `${style.wide ? "  " : " "}${s.name}`}`,
      ...s.parameters.map(
        (p) => `${style.indent}${p.q}=${parameterValueText(p.value, style)}${p.label === null ? "" : ` ;${p.label}`}`,
      ),
    ];
    return style.continued ? lines.map((line, i) => (i < lines.length - 1 ? `${line} ~` : line)) : lines;
  },
  lines: "own",
  pairKey: (s) => `cycle ${s.cycle}`,
  nameKey: (s) => `cycle ${s.cycle}`,
  compareAs(s, said: ComparedWords, raw) {
    for (const { q, value } of s.parameters)
      said.put(q, value === null ? unread(raw, q) : parameterValueText(value, BARE));
  },
  part: "operations",
  offered: { group: "cycles", begins: null },
});

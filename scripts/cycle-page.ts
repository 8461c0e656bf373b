import type { Cycle, PrintedFact } from "../src/cycles/define.ts";
import type { Param } from "../src/cycles/params.ts";
import { texts } from "../src/i18n/index.ts";
import { ncWords } from "../src/i18n/nc-labels.ts";
import type { CycleNumber, ParamTextId } from "../src/cycles/index.ts";

const { cycles, params } = texts("en");
const labels = ncWords("en");

const units: Partial<Record<Param["kind"], string>> = {
  diameter: "⌀ mm",
  oversizeDiameter: "⌀ mm",
  radial: "r mm",
  angle: "°",
  feed: "mm/rev, mm/min",
  choice: "",
  count: "",
  factor: "",
  percent: "%",
  revolutions: "rev",
};
const cell = (text: string) => text.replaceAll("|", "\\|");
const list = (lines: readonly string[], mark: (i: number) => string) =>
  lines.map((line, i) => `${mark(i)} ${line}`).join("\n");

const countsOnly = ({ condition }: Param) =>
  condition === null ? "" : `only with ${condition.q} = ${condition.among.join(" or ")}`;

function row(q: string, p: Param): string {
  const text = params[p.text as ParamTextId];
  const choices =
    "choices" in text
      ? Object.entries(text.choices)
          .map(([n, meaning]) => `${n}: ${meaning}`)
          .join("; ")
      : "";
  const range = p.choices ? p.choices.join(", ") : `${p.range[0]} … ${p.range[1]}`;
  const notes = [
    p.optional ? "NO ENT allowed" : "",
    p.incremental ? "incremental" : "",
    p.reserved ? "reserved" : "",
    countsOnly(p),
  ]
    .filter(Boolean)
    .join(", ");
  const cells = [
    q,
    text.prompt,
    cycles.kinds[p.kind],
    units[p.kind] ?? "mm",
    range,
    String(p.example),
    notes,
    labels.params[p.text as ParamTextId].text,
    `${p.evidence}/${p.rangeEvidence}`,
    [text.explanation, choices].filter(Boolean).join(" "),
  ];
  return `| ${cells.map(cell).join(" | ")} |`;
}

/** The table of the parameters, and the meaning of its tags; empty for a cycle without any. */
function parameters({ params: list }: Cycle): string[] {
  const rows = Object.entries(list).map(([q, p]) => row(q, p));
  if (rows.length === 0) return [];
  const grades = Object.entries(cycles.evidence).map(([grade, meaning]) => `${grade}: ${meaning}`);
  return [
    "## Parameters",
    [
      "| Q | Prompt | Measures | Unit | Range | Example | Entry | NC label | Evidence | Meaning |",
      "|---|---|---|---|---|---|---|---|---|---|",
      ...rows,
    ].join("\n"),
    `Evidence of the parameter / of its range: ${grades.join("; ")}.`,
  ];
}

const parts: Readonly<Record<PrintedFact, string>> = {
  name: "its name",
  purpose: "what it is for",
  start: "where it starts",
  roughing: "the steps of roughing",
  firstFinishing: "the first step of finishing",
};

/** The source of the list, and the other facts that a page prints. */
function sourceOf({ manual, partly, evidence }: Cycle): string {
  if (manual) return `${manual.document}, section ${manual.section}${manual.page ? `, page ${manual.page}` : ""}`;
  const list = `parameter list recalled (${cycles.evidence[evidence]}), compare on your control`;
  return partly
    ? `${list}. Printed in ${partly.document}, topic “${partly.section}”: ${partly.parts.map((p) => parts[p]).join(", ")}`
    : list;
}

/** The page of one cycle, generated from the catalogue and the English texts. */
export function cyclePage(cycle: Cycle): string {
  const number = cycle.number as CycleNumber;
  const text = cycles.of[number];
  return (
    "" +
    [
      `<!-- Written by \`npm run docs\` from src/cycles/c${number}.ts and src/i18n/en; edit those. -->`,
      `# ${number} ${text.name}`,
      text.summary,
      ...(cycle.acts ? [] : [`![Help picture of cycle ${number}](${number}.svg)`]),
      text.description.join("\n\n"),
      `Source: ${sourceOf(cycle)}. In NC text: \`CYCL DEF ${number} ${labels.cycles[number].text}\`.`,
      ...parameters(cycle),
      ...(text.rough.length > 0 ? ["## Roughing, step by step", list(text.rough, (i) => `${i + 1}.`)] : []),
      ...(text.finish.length > 0 ? ["## Finishing, step by step", list(text.finish, (i) => `${i + 1}.`)] : []),
      "## Notes",
      list(text.notes, () => "-"),
    ].join("\n\n") +
    "\n"
  );
}

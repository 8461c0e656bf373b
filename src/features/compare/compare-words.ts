import { cycleByNumber, type ParamTextId } from "../../cycles/index.ts";
import type { CompareTexts } from "../../i18n/en/compare.ts";
import type { Texts } from "../../i18n/index.ts";
import type { Lengths } from "../../i18n/lengths.ts";
import type { Program } from "../../nc/program.ts";
import type { ComparedOperation, OperationOutcome } from "../../program/compare/by-operation.ts";
import type { BlockDifference } from "../../program/compare/compare.ts";
import { bareText, type WordChange } from "../../program/compare/meaning.ts";
import { changedEffects, type Consequence, type Effects } from "../../report/compare/consequences.ts";
import { durationText } from "../../app/base/clock-text.ts";
import { verdictTitle } from "../../app/findings/verdict-words.ts";
import { issueText } from "../../app/calculation/issue-text.ts";
import { isListed, isFormattingOnly, tallyOf, type ComparedFile, type Consequences } from "./compared.ts";

/** Texts and number formats for a comparison. */
export interface Wording {
  readonly texts: Texts;
  readonly words: CompareTexts;
  /** In the unit of the open program, even if the other program has another one. */
  readonly lengths: Lengths;
}

const SIGN = { more: "+", less: "−" } as const;

export function timeText(
  {
    texts: {
      page: { effect },
    },
    lengths: { language },
  }: Pick<Wording, "texts" | "lengths">,
  seconds: number,
): string {
  return durationText(effect.duration, language, seconds);
}

/** Change of a time: +8 s; null if too small to show. */
export function longerBy(wording: Wording, { before, after }: Consequence): string | null {
  if (!before || !after || !changedEffects({ before, after }).includes("seconds")) return null;
  const by = after.seconds - before.seconds;
  return `${by > 0 ? SIGN.more : SIGN.less}${timeText(wording, Math.abs(by))}`;
}

function effectText(wording: Wording, name: keyof Effects, { [name]: value }: Effects): string {
  if (name === "seconds") return timeText(wording, value);
  if (name === "passes") return String(value);
  const { lengths } = wording;
  return name === "residue"
    ? lengths.words(`${lengths.area(value, 2)}\u00a0mm²`)
    : `${lengths.number(value)} ${lengths.unit}`;
}

/**
 * Effects on a changed operation: "Infeed 2.56 → 2.05", "Time 1 min 20 s → 1 min 28 s (+8 s)". An operation that is
 * added or removed has only its own values.
 */
export function effectTexts(
  wording: Wording,
  consequence: Consequence,
  outcome: OperationOutcome = "kept",
): readonly { readonly name: keyof Effects; readonly text: string }[] {
  const { words } = wording;
  const { before, after } = consequence;
  const own = outcome === "added" ? after : outcome === "removed" ? before : null;
  if (own)
    return changedEffects(consequence)
      .filter((name) => own[name] > 0)
      .map((name) => ({ name, text: `${words.effects[name]} ${effectText(wording, name, own)}` }));
  const longer = longerBy(wording, consequence);
  return changedEffects(consequence).map((name) => {
    const [was, is] = [
      before ? effectText(wording, name, before) : words.notRun,
      after ? effectText(wording, name, after) : words.notRun,
    ];
    const by = name === "seconds" && longer !== null ? ` (${longer})` : "";
    return { name, text: `${words.effects[name]} ${was} → ${is}${by}` };
  });
}

function wordLabel({ texts, words }: Pick<Wording, "texts" | "words">, name: string, cycle: number | null): string {
  if (name === "/") return words.skip;
  if (name === "T") return words.tool;
  const param = cycle === null ? undefined : cycleByNumber(cycle)?.params[name];
  return param ? `${name} ${texts.params[param.text as ParamTextId].label}` : name;
}

/** Effects on the whole program, without infeed: that belongs to one operation. */
export const wholeTexts = (wording: Wording, { whole }: Consequences): ReturnType<typeof effectTexts> =>
  effectTexts(wording, whole).filter(({ name }) => name !== "infeed");

/** One changed word: "Q463 Max. cutting depth 3 → 2.4". */
export function wordText({ texts, words }: Wording, { name, from, to }: WordChange, cycle: number | null): string {
  const label = wordLabel({ texts, words }, name, cycle);
  return `${label} ${from ?? words.without} → ${to ?? words.without}`.trim();
}

/** The cycle that a block defines; null for any other. */
export function cycleIn({ blocks }: Program, index: number | null): number | null {
  const s = index === null ? undefined : blocks[index]?.statement;
  return s?.kind === "cycle" ? s.cycle : null;
}

export const wordTexts = (wording: Wording, file: ComparedFile, { a, b, words }: BlockDifference): readonly string[] =>
  words.map((change) => wordText(wording, change, cycleIn(file.after, b) ?? cycleIn(file.before, a)));

/** Label of a block: "Block 12", or both numbers if it moved. */
export function blockLabel({ words }: Wording, { numbers }: ComparedFile, { kind, a, b }: BlockDifference): string {
  const [from, to] = [
    a === null ? null : String(numbers.before[a] ?? ""),
    b === null ? null : String(numbers.after[b] ?? ""),
  ];
  return kind === "moved" && from !== null && to !== null ? words.blockMoved(from, to) : words.block(to ?? from ?? "");
}

/** Lines of a block shown for one side: for a cycle the first line and those with changed values. */
export function shownLines(
  { blocks }: Program,
  index: number | null,
  { kind, words }: BlockDifference,
): readonly string[] {
  const block = index === null ? undefined : blocks[index];
  if (!block) return [];
  const text = kind === "note" || kind === "form" ? block.raw : bareText(block);
  const lines = text
    .split(/\r\n?|\n/)
    .map((line) => line.trim().replace(/(?<!\s)\s*~$/, ""))
    .filter((line) => line !== "");
  if (block.statement.kind !== "cycle" || words.length === 0) return lines;
  const names = words.map(({ name }) => new RegExp(String.raw`^${name}(?!\d)`, "i"));
  return lines.filter((line, i) => i === 0 || names.some((name) => name.test(line)));
}

/** Name of an operation: its own title, or its cycles. */
export function operationTitle({ texts, words }: Wording, { a, b }: ComparedOperation): string {
  const unit = b ?? a;
  if (!unit) return words.frame;
  const cycles = unit.cycles.map((n) => {
    const known = (texts.cycles.of as Readonly<Record<number, { readonly name: string }>>)[n];
    return known ? `${n} ${known.name}` : String(n);
  });
  const title =
    unit.title === null
      ? cycles.join(", ")
      : cycles.length > 0
        ? `${unit.title} (${unit.cycles.join(", ")})`
        : unit.title;
  return [words.operation(unit.place + 1), title].filter((part) => part !== "").join(" · ");
}

/** Summary in one line: "3 values, 1 operation more; time +8 s". */
export function summaryText(
  wording: Wording,
  files: readonly ComparedFile[],
  consequences: Consequences | null,
): string {
  const { words } = wording;
  const { written, ...meant } = tallyOf(files);
  const counted = (Object.keys(meant) as (keyof typeof meant)[]).flatMap((key) =>
    meant[key] > 0 ? [words[key](meant[key])] : [],
  );
  const said =
    counted.length > 0
      ? counted.join(", ")
      : written > 0
        ? `${words.sameMeaning} ${words.written(written)}`
        : words.same;
  const longer = consequences && longerBy(wording, consequences.whole);
  return longer === null ? said : `${said}; ${words.time(longer)}`;
}

/** New and resolved findings, as sentences. */
export const findingTexts = ({ texts, lengths }: Wording, list: Consequences["came"]): readonly string[] =>
  list.map(({ issue, cycle }) => issueText(texts, lengths, issue, cycle));

/** The verdicts of both programs, where they differ. */
export function verdictChange({ texts, lengths }: Wording, { before, after }: Consequences): string | null {
  const [was, is] = [before, after].map((verdict) => verdictTitle(texts.findings.verdict, lengths, verdict));
  return was === is ? null : `${was} → ${is}`;
}

/** The comparison as plain text, for a message or a file. */
export function comparisonText(
  wording: Wording,
  [before, after]: readonly [string, string],
  files: readonly ComparedFile[],
  consequences: Consequences | null,
  withWriting: boolean,
): string {
  const { words } = wording;
  const lines = [`${words.title}: ${before} → ${after}`, summaryText(wording, files, consequences)];
  if (consequences) {
    const changed = verdictChange(wording, consequences);
    if (changed !== null) lines.push(`${words.verdict}: ${changed}`);
    lines.push(...wholeTexts(wording, consequences).map(({ text }) => `  ${text}`));
    lines.push(...findingTexts(wording, consequences.went).map((text) => `- ${text}`));
    lines.push(...findingTexts(wording, consequences.came).map((text) => `+ ${text}`));
  }
  files.forEach((file, f) => {
    if (!file.isMain) lines.push("", file.name);
    file.operations.forEach((operation, o) => {
      const consequence = consequences?.operations[f]?.[o];
      if (!isListed(operation, consequence, withWriting)) return;
      const fate = words.fates[operation.outcome];
      lines.push("", `${operationTitle(wording, operation)}${fate === "" ? "" : ` (${fate})`}`);
      if (consequence)
        lines.push(...effectTexts(wording, consequence, operation.outcome).map(({ text }) => `  ${text}`));
      for (const each of operation.differences) {
        if (isFormattingOnly(each) && !withWriting) continue;
        lines.push(
          `  ${blockLabel(wording, file, each)}, ${words.kinds[each.kind]}${
            each.words.length === 0 ? "" : `: ${wordTexts(wording, file, each).join(", ")}`
          }`,
        );
        lines.push(...shownLines(file.before, each.a, each).map((line) => `    - ${line}`));
        lines.push(...shownLines(file.after, each.b, each).map((line) => `    + ${line}`));
      }
    });
  });
  return `${lines.join("\n")}\n`;
}

import type { BetterWaysTexts } from "../../i18n/en/better-ways.ts";
import { cycleByNumber, type ParamTextId } from "../../cycles/index.ts";
import { writer } from "../../i18n/write.ts";
import { parse } from "../../nc/parse.ts";
import { operationsOf } from "../../program/edits/operations.ts";
import type { BetterWay } from "../../report/better-ways/better-ways.ts";
import type { ChangeSubject } from "../../report/better-ways/change.ts";
import type { Gain, Measure } from "../../report/better-ways/measure.ts";
import type { CutMaterial } from "../../program/tools/cutting-table.ts";
import { NO_AREA } from "../../app/findings/effect/effect.ts";
import { writeTyped } from "../../app/fields/dialog/write-value.ts";
import { timeText, type Wording } from "./compare-words.ts";

/** Texts for better ways, and what they name. */
export interface WayWording extends Pick<Wording, "texts" | "lengths"> {
  readonly ways: BetterWaysTexts;
  readonly material: CutMaterial;
  readonly operations: ReturnType<typeof operationsIn>;
}

/** Decimals of a value in a program. */
const DECIMALS = 4;

/** The operations of a program: their titles, and the first cycle of each, 0 for none. */
export function operationsIn(text: string): readonly { readonly title: string; readonly cycle: number }[] {
  const program = parse(text);
  return operationsOf(program).units.map(({ title, definitions: [first = -1] }) => {
    const s = program.blocks[first]?.statement;
    const cycle = s?.kind === "cycle" ? s.cycle : 0;
    return { title: title ?? (cycle === 0 ? "" : String(cycle)), cycle };
  });
}

function joined({ and }: BetterWaysTexts, names: readonly string[]): string {
  const last = names.at(-1) ?? "";
  return names.length < 2 ? last : and(names.slice(0, -1).join(", "), last);
}

function gainText({ ways: { gains }, lengths, texts }: WayWording, way: BetterWay, gain: Gain): string {
  const { before, after, subject } = way;
  switch (gain) {
    case "verdict":
      return gains.verdict;
    case "residual":
      return after.residual < NO_AREA
        ? gains.residualGone(subject.tool === undefined ? "" : String(subject.tool))
        : gains.residualLess(writer(lengths).area(before.residual - after.residual));
    case "bending":
      return gains.bendsLess(writer(lengths).length(before.bending - after.bending));
    case "tools":
      return subject.instead === undefined
        ? gains.toolsLess(before.tools - after.tools)
        : gains.toolGone(String(subject.instead));
    case "changes":
      return gains.changesLess(before.changes - after.changes);
    case "seconds":
      return gains.shorter(timeText({ lengths, texts }, before.seconds - after.seconds));
  }
}

/** What is gained, in a few words. A tool less is a change less: only the tool is named. */
export function gainWords(wording: WayWording, way: BetterWay): string {
  const named = way.gains.filter((gain) => gain !== "changes" || !way.gains.includes("tools"));
  return named.map((gain) => gainText(wording, way, gain)).join(" · ");
}

/** So many operations are named; of more only their numbers. */
const MOST_NAMED = 3;

/** Numbers of operations: "1–4, 7". */
function ranges(units: readonly number[]): string {
  const found: [from: number, to: number][] = [];
  for (const n of units.map((unit) => unit + 1)) {
    const last = found.at(-1);
    if (last?.[1] === n - 1) last[1] = n;
    else found.push([n, n]);
  }
  return found.map(([from, to]) => (from === to ? String(from) : `${from}–${to}`)).join(", ");
}

/** The operations that a way changes. */
function operationWords({ ways, operations }: WayWording, units: readonly number[]): string {
  if (units.length > MOST_NAMED) return ways.operations(ranges(units));
  return joined(
    ways,
    units.map((unit) => ways.operation(unit + 1, operations[unit]?.title ?? "")),
  );
}

/** A changed value: "Q463 Max. cutting depth 3 → 3.8", with the words of a choice; "1 – 2 → 3 – 3.8" of several. */
function valueWords({ texts, operations, lengths: { language } }: WayWording, { value, units }: ChangeSubject): string {
  if (!value) return "";
  const param = cycleByNumber(operations[units[0] ?? -1]?.cycle ?? 0)?.params[value.at];
  const { label = "", ...words } = param ? texts.params[param.text as ParamTextId] : {};
  const choices = "choices" in words ? (words.choices as Readonly<Record<number, string>>) : {};
  const choice = choices[value.to];
  const number = (from: number, to: number | undefined) =>
    [...new Set([from, to ?? from])].map((n) => writeTyped(language, n, DECIMALS)).join(" – ");
  const numbers = `${number(value.from, value.upTo?.from)} → ${number(value.to, value.upTo?.to)}`;
  return `${value.at} ${label} ${numbers}${choice === undefined ? "" : ` (${choice})`}`;
}

/** What changes, and why it may. */
export function subjectWords(wording: WayWording, { subject }: Pick<BetterWay, "subject">): string {
  const { ways, texts, lengths, material } = wording;
  const { kinds } = ways;
  const { units, tool, tools = [], instead, value } = subject;
  const all = operationWords(wording, units);
  const [own, beside] = [units.slice(0, -1), units.slice(-1)].map((each) => operationWords(wording, each));
  const number = (n: number | undefined) => writeTyped(lengths.language, n ?? 0, DECIMALS);
  switch (subject.kind) {
    case "noCut":
      return kinds.noCut(all);
    case "fewerTools": {
      const names = tools.map(String);
      return names.length > 1 ? kinds.severalTools(all, joined(ways, names)) : kinds.fewerTools(all, names[0] ?? "");
    }
    case "fewerChanges":
      return kinds.fewerChanges(own ?? "", beside ?? "");
    case "restOperation":
      return kinds.restOperation(all, String(tool));
    case "otherTool":
      return kinds.otherTool(all, String(tool), String(instead));
    case "otherCycle": {
      const known = (texts.cycles.of as Readonly<Record<number, { readonly name: string }>>)[subject.cycle ?? 0];
      const name = `${subject.cycle} ${known?.name ?? ""}`.trim();
      return tool === instead ? kinds.otherCycle(all, name) : kinds.otherCycleAndTool(all, name, String(tool));
    }
    case "otherChoice":
      return kinds.otherChoice(all, valueWords(wording, subject));
    case "infeed": {
      const most = `${number(value?.most)} ${lengths.unit}`;
      return kinds.infeed(all, valueWords(wording, subject), String(tool), most);
    }
    case "stiffness":
      return kinds.stiffness(all, valueWords(wording, subject), `${number(value?.most)} ${lengths.unit}`);
    case "both":
      return (subject.parts ?? []).map((each) => subjectWords(wording, { subject: each })).join(" ");
    case "start":
      return kinds.start(all, value?.at ?? "", number(value?.from), number(value?.to));
    case "oneCall":
      return kinds.oneCall(all);
    case "cuttingSpeed":
      return kinds.cuttingSpeed(all, number(value?.from), number(value?.to), material.name);
    case "feed":
      return kinds.feed(all, valueWords(wording, subject), material.name);
  }
}

/** The measures that differ, before and after. */
export function measureWords(
  { ways, lengths, texts }: WayWording,
  { before, after }: BetterWay,
): readonly { readonly name: keyof Measure; readonly label: string; readonly text: string }[] {
  const writes: Readonly<Partial<Record<keyof Measure, (value: number) => string>>> = {
    seconds: (value) => timeText({ lengths, texts }, value),
    residual: writer(lengths).area,
    bending: writer(lengths).length,
  };
  const shown = (name: keyof Measure, { [name]: value }: Measure): string => (writes[name] ?? String)(value);
  return (["seconds", "tools", "changes", "residual", "bending"] as const)
    .map((name) => ({ name, label: ways.measures[name], from: shown(name, before), to: shown(name, after) }))
    .filter(({ from, to }) => from !== to)
    .map(({ name, label, from, to }) => ({ name, label, text: `${from} → ${to}` }));
}

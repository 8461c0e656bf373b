import { wrongSideOf } from "../../../course/judge/wrong-side.ts";
import type { Answer, Slip, TaskMark } from "../../../course/judge/judgement.ts";
import { cycleByNumber, type ParamTextId } from "../../../cycles/index.ts";
import type { Task, TaskSize } from "../../../course/task.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Language } from "../../../i18n/languages.ts";
import { formatNumber, formatSigned } from "../../../i18n/number.ts";
import { toDiameter } from "../../../kernel/units.ts";
import { thicknessOf } from "../../../sim/extent.ts";
import { durationText } from "../../../app/base/clock-text.ts";
import { issueText } from "../../../app/calculation/issue-text.ts";
import { sizeGoal, toleranced, valueGoal } from "./goal-words.ts";

/** Decimals of thicknesses. */
const THICK = 2;
/** Tolerance within which a diameter is half or twice another, mm. */
const SAME_SIZE = 0.01;
/** Relative deviation from which a pitch counts as wrong. */
const OTHER_PITCH = 0.02;

/** Inputs of the words of a mark. */
export interface MarkWording {
  readonly t: CourseTaskTexts;
  readonly texts: Texts;
  readonly language: Language;
  readonly task: Task;
  readonly answer: Answer;
}

/** The cause of a mark: the block, and in a cycle the pass. */
function causeOf({ block, step }: TaskMark, { t, answer: { run } }: MarkWording): string | null {
  if (block === undefined) return null;
  const move = step === undefined ? undefined : run.steps[step]?.move;
  if (move?.phase === "finish") return t.where.finish(String(block));
  return move?.pass === undefined ? t.where.block(String(block)) : t.where.pass(String(block), String(move.pass));
}

/** The measured value of a size or a surface of the drawing. */
function measuredText(
  { rule, value, limit, size: entry }: TaskMark,
  { t, language, task }: Pick<MarkWording, "t" | "language" | "task">,
) {
  const number = (n: number | undefined, decimals = 3) => (n === undefined ? "–" : formatNumber(language, n, decimals));
  const { wrong } = t;
  if (rule === "rz") return value === undefined ? wrong.noRz(number(limit)) : wrong.rz(number(value, 1), number(limit));
  const size = task.sizes?.[entry ?? 0];
  if (!size) return "";
  return value === undefined
    ? wrong.noSize(sizeGoal(t, language, size))
    : radiusQuestion(t, wrong.size[size.kind](number(value), toleranced(language, size)), value, [size]);
}

/** Adds the question whether a diameter that is half or twice a wanted one was taken for a radius. */
function radiusQuestion({ wrong }: CourseTaskTexts, said: string, value: number, wanted: readonly TaskSize[]): string {
  const isTimes = (factor: number) =>
    wanted.some(({ kind, nominal }) => kind !== "face" && Math.abs(value - factor * nominal) < SAME_SIZE);
  return isTimes(1 / 2) ? wrong.half(said) : isTimes(2) ? wrong.twice(said) : said;
}

/** The measured value with its place on the part. */
export function placedText(mark: TaskMark, wording: Pick<MarkWording, "t" | "language" | "task">): string {
  const said = measuredText(mark, wording);
  return mark.place ? wording.t.where.at(said, ...placeWords(wording.language, mark.place)) : said;
}

/** A thread fault: missing, wrong pitch, or incomplete. */
function threadText(
  { about, value = 0, limit }: TaskMark,
  { t: { wrong }, language }: Pick<MarkWording, "t" | "language">,
): string {
  const name = String(about);
  if (value === 0) return wrong.noThread(name);
  const isOther = limit !== undefined && Math.abs(value - limit) > OTHER_PITCH * limit;
  return isOther
    ? wrong.threadPitch(name, formatNumber(language, value, THICK), formatNumber(language, limit))
    : wrong.thread(name);
}

/** A finding about a value, with the name of its prompt where the sentence does not have it. */
const withPrompt = ({ q }: TaskMark, said: string, wording: MarkWording): string =>
  q === undefined || said.includes(q) ? said : wording.t.where.because(valueName(q, wording), said);

function what(mark: TaskMark, wording: MarkWording): string {
  const { t, texts, language, task, answer } = wording;
  const { rule, value, limit, about, rings = [] } = mark;
  const number = (n: number | undefined, decimals = 3) => (n === undefined ? "–" : formatNumber(language, n, decimals));
  const { wrong } = t;
  const time = (seconds: number | undefined) =>
    seconds === undefined ? "–" : durationText(texts.page.effect.duration, language, seconds);
  const thick = () => number(Math.max(thicknessOf(rings), 10 ** -THICK), THICK);
  switch (rule) {
    case "errors":
    case "clean": {
      const cycle = mark.operation === undefined ? null : (answer.run.operations[mark.operation]?.cycle ?? null);
      const way = mark.issue && !mark.isByTool && wrongSideOf(mark.issue);
      if (way) return wrong.wrongSide[way];
      if (!mark.issue) return wrong.gouge;
      const said = withPrompt(mark, issueText(texts, language, mark.issue, cycle).replace(/[.。]$/, ""), wording);
      return mark.issue.code === "diameterOutside"
        ? radiusQuestion(t, said, mark.issue.data.value, task.sizes ?? [])
        : said;
    }
    case "unproved":
      return about === undefined ? wrong.unprovedMilling : wrong.unproved(String(about));
    case "blank":
    case "rapid":
    case "holder":
    case "gouge":
      return wrong[rule];
    case "missing":
      return wrong.missing(mark.depth === undefined ? thick() : number(Math.max(mark.depth, 10 ** -THICK), THICK));
    case "residue":
      if (about !== undefined) return threadText(mark, { t, language });
      return mark.reason
        ? wrong.leftBy(wrong.residue(thick()), texts.messages.reasons[mark.reason])
        : wrong.residue(thick());
    case "size":
    case "rz":
      return measuredText(mark, { t, language, task });
    case "speed":
      return value === undefined ? wrong.noLimit(number(limit)) : wrong.speed(number(value, 0), number(limit));
    case "depth":
      return wrong.depth(number(value), number(limit));
    case "seconds":
      return wrong.seconds(time(value), time(limit));
    case "mostTools":
      return wrong.mostTools(number(value), number(limit));
    case "tools":
    case "cycles":
    case "without":
    case "words":
      return wrong[rule](String(about ?? ""));
    case "values": {
      const asked = task.rules.values?.[mark.entry ?? 0];
      return value === undefined || !asked
        ? wrong.noValue(mark.q ?? "")
        : wrong.values(mark.q ?? "", number(value), valueGoal(t, language, asked));
    }
    case "passes":
      return wrong.passes(value ?? 0, limit ?? 0);
  }
}

/** The name of a value: a parameter with its label, or the axis of a path. */
function valueName(q: string, { texts, answer }: MarkWording): string {
  const cycles = answer.run.operations.flatMap(({ cycle }) => cycleByNumber(cycle) ?? []);
  const param = cycles.find(({ params }) => params[q])?.params[q];
  return param ? `${q} ${texts.params[param.text as ParamTextId].label}` : q;
}

const isInOneBlock = (values: Slip["values"]): boolean => new Set(values.map(({ block }) => block)).size === 1;

/** Slips whose words name their blocks. */
const ALL_BLOCKS: ReadonlySet<Slip["kind"]> = new Set(["tools", "order"]);

/** A slip in words, as a question: the run only shows that it would explain the fault. */
function slipText({ kind, values }: Slip, wording: MarkWording): string {
  const { t, language } = wording;
  const number = (value: number) => (kind === "sign" ? formatSigned(language, value) : formatNumber(language, value));
  const said = values.map(({ q, value, better }) => ({
    name: valueName(q, wording),
    is: number(value),
    better: number(better),
  }));
  const [one, other] = said;
  if (kind === "reversed" || !one) return t.slip.reversed;
  if (kind === "order")
    return t.slip.order(...(values.map(({ block }) => t.where.block(String(block))) as [string, string]));
  if (kind === "call") return t.slip.call(one.is);
  if (kind === "tool") return t.slip.tool(`T${one.is}`);
  if (kind === "tools") {
    const calls = values.map(({ value, block }) => t.slip.where(`T${value}`, t.where.block(String(block))));
    return t.slip.tools(calls[0] ?? "", calls[1] ?? "");
  }
  if (kind === "exchanged" && other) {
    // Two blocks are named each, one block once behind both.
    const [first, second] = values.map(({ block }, i) => {
      const what = `${said[i]?.name} ${said[i]?.is}`;
      return isInOneBlock(values) ? what : t.slip.where(what, t.where.block(String(block)));
    });
    return t.slip.exchanged(first ?? "", second ?? "");
  }
  if (kind === "exchanged") return one.name;
  if (kind === "sign" || kind === "point" || kind === "side" || kind === "relative")
    return t.slip[kind](one.name, one.is, one.better);
  const say = kind === "radius" ? t.slip.half : t.slip.double;
  return t.slip[kind](said.map(({ name, is, better }) => say(name, is, better)).join(t.between.slips));
}

/** Rules whose limit one prompt decides. */
const DECIDED: ReadonlySet<TaskMark["rule"]> = new Set(["depth", "passes"]);

/** The prompt or the block that shapes the contour at the place of a mark, or decides its value; null where unknown. */
function shapedText({ rule, shapedBy, block, q }: TaskMark, wording: MarkWording): string | null {
  if (q !== undefined && DECIDED.has(rule)) return wording.t.where.setBy(valueName(q, wording));
  if (!shapedBy) return null;
  if ("q" in shapedBy) return wording.t.where.shapedBy(valueName(shapedBy.q, wording));
  return shapedBy.block === block ? null : wording.t.where.shapedBy(wording.t.where.block(String(shapedBy.block)));
}

/** Diameter and Z of a place, for a sentence. */
export const placeWords = (language: Language, { z, r }: NonNullable<TaskMark["place"]>): readonly [string, string] => [
  formatNumber(language, toDiameter(r), THICK),
  formatSigned(language, z, THICK),
];

/** Rules whose sentence already contains the place. */
const SAYS_PLACE: ReadonlySet<string> = new Set(["errors", "clean"]);

/** Fault, place on the part, and the step that caused it: "0.4 mm too much was cut at ⌀42, Z-18: block 22, pass 3". */
export function markText(mark: TaskMark, wording: MarkWording): string {
  const { t, language } = wording;
  if (mark.slip) {
    const { kind, values } = mark.slip;
    const isNamed = ALL_BLOCKS.has(kind) || !isInOneBlock(values);
    const where = mark.block === undefined || isNamed ? null : t.where.block(String(mark.block));
    const said = slipText(mark.slip, wording);
    return where === null ? said : t.slip.where(said, where);
  }
  const said = what(mark, wording);
  const placed =
    mark.place && !SAYS_PLACE.has(mark.rule) ? t.where.at(said, ...placeWords(language, mark.place)) : said;
  const causes = [causeOf(mark, wording), shapedText(mark, wording)].filter((cause) => cause !== null);
  return causes.length === 0 ? placed : t.where.because(placed, causes.join(t.between.causes));
}

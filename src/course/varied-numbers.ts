import type { Language, LessonLanguage } from "../i18n/languages.ts";
import { decimalSign } from "../i18n/number.ts";
import { parse } from "../nc/parse.ts";
import { blockNumbers, startLines } from "../nc/program.ts";
import { answerKindOf } from "./predicted-answers.ts";
import { decidingBlock } from "./judge/deciding-block.ts";
import type { Answer } from "./judge/judgement.ts";
import { isRight, truthOf, type Truth } from "./judge/predicting.ts";
import { withLines } from "./page-question.ts";
import { programOfLines } from "./task-start.ts";
import type { Prediction, Task, TaskVariant } from "./task.ts";

/*
 * A question that was answered wrongly is asked again with other values: those of the next variant of the task, or
 * another number in its program. Which one and how much follows from the number of the try; the run decides whether the
 * question still has an answer, and another one.
 */

/** Changes of a number, as a share of it. */
const CHANGES = [1.05, 0.94, 1.12, 0.88, 1.2, 0.8] as const;
/** Most runs to find other numbers. */
const MOST_RUNS = 40;
const VALUE = /(?<front>\bQ\d+\s*=\s*|(?<![A-Z])[XZ])(?<number>[+-]?\d+(?:\.\d+)?)(?![\d.])/gi;

interface Value {
  readonly line: number;
  readonly index: number;
  readonly text: string;
  readonly block: number;
}

/** Other numbers in the program of a task, and in the words that name them. */
export interface OtherNumbers {
  readonly lines: readonly string[];
  /** Numbers as texts: the original, and the other one. */
  readonly named: readonly (readonly [string, string])[];
  /** Number of tries before them, from 1. That of a variant is one more than its index. */
  readonly at: number;
}

/** The next variant of a task after a number of tries, from 1; null where none is left. */
export function nextVariant({ start, variants = [] }: Task, tries: number): OtherNumbers | null {
  const next = variants[tries - 1];
  if (!next || !("program" in start)) return null;
  return { lines: withLines(start.program, next.with), named: Object.entries(next.numbers), at: tries };
}

const plainNumber = (text: string): string => String(Math.abs(Number(text)));
/** Numbers in words, with point or comma. */
const NUMBER = /(?<![\d.,])\d+(?:[.,]\d+)?(?!\d|[.,]\d)/g;
/** A certain number in words, with point or comma. */
const inWords = (plain: string) => new RegExp(String.raw`(?<![\d.,])${plain.replace(".", "([.,])")}(?!\d|[.,]\d)`, "g");

/** What the assignment and some questions say, in all languages. */
const saidBy = ({ words }: Task, questions: readonly number[]): string =>
  Object.values(words)
    .flatMap((each) =>
      each ? [each.ask, ...questions.flatMap((i) => [each.questions?.[i] ?? "", ...(each.choices?.[i] ?? [])])] : [],
    )
    .join("\n");

/** Whether words only have numbers of the program: a count or a sum of them would become wrong with other ones. */
function namesOnlyNumbersOf(said: string, lines: readonly string[], asked: readonly Prediction[]): boolean {
  const measured = asked.flatMap((each) => ("at" in each ? [plainNumber(String(each.at))] : []));
  const known = new Set([
    ...[...lines.join("\n").matchAll(/\d+(?:\.\d+)?/g)].map(([text]) => plainNumber(text)),
    ...measured,
  ]);
  const named = [...said.replaceAll(/(?<=\d),(?=\d)/g, ".").matchAll(/\d+(?:\.\d+)?/g)];
  return named.every(([text]) => known.has(plainNumber(text)));
}

/** The numbers of a program that can be changed: not whole ones that its words name, for those are found twice. */
function freeValues(said: string, lines: readonly string[]): readonly Value[] {
  const isFree = (text: string) => Number(text) !== 0 && (text.includes(".") || !inWords(plainNumber(text)).test(said));
  const program = parse(programOfLines(lines)),
    starts = startLines(program),
    numbers = blockNumbers(program);
  return lines.flatMap((whole, line) => {
    const raw = whole.replace(/;.*/, "");
    if (/BLK\s+FORM|TOOL\s+CALL|FUNCTION|\bM30\b/i.test(raw)) return [];
    const block = numbers[starts.findLastIndex((start) => start <= line + 1)] ?? 0;
    return [...raw.matchAll(VALUE)].flatMap(({ groups, index }): Value[] => {
      const { front = "", number: text = "" } = groups ?? {};
      return isFree(text) ? [{ line, index: index + front.length, text, block }] : [];
    });
  });
}

const withText = (lines: readonly string[], { line, index, text }: Value, to: string): readonly string[] =>
  lines.with(line, (lines[line] ?? "").slice(0, index) + to + (lines[line] ?? "").slice(index + text.length));

/** A number changed by a share, with at most one decimal and its sign. */
function changedText(text: string, by: number): string {
  const value = Number(text);
  const to = Math.round(Math.abs(value) * by * 10) / 10;
  return `${/^[+-]/.exec(text)?.[0] ?? ""}${to}`;
}

/** Whether a program runs as the original does: the same findings, none more. */
const runsAs = (answer: Answer, original: Answer): boolean => {
  const codes = ({ run, simulation }: Answer) => [
    ...run.issues.map(({ issue }) => issue.code),
    ...simulation.findings.map(({ kind }) => kind),
  ];
  const known = new Set(codes(original));
  return codes(answer).every((code) => known.has(code));
};

/** Whether the answer to a question can be asked for with other numbers. */
const hasOtherNumbers = (prediction: Prediction): boolean => {
  const kind = answerKindOf(prediction);
  return kind === "number" || kind === "place";
};

/**
 * The program of a task of predictions with other numbers, so that the right answers to some questions are others than
 * before; null where the task does not allow it. `questions`: their indices; `tries`: number of tries, from 1.
 */
export async function varyNumbers(
  task: Task,
  questions: readonly number[],
  tries: number,
  runOf: (text: string) => Promise<Answer | null>,
): Promise<OtherNumbers | null> {
  const { start, predict = [], kind } = task;
  const asked = questions.flatMap((i) => predict[i] ?? []);
  if (kind !== "predict" || !("program" in start) || asked.length === 0) return null;
  const variant = nextVariant(task, tries);
  if (variant) return variant;
  if (!asked.every(hasOtherNumbers)) return null;
  const said = saidBy(task, questions);
  if (!namesOnlyNumbersOf(said, start.program, asked)) return null;
  const original = await runOf(programOfLines(start.program));
  if (!original) return null;
  let runs = 0;
  let lines: readonly string[] = start.program;
  const named: (readonly [string, string])[] = [];
  let now = original;
  for (const prediction of asked) {
    const before = truthOf(prediction, task, original);
    if (!isOther(prediction, before, truthOf(prediction, task, now))) {
      const deciding = decidingBlock(prediction, now);
      const values = freeValues(said, lines);
      const rank = ({ block, text }: Value) => {
        if (before.kind === "number" && Math.abs(Number(text)) === Math.abs(before.value ?? 0)) return 0;
        return block === deciding ? 1 : 2;
      };
      const trials = values
        .toSorted((a, b) => rank(a) - rank(b))
        .flatMap((value) => CHANGES.map((_, i) => ({ value, by: CHANGES[(i + tries - 1) % CHANGES.length] ?? 1 })));
      const found = await firstOther(trials);
      if (!found) return null;
      [lines, now] = [found.lines, found.answer];
      named.push([plainNumber(found.from), plainNumber(found.to)]);
    }

    async function firstOther(trials: readonly { readonly value: Value; readonly by: number }[]) {
      for (const { value, by } of trials) {
        const to = changedText(value.text, by);
        if (Number(to) === Number(value.text) || runs >= MOST_RUNS) continue;
        const changed = withText(lines, value, to);
        runs += 1;
        const answer = await runOf(programOfLines(changed));
        if (!answer || !runsAs(answer, original as Answer)) continue;
        if (isOther(prediction, before, truthOf(prediction, task, answer)))
          return { lines: changed, answer, from: value.text, to };
      }
      return null;
    }
  }
  const areOther = asked.every((each) => isOther(each, truthOf(each, task, original), truthOf(each, task, now)));
  return areOther ? { lines, named, at: tries } : null;
}

/** Whether the answer of a changed program exists, and is not the known one. */
function isOther(prediction: Prediction, before: Truth, now: Truth): boolean {
  if (now.kind === "number") return now.value !== null && !isRight(prediction, before, now.value);
  if (now.kind === "place") return now.place !== null && !isRight(prediction, before, now.place);
  return false;
}

/** Where the program of a task has other numbers: numbers of blocks, and names of parameters. */
export const changedPlaces = ({ start }: Task, { lines }: OtherNumbers): readonly string[] => [
  ...new Set(
    lines.flatMap((line, i) => {
      const isSame = "program" in start && start.program[i] === line;
      return isSame ? [] : (/^\s*(\d+(?= )|Q\d+(?==))/.exec(line)?.[1] ?? []);
    }),
  ),
];

/** Texts with those of a variant in their place. */
const replaced = <T>(texts: readonly T[], others: Readonly<Record<string, T>> = {}): T[] =>
  texts.map((text, i) => others[i] ?? text);

/** A task with other numbers in its program, its assignment and its questions; hints keep the original ones. */
export function withNumbers(task: Task, other: OtherNumbers | undefined): Task {
  if (!other) return task;
  const to = new Map(other.named);
  const variant: TaskVariant | undefined = task.variants?.[other.at - 1];
  /** Signs within a program keep their point; a whole number has the sign of the language. */
  const changed = (text: string, language: Language) =>
    text.replaceAll(NUMBER, (found) => {
      const point = /[.,]/.exec(found)?.[0] ?? decimalSign(language);
      return to.get(found.replace(",", "."))?.replace(".", point) ?? found;
    });
  const words = Object.fromEntries(
    (Object.keys(task.words) as LessonLanguage[]).map((language) => {
      const each = task.words[language],
        others = variant?.words?.[language];
      const change = (text: string) => changed(text, language);
      return [
        language,
        each && {
          ...each,
          ask: others?.ask ?? change(each.ask),
          ...(each.questions && { questions: replaced(each.questions.map(change), others?.questions) }),
          ...(each.choices && {
            choices: replaced(
              each.choices.map((list) => list.map(change)),
              others?.choices,
            ),
          }),
        },
      ];
    }),
  );
  const predict = task.predict?.map((each, i) => {
    const right = variant?.right[i];
    if (right === undefined) return each;
    if (each.ask === "block") return { ...each, right: [right] };
    return each.ask === "choice" ? { ...each, right } : each;
  });
  return { ...task, start: { program: [...other.lines] }, words, ...(predict && { predict }) };
}

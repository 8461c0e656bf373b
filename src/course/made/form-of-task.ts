import { LESSON_LANGUAGES, type LessonLanguage } from "../../i18n/languages.ts";
import type { Answer } from "../judge/judgement.ts";
import { promptsText } from "../prompts.ts";
import { programOfLines } from "../task-start.ts";
import type { Task, TaskWords } from "../task.ts";
import type { InLanguages } from "../words.ts";
import { NUMBER_RULES, type TaskForm, type RuleDraft, type SizeDraft, type WordsDraft } from "./task-form.ts";
import { promptsOf, proposedTask, taskOfForm, type FormFault } from "./task-from-form.ts";
import { draftOfPrediction } from "./made-questions.ts";

/* Fills the form from a stored or imported task. Fields that the form does not show are preserved. */

/** The program behind a task: its answer, else its starting program; null where it has neither. */
export function textOfTask(task: Task): string | null {
  if (task.solution) return programOfLines(task.solution);
  return "program" in task.start ? programOfLines(task.start.program) : promptsText(task);
}

/** The starting state in the fields of the form. */
function startDraft(
  { start }: Task,
  text: string,
  answer: Answer,
): Pick<TaskForm, "start" | "prompts" | "program" | "faults"> {
  const none = { prompts: { operation: 0, emptied: [] }, program: null, faults: [] };
  if ("program" in start)
    return {
      ...none,
      start: "program",
      program: programOfLines(start.program) === text ? null : start.program.join("\n"),
    };
  if (!("cycle" in start)) return { ...none, start: "empty" };
  const operation = answer.run.operations.findIndex(({ cycle }) => cycle === start.cycle);
  if (operation < 0) return { ...none, start: "empty" };
  const emptied = promptsOf(answer, operation)
    .map(([q]) => q)
    .filter((q) => !(q in start.values));
  return { ...none, start: "prompts", prompts: { operation, emptied } };
}

/** Whether two sizes are measured at the same place, whatever their deviations. */
export const isSameSize = (a: SizeDraft, b: SizeDraft): boolean =>
  a.kind === b.kind && a.at === b.at && a.nominal === b.nominal;

/** The enabled sizes of a task, then the other sizes that its part offers. */
export const sizesOfBoth = (chosen: readonly SizeDraft[], offered: readonly SizeDraft[]): readonly SizeDraft[] => {
  const on = chosen.filter((size) => size.on);
  return [
    ...on.filter((size) => !offered.some((each) => isSameSize(each, size))),
    ...offered.map((each) => on.find((size) => isSameSize(size, each)) ?? each),
  ];
};

/** Texts as typed; an absent hint is empty. */
const wordsDraft = (said: TaskWords | undefined): WordsDraft => {
  const [one = "", two = "", three = ""] = said?.hints ?? [];
  return { title: said?.title ?? "", ask: said?.ask ?? "", hints: [one, two, three] };
};

/** The form of a task. `text` and `answer` belong to the program behind the task. */
export function formOfTask(task: Task, text: string, answer: Answer, language: LessonLanguage): TaskForm {
  const proposed = proposedTask(answer),
    { part, rules, predict = [], words: told } = task,
    words = told[language];
  const lines = (found: readonly string[] | undefined) => found?.join("\n") ?? "";
  const others = <T>(draft: (said: TaskWords) => T): InLanguages<T> =>
    Object.fromEntries(
      LESSON_LANGUAGES.flatMap((other) => {
        const said = told[other];
        return other === language || !said ? [] : [[other, draft(said)]];
      }),
    );
  const rule = (name: (typeof NUMBER_RULES)[number]): RuleDraft => {
    const value = name === "rz" ? rules.rz?.[0]?.most : rules[name];
    return value === undefined ? { ...proposed.rules[name], on: false } : { on: true, text: String(value) };
  };
  const asked = part?.threads ?? [];
  return {
    ...proposed,
    kind: task.kind,
    ...(task.kind !== "predict" && {
      blank: lines(part?.blank),
      outside: lines(part?.outside),
      bore: lines(part?.bore),
      threads: asked.map((thread) => ({ ...thread, pitch: thread.pitch ?? 0, on: true })),
    }),
    material: task.material ?? null,
    sizes: (task.sizes ?? []).map((size) => ({
      ...size,
      on: true,
      upper: String(size.upper),
      lower: String(size.lower),
    })),
    rules: {
      ...proposed.rules,
      ...Object.fromEntries(NUMBER_RULES.map((name) => [name, rule(name)])),
      cycles: rules.cycles ? { on: true, text: rules.cycles.join(", ") } : { ...proposed.rules.cycles, on: false },
    },
    offer: rules.tools ? "listed" : "all",
    tools: rules.tools ?? proposed.tools,
    clean: rules.clean ?? false,
    questions: predict.map((prediction, i) => ({
      ...draftOfPrediction(prediction, words?.questions?.[i] ?? "", words?.choices?.[i] ?? []),
      translations: others((each) => ({
        text: each.questions?.[i] ?? "",
        choices: (each.choices?.[i] ?? []).join("\n"),
      })),
    })),
    ...startDraft(task, text, answer),
    words: wordsDraft(words),
    translations: others(wordsDraft),
  };
}

const isSame = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

/** Takes the fields that were changed in the form from `made`, all others from `base`. */
function changedOf<T extends object>(base: T, first: T, made: T): T {
  const out = { ...base } as Record<string, unknown>;
  for (const key of new Set([...Object.keys(first), ...Object.keys(made)])) {
    const [was, is] = [(first as Record<string, unknown>)[key], (made as Record<string, unknown>)[key]];
    if (isSame(was, is)) continue;
    if (is === undefined) delete out[key];
    else out[key] = is;
  }
  return out as T;
}

/**
 * A task as changed in the form, with the same id, so that returned results still match. An unchanged form leaves every
 * field in every language as it was.
 */
export function editedTask(
  base: Task,
  made: TaskForm,
  answer: Answer,
  language: LessonLanguage,
): Task | readonly FormFault[] {
  const text = textOfTask(base);
  const first = text === null ? null : formOfTask(base, text, answer, language);
  const now = taskOfForm(
    { ...made, translations: made.translations ?? first?.translations },
    answer,
    language,
    "edited",
  );
  if ("length" in now || !first) return now;
  const begun = taskOfForm(first, answer, language, "edited");
  if ("length" in begun) return { ...now, id: base.id };
  const words = Object.fromEntries(
    LESSON_LANGUAGES.flatMap((each) => {
      const said = now.words[each];
      return said ? [[each, changedOf(base.words[each] ?? {}, begun.words[each] ?? {}, said)]] : [];
    }),
  ) as Task["words"];
  return { ...changedOf(base, begun, now), id: base.id, rules: changedOf(base.rules, begun.rules, now.rules), words };
}

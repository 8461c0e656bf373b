import { LESSON_LANGUAGES, type LessonLanguage } from "../../i18n/languages.ts";
import type { Task } from "../task.ts";
import { choicesOf } from "./made-questions.ts";
import type { QuestionDraft } from "./question-draft.ts";
import type { TaskForm, WordsDraft } from "./task-form.ts";

/** The texts of a form in one language, without the hints that were left empty. */
function wordsIn({ title, ask, hints }: WordsDraft, asked: readonly Pick<QuestionDraft, "ask" | "text" | "choices">[]) {
  return {
    title: title.trim(),
    ask: ask.trim(),
    hints: hints.map((hint) => hint.trim()).filter((hint) => hint !== ""),
    ...(asked.length > 0 && {
      questions: asked.map(({ text }) => text.trim()),
      choices: asked.map((each) => (each.ask === "choice" ? [...choicesOf(each)] : [])),
    }),
  };
}

const isTyped = ({ title, ask, hints }: WordsDraft): boolean =>
  [title, ask, ...hints].some((each) => each.trim() !== "");

/**
 * The texts of a form in all its languages. What a translation lacks is in the first language; a translation of choices
 * counts if it has as many.
 */
export function wordsOfForm(
  { words, translations = {} }: TaskForm,
  asked: readonly QuestionDraft[],
  language: LessonLanguage,
): Task["words"] {
  const others = LESSON_LANGUAGES.flatMap((other) => {
    const draft = translations[other];
    if (other === language || !draft || !isTyped(draft)) return [];
    const questions = asked.map((each) => {
      const told = each.translations?.[other];
      const isWhole = told && choicesOf(told).length === choicesOf(each).length;
      return { ask: each.ask, text: told?.text.trim() || each.text, choices: isWhole ? told.choices : each.choices };
    });
    const whole = { ...draft, title: draft.title.trim() || words.title, ask: draft.ask.trim() || words.ask };
    return [[other, wordsIn(whole, questions)] as const];
  });
  return { ...Object.fromEntries(others), [language]: wordsIn(words, asked) };
}

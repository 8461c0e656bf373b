import { at, type Pt } from "../kernel/geometry/point.ts";
import { axial, diameter, toRadius } from "../kernel/units.ts";
import type { Answer } from "./judge/judgement.ts";
import { decidingBlock } from "./judge/deciding-block.ts";
import { isRight, truthOf, type PredictedAnswer, type Truth } from "./judge/predicting.ts";
import type { Prediction, Task } from "./task.ts";

/** The kind of answer to a question. */
export type AnswerKind = "number" | "place" | "choice" | "block";

export function answerKindOf({ ask }: Prediction): AnswerKind {
  if (ask === "choice" || ask === "block") return ask;
  return ask.endsWith("Place") ? "place" : "number";
}

/** A typed number with point or comma; null where the text is no number. */
export function typedNumber(text: string): number | null {
  const plain = text.trim().replace(",", ".").replace("−", "-");
  return /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)$/.test(plain) ? Number(plain) : null;
}

/** A typed place: ⌀ and Z separated by a space; null where one is no number. Below the axis is the same place. */
export function typedPlace(text: string): Pt | null {
  const [x = null, z = null] = text.split(" ").map(typedNumber);
  return x === null || z === null ? null : at(axial(z), toRadius(diameter(Math.abs(x))));
}

/** The prediction in a text; null where the text has none. */
export const parsePredictedAnswer = (prediction: Prediction, text: string): PredictedAnswer | null =>
  answerKindOf(prediction) === "place" ? typedPlace(text) : typedNumber(text);

/** A prediction with the right answer. */
export interface ComparedAnswer {
  readonly prediction: Prediction;
  readonly predicted: PredictedAnswer | null;
  readonly truth: Truth;
  readonly right: boolean;
  /** The block that decides the answer; null where none alone does. */
  readonly block: number | null;
  /** Answered correctly before the numbers of the program were changed. */
  readonly isKept: boolean;
}

/** Whether every question of a task is answered correctly. */
export const areAllRight = ({ predict = [] }: Task, answers: readonly ComparedAnswer[] | null): boolean =>
  predict.every((_, i) => answers?.[i]?.right === true);

/**
 * Compares a learner's predictions, as typed, with the run of the program in question. `asked`: the questions that were
 * asked again; the others are answered.
 */
export const comparePredictedAnswers = (
  task: Task,
  texts: readonly string[],
  answer: Answer,
  asked?: readonly number[],
): readonly ComparedAnswer[] =>
  (task.predict ?? []).map((prediction, i) => {
    const predicted = parsePredictedAnswer(prediction, texts[i] ?? "");
    const truth = truthOf(prediction, task, answer);
    const isKept = asked?.includes(i) === false;
    const right = isKept || (predicted !== null && isRight(prediction, truth, predicted));
    return { prediction, predicted, truth, right, block: decidingBlock(prediction, answer), isKept };
  });

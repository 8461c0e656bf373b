import { at, type Pt } from "../kernel/geometry/point.ts";
import { axial, diameter, toRadius } from "../kernel/units.ts";
import type { Answer } from "./judge/judgement.ts";
import { isRight, truthOf, type Foretold, type Truth } from "./judge/predicting.ts";
import type { Prediction, Task } from "./task.ts";

/** What kind of answer a question wants. */
export type AnswerKind = "number" | "place" | "choice" | "block";

export function answerKindOf({ ask }: Prediction): AnswerKind {
  if (ask === "choice" || ask === "block") return ask;
  return ask.endsWith("Place") ? "place" : "number";
}

/** A typed number with point or comma; null where it is none. */
export function typedNumber(text: string): number | null {
  const plain = text.trim().replace(",", ".").replace("−", "-");
  return /^[+-]?(?:\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
}

/** A typed place: ⌀ and Z with a blank between; null where one of them is none. Below the axis is the same place. */
export function typedPlace(text: string): Pt | null {
  const [x = null, z = null] = text.split(" ").map(typedNumber);
  return x === null || z === null ? null : at(axial(z), toRadius(diameter(Math.abs(x))));
}

/** What a text says to a question; null where it says nothing. */
export const toldBy = (prediction: Prediction, text: string): Foretold | null =>
  answerKindOf(prediction) === "place" ? typedPlace(text) : typedNumber(text);

/** What was told beside what is so. */
export interface ComparedAnswer {
  readonly prediction: Prediction;
  readonly told: Foretold | null;
  readonly truth: Truth;
  readonly right: boolean;
}

/** Holds the answers of a learner, as typed, to the run of the program that the questions are about. */
export const compareTold = (task: Task, texts: readonly string[], answer: Answer): readonly ComparedAnswer[] =>
  (task.predict ?? []).map((prediction, i) => {
    const told = toldBy(prediction, texts[i] ?? "");
    const truth = truthOf(prediction, task, answer);
    return { prediction, told, truth, right: told !== null && isRight(prediction, truth, told) };
  });

import type { PageQuestion } from "../lesson.ts";
import { parsePredictedAnswer } from "../predicted-answers.ts";
import type { Answer } from "./judgement.ts";
import { isRight, truthOf } from "./predicting.ts";

/** Result of an answer to a question on a page. */
export interface JudgedAnswer {
  readonly right: boolean;
  /** The reason to show, as an index of `why`. */
  readonly why: number;
  /** The answer is half or twice the right one: a radius and a diameter were confused. */
  readonly slip: "half" | "twice" | null;
}

/** Answers that are lengths across the axis, or counted from it. */
const ACROSS: readonly string[] = ["diameter", "bore", "infeed"];

/** Judges an answer, as typed, by the run of the question's program; null if the text is no answer. */
export function judgePageAnswer({ asks }: PageQuestion, text: string, answer: Answer): JudgedAnswer | null {
  const said = parsePredictedAnswer(asks, text);
  if (said === null) return null;
  const truth = truthOf(asks, {}, answer);
  const right = isRight(asks, truth, said);
  const isTimes = (factor: number) =>
    !right && typeof said === "number" && ACROSS.includes(asks.ask) && isRight(asks, truth, said * factor);
  const slip = isTimes(2) ? "half" : isTimes(0.5) ? "twice" : null;
  return { right, why: asks.ask === "choice" ? Number(said) : Number(!right), slip };
}

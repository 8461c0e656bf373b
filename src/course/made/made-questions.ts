import { parse } from "../../nc/parse.ts";
import { blockNumbers } from "../../nc/program.ts";
import type { Answer } from "../judge/judgement.ts";
import { truthOf, type Truth } from "../judge/predicting.ts";
import type { Task, TaskPrediction } from "../task.ts";
import { typedNumber } from "../predicted-answers.ts";
import type { AskedKind, QuestionDraft } from "./question-draft.ts";

/*
 * The questions before the run, as an instructor types them. The right answers come from the run of the starting
 * program, except for a choice and a block: there the run only proposes them.
 */

const SIZES: readonly AskedKind[] = ["diameter", "bore", "face"];
const PLACES: readonly AskedKind[] = ["residuePlace", "gougePlace", "rapidPlace"];
const COUNTED: readonly AskedKind[] = ["passes", "infeed", "seconds", "residue"];

/** Which fields a question has. */
export const hasAt = (ask: AskedKind): boolean => SIZES.includes(ask);
export const hasOperation = (ask: AskedKind): boolean => COUNTED.includes(ask);
export const hasWithin = (ask: AskedKind): boolean => ask !== "choice" && ask !== "block";
export const needsWithin = (ask: AskedKind): boolean => ask === "seconds" || ask === "residue" || PLACES.includes(ask);

/** The choices of a question, without empty lines. */
export const choicesOf = ({ choices }: Pick<QuestionDraft, "choices">): readonly string[] =>
  choices
    .split(/\r?\n/)
    .map((line) => line.trim())
    .filter((line) => line !== "");

const blocksIn = (text: string): readonly number[] => [...text.matchAll(/\d+/g)].map(([number]) => Number(number));

/**
 * The question of a draft; null where a number is missing or wrong, a choice has less than two options, or no block is
 * right.
 */
export function predictionOf(draft: QuestionDraft): TaskPrediction | null {
  const { ask, operation, at, within: typed, right } = draft;
  const within = typedNumber(typed);
  if (hasWithin(ask) && (typed.trim() === "" ? needsWithin(ask) : within === null || within < 0)) return null;
  const so = within === null ? {} : { within };
  switch (ask) {
    case "passes":
    case "infeed":
    case "seconds":
    case "residue":
      return { ask, ...(operation !== null && { operation }), ...so };
    case "diameter":
    case "bore":
    case "face": {
      const where = typedNumber(at);
      return where === null ? null : { ask, at: where, ...so };
    }
    case "residuePlace":
    case "gougePlace":
    case "rapidPlace":
      return within === null ? null : { ask, within };
    case "choice": {
      const index = Number(right);
      return choicesOf(draft).length > 1 && right !== "" && index < choicesOf(draft).length
        ? { ask, right: index }
        : null;
    }
    case "block": {
      const blocks = blocksIn(right);
      return blocks.length > 0 ? { ask, right: [...blocks] } : null;
    }
  }
}

/** Whether a question is complete. */
export const isComplete = (draft: QuestionDraft): boolean => draft.text.trim() !== "" && predictionOf(draft) !== null;

/** The draft of a task's question. */
export function draftOfPrediction(prediction: TaskPrediction, text: string, choices: readonly string[]): QuestionDraft {
  const { ask } = prediction;
  const right =
    ask === "choice" ? String(prediction.right ?? "") : ask === "block" ? (prediction.right?.join(", ") ?? "") : "";
  return {
    ask,
    text,
    operation: "operation" in prediction ? (prediction.operation ?? null) : null,
    at: "at" in prediction ? String(prediction.at) : "",
    within: "within" in prediction && prediction.within !== undefined ? String(prediction.within) : "",
    choices: choices.join("\n"),
    right,
  };
}

/** The outcomes of a run, in the order of the choices. */
export const RUN_OUTCOMES = ["fine", "rapid", "gouge", "residue", "error"] as const;
export type RunOutcome = (typeof RUN_OUTCOMES)[number];

/** The gravest outcome of a run. */
export function outcomeOfRun({ run, simulation: { findings, proof } }: Answer): RunOutcome {
  if (findings.some(({ kind }) => kind !== "gouge")) return "rapid";
  if (findings.length > 0) return "gouge";
  if (run.issues.some(({ issue }) => issue.severity === "error")) return "error";
  return proof.residual.length > 0 ? "residue" : "fine";
}

const bare = (raw: string): string => raw.trim().replace(/^\/?\d+[ \t]+/, "");

/** Numbers of the blocks in which two programs differ; for a missing block, those of its neighbours. */
export function changedBlocks(text: string, from: string): readonly number[] {
  const program = parse(text),
    numbers = blockNumbers(program);
  const [now, was] = [program.blocks, parse(from).blocks].map((blocks) => blocks.map(({ raw }) => bare(raw))) as [
    string[],
    string[],
  ];
  const numbered = (places: readonly number[]) => places.flatMap((place) => numbers[place] ?? []);
  if (now.length === was.length) return numbered(now.flatMap((raw, i) => (raw === was[i] ? [] : [i])));
  const first = now.findIndex((raw, i) => raw !== was[i]);
  return first < 0 ? [] : numbered([Math.max(0, first - 1), first]);
}

/** The blocks at fault: those that differ from the answer, else those with findings in the run. */
function faultyBlocks(begun: Answer, solution: string): readonly number[] {
  const changed = changedBlocks(begun.text, solution);
  if (changed.length > 0) return changed;
  const errors = begun.run.issues.flatMap(({ issue, block }) =>
    issue.severity === "error" && block !== null ? [block] : [],
  );
  const found = [...begun.simulation.findings.map(({ block }) => block), ...errors];
  return [...new Set(found)].slice(0, 3);
}

/** Proposed tolerances: shares of the value, and mm for a place. */
const SHARE = { seconds: 0.1, residue: 0.2 } as const,
  PLACE = "3",
  INFEED = "0.02",
  SIZE = "0.05";

function proposedWithin(ask: AskedKind, truth: Truth | null): string {
  if (PLACES.includes(ask)) return PLACE;
  if (SIZES.includes(ask)) return SIZE;
  if (ask === "infeed") return INFEED;
  if (ask !== "seconds" && ask !== "residue") return "";
  const value = truth?.kind === "number" ? (truth.value ?? 0) : 0;
  return String(Math.max(1, Math.ceil(value * SHARE[ask])));
}

/**
 * A question with the values that the run proposes. `begun`: the starting program, `solution`: the text of the answer,
 * `at`: the place of a size.
 */
export function proposedQuestion(
  ask: AskedKind,
  begun: Answer,
  {
    solution,
    at,
    fates,
  }: { readonly solution: string; readonly at: string; readonly fates: Readonly<Record<RunOutcome, string>> },
): QuestionDraft {
  const counted = hasOperation(ask) ? truthOf({ ask } as TaskPrediction, {}, begun) : null;
  return {
    ask,
    text: "",
    operation: null,
    at: hasAt(ask) ? at : "",
    within: proposedWithin(ask, counted),
    choices: ask === "choice" ? RUN_OUTCOMES.map((fate) => fates[fate]).join("\n") : "",
    right:
      ask === "choice"
        ? String(RUN_OUTCOMES.indexOf(outcomeOfRun(begun)))
        : ask === "block"
          ? faultyBlocks(begun, solution).join(", ")
          : "",
  };
}

/** Whether a run contains what a question asks for. */
export function hasAnswerInRun(truth: Truth, { text }: Answer): boolean {
  switch (truth.kind) {
    case "number":
      return truth.value !== null;
    case "place":
      return truth.rings.length > 0;
    case "choice":
      return true;
    case "block": {
      const numbers = new Set(blockNumbers(parse(text)));
      return truth.right.every((block) => numbers.has(block));
    }
  }
}

/** The right answer to each question; null where a question is not complete. */
export const truthsOf = (
  questions: readonly QuestionDraft[],
  part: Pick<Task, "part">,
  begun: Answer,
): readonly (Truth | null)[] =>
  questions.map((draft) => {
    const prediction = predictionOf(draft);
    return prediction && truthOf(prediction, part, begun);
  });

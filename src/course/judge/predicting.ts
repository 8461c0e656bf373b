import { producedParts } from "../../sim/produced-parts.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { ROUND } from "../../kernel/tolerance.ts";
import type { Prediction, Task } from "../task.ts";
import { targetPart } from "../target-part.ts";
import { regionsOf } from "../../sim/region.ts";
import { areaBeyond, distanceTo } from "./difference.ts";
import { middleOf } from "./middle.ts";
import type { Answer } from "./judgement.ts";
import { roughingPasses, hasRoughing } from "./rules.ts";
import { elementShapedBy } from "./shaped-by.ts";
import { secondsOfAnswer } from "./shop.ts";
import { sizeOn } from "./sizes.ts";

/** mm, mm², s, or a count; null where the run has no such value. */
export interface TrueNumber {
  readonly kind: "number";
  readonly value: number | null;
}
/** The place of something; `rings` is empty where the run has no such place. */
export interface TruePlace {
  readonly kind: "place";
  readonly place: Pt | null;
  readonly rings: readonly Ring[];
}
export interface TrueChoice {
  readonly kind: "choice";
  /** −1 where the task does not say. */
  readonly right: number;
}
export interface TrueBlock {
  readonly kind: "block";
  readonly right: readonly number[];
}
/** The right answer to a question, from the run. */
export type Truth = TrueNumber | TruePlace | TrueChoice | TrueBlock;

/** A learner's prediction: a number, a place on the part, a choice from 0, or the number of a block. */
export type PredictedAnswer = number | Pt;

/** Points of an element by which a press is near it. */
const POINTS = 9;
/** Sizes and infeeds are read to two decimals, mm; counts are whole. */
const READ_OFF = 0.005;

const number = (value: number | null | undefined): Truth => ({ kind: "number", value: value ?? null });
const placeOf = (rings: readonly Ring[]): Truth => {
  const first = regionsOf(rings, 0).toSorted((a, b) => b.area - a.area)[0];
  return { kind: "place", rings, place: first ? middleOf([first.outline, ...first.holes]) : null };
};

/** A place on elements of a contour: the middle of the longest one. */
function placeOn(elements: readonly Segment[]): Truth {
  const [longest] = elements.toSorted((a, b) => part.lengthOf(b) - part.lengthOf(a));
  return {
    kind: "place",
    place: longest ? part.pointOn(longest, 1 / 2) : null,
    rings: elements.map((each) => Array.from({ length: POINTS }, (_, i) => part.pointOn(each, i / (POINTS - 1)))),
  };
}

/** Excess material on the target part; without one, the material that the operations should have cut. */
function residue({ part: wanted }: Pick<Task, "part">, { simulation }: Answer, operation?: number): readonly Ring[] {
  if (wanted && operation === undefined) return areaBeyond(producedParts(simulation), targetPart(wanted).rings);
  return simulation.proof.residual
    .filter((r) => operation === undefined || r.operation === operation)
    .map((r) => r.ring);
}

/** Material missing from the target part; without one, the cuts into the contours of the cycles. */
function missing({ part: wanted }: Pick<Task, "part">, { simulation }: Answer): readonly Ring[] {
  if (wanted) return areaBeyond(targetPart(wanted).solid, producedParts(simulation));
  return simulation.findings.flatMap((f) => (f.kind === "gouge" ? f.rings : []));
}

/** The right answer to a question, from the run of the program in question. */
export function truthOf(prediction: Prediction, task: Pick<Task, "part">, answer: Answer): Truth {
  const { run, simulation } = answer;
  const only = "operation" in prediction ? prediction.operation : undefined;
  const called = run.operations.filter((_, i) => only === undefined || i === only);
  switch (prediction.ask) {
    case "passes":
      return number(called.length === 0 ? null : called.reduce((sum, o) => sum + roughingPasses(o), 0));
    case "infeed": {
      const infeeds = called.filter(hasRoughing).map((o) => o.plan.infeed);
      return number(infeeds.length === 0 ? null : Math.max(...infeeds));
    }
    case "seconds":
      return number(only === undefined ? secondsOfAnswer(answer) : called[0]?.seconds);
    case "residue":
      return number(areaOf(residue(task, answer, only)));
    case "diameter":
    case "bore":
    case "face":
      return number(sizeOn(producedParts(simulation), prediction.ask, prediction.at)?.value);
    case "residuePlace":
      return placeOf(residue(task, answer));
    case "gougePlace":
      return placeOf(missing(task, answer));
    case "elementPlace":
      return placeOn(elementShapedBy(answer, prediction.q));
    case "rapidPlace": {
      const [first] = simulation.findings.filter((f) => f.kind === "rapidInStock").toSorted((a, b) => a.step - b.step);
      return first ? { kind: "place", place: first.place, rings: first.rings } : placeOf([]);
    }
    case "choice":
      return { kind: "choice", right: prediction.right ?? -1 };
    case "block":
      return { kind: "block", right: prediction.right ?? [] };
  }
}

/** Tolerance of a number or a place. */
const withinOf = (prediction: Prediction): number =>
  ("within" in prediction ? prediction.within : undefined) ?? (prediction.ask === "passes" ? 0 : READ_OFF);

/** Whether a prediction is right. A place is right inside the region or within the tolerance of it. */
export function isRight(prediction: Prediction, truth: Truth, said: PredictedAnswer): boolean {
  if (typeof said === "object") {
    const within = withinOf(prediction);
    if (truth.kind !== "place" || truth.rings.length === 0) return false;
    return (truth.place !== null && part.apart(truth.place, said) <= within) || distanceTo(truth.rings, said) <= within;
  }
  switch (truth.kind) {
    case "number":
      return truth.value !== null && Math.abs(said - truth.value) <= withinOf(prediction) + ROUND;
    case "choice":
      return said === truth.right;
    case "block":
      return truth.right.includes(said);
    case "place":
      return false;
  }
}

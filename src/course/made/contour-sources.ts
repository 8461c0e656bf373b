import { part, type Segment } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Answer } from "../judge/judgement.ts";

/** Cuts outside cycles along an axis: the tip itself makes the surface. */
const straightCuts = ({ run }: Answer): readonly Segment[] =>
  run.steps.flatMap(({ from, move, operation }) =>
    operation === null &&
    move.kind === "feed" &&
    (Math.abs(from.r - move.to.r) < SAME || Math.abs(from.z - move.to.z) < SAME)
      ? [part.line(from, move.to)]
      : [],
  );

/** The elements that the surfaces of a part come from: the programmed contours, except of threads, and straight cuts. */
export const contourSources = (answer: Answer): readonly Segment[] => [
  ...answer.run.operations.flatMap(({ plan: { contour, thread } }) => (thread ? [] : contour)),
  ...straightCuts(answer),
];

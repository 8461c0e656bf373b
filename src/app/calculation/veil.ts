import type { Outcome } from "./outcome.ts";

/** The part of a result that may be seen before a prediction: blank and contours, but no run. */
export function veil({ run, simulation, ...made }: Outcome): Outcome {
  const operations = run.operations.map((operation) => ({
    ...operation,
    plan: { ...operation.plan, moves: [], passes: 0 },
    seconds: 0,
    firstStep: 0,
    lastStep: -1,
    issues: [],
  }));
  const nothing = {
    steps: [],
    stepBlocks: [],
    plane: [],
    approaches: [],
    unproved: [],
    issues: [],
    spindles: [],
    stated: [],
    seconds: 0,
  };
  return {
    ...made,
    run: { ...run, ...nothing, operations },
    simulation: {
      ...simulation,
      steps: [],
      checkpoints: simulation.checkpoints.slice(0, 1),
      final: run.blank,
      startTimes: new Float64Array(1),
      totalSeconds: 0,
      findings: [],
      proof: {
        ...simulation.proof,
        gouge: 0,
        rapidInStock: 0,
        residual: [],
        cut: 0,
        airPasses: 0,
        deepest: null,
        unproved: [],
        stated: [],
        operations: [],
      },
    },
  };
}

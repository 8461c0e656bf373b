import { expect, test } from "vitest";
import { answerOf } from "../../course/judge/answer.ts";
import { programOfLines } from "../../course/task-start.ts";
import { taskSchema } from "../../course/task.ts";
import { stockIssues } from "../../sim/issues.ts";
import { veil } from "./veil.ts";
import file from "../../course/tasks/l20-start-inside.json";

test("before a prediction nothing of the run is shown, but the contours are", () => {
  const task = taskSchema.parse(file);
  const whole = { version: 7, ...answerOf(programOfLines(task.solution ?? [])) };
  const { run, simulation, version } = veil(whole);
  expect(version).toBe(7);
  expect([
    run.steps.length,
    run.issues.length,
    run.seconds,
    simulation.findings.length,
    simulation.totalSeconds,
  ]).toEqual([0, 0, 0, 0, 0]);
  expect(run.operations.map(({ plan }) => [plan.moves.length, plan.passes])).toEqual(
    whole.run.operations.map(() => [0, 0]),
  );
  expect(run.operations.map(({ plan }) => plan.contour)).toEqual(whole.run.operations.map(({ plan }) => plan.contour));
  expect(run.blank).toEqual(whole.run.blank);
  expect(simulation.final).toEqual(whole.run.blank);
  expect(stockIssues(simulation)).toEqual([]);
});

import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run.ts";
import { shippedTools } from "../../program/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { tracing } from "../../sim/tracing.ts";
import type { Answer } from "./judgement.ts";

/** Rapid rate that times of a task are worked out with, mm/min. */
export const TASK_RAPID = 10_000;

/** Runs a program with the tools that every installation starts with, as a task is worked on. */
export function answerOf(text: string): Answer {
  const done = run(parse(text), { tools: shippedTools, rapid: TASK_RAPID, tracing });
  return { text, run: done, simulation: simulate(done) };
}

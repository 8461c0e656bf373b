import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { traceStock } from "../../sim/tracing.ts";
import type { Answer } from "./judgement.ts";
import { TASK_RAPID } from "./shop.ts";

/** Runs a program with the default tools, as a learner does in a task. */
export function answerOf(text: string): Answer {
  const done = run(parse(text), { tools: shippedTools, rapid: TASK_RAPID, tracing: traceStock });
  return { text, run: done, simulation: simulate(done) };
}

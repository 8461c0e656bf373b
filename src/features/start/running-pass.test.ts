import { expect, test } from "vitest";
import { examples } from "../../examples/index.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { runningPass } from "./running-pass.ts";

const made = run(parse(examples.find(({ id }) => id === "shaft")?.text ?? ""), { tools: shippedTools, rapid: 10_000 });
const [facing, roughing, finishing] = made.operations;
const stepIn = (operation: typeof facing, fits: (step: (typeof made.steps)[number]) => boolean) =>
  made.steps.findIndex((step, i) => i >= (operation?.firstStep ?? 0) && fits(step));

test.each([
  ["before the first cycle it is positioned for that cycle", 0, { cycle: facing?.cycle, pass: 0 }],
  [
    "a roughing cut is its pass",
    stepIn(roughing, ({ move }) => move.kind === "feed" && move.pass === 3),
    { cycle: roughing?.cycle, pass: 3, passes: roughing?.plan.passes },
  ],
  ["a rapid is no pass", stepIn(roughing, ({ move }) => move.kind === "rapid"), { cycle: roughing?.cycle, pass: 0 }],
  [
    "a finishing cut",
    stepIn(finishing, ({ move }) => move.kind === "feed" && move.run === "finish"),
    { cycle: finishing?.cycle, pass: -1 },
  ],
  ["after the last move the last cycle stands", made.steps.length, { cycle: made.operations.at(-1)?.cycle }],
])("%s", (_, step, expected) => expect(runningPass(made, step)).toMatchObject(expected));

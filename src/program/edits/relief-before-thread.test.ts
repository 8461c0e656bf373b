import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { playerOf } from "../../sim/stock.ts";
import { simulate } from "../../sim/simulate.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";
import { reliefsBeforeThread } from "./relief-before-thread.ts";

const shouldered = readFileSync("tests/cases/thread-flank-at-shoulder.h", "utf8").replace(/28 UDC THREAD PITCH2\n/, "");

/** The undercuts before the thread of a program. */
function reliefs(text: string) {
  const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
  const thread = made.operations.find(({ plan }) => plan.thread);
  if (!thread) throw new Error("no thread");
  const stock = playerOf(simulate(made)).at({ step: thread.firstStep, fraction: 0 });
  return reliefsBeforeThread(thread, stock).map(({ named, end }) => [named.name, Number(end.toFixed(2))]);
}

test.each([
  [
    "at a shoulder",
    shouldered,
    [
      ["DIN 76-A P2", -25.5],
      ["DIN 76-B P2", -27.5],
    ],
  ],
  ["far in front of it", shouldered.replace("Q494=-27.5", "Q494=-15"), []],
  ["of a pitch that DIN 76 does not list", shouldered.replace(/Q472=\S+/, "Q472=2.309"), []],
])("a thread that ends %s", (_, text, expected) => {
  expect(reliefs(text)).toEqual(expected);
});

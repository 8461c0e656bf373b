import { expect, test } from "vitest";
import { catalogue } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { withOperation } from "../../program/edits/added-operation.ts";
import { exampleJob } from "../../program/job/job.ts";
import { printJob } from "../../program/job/print-job.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { operationRequestAt } from "./operation-request.ts";
import { contourAt } from "./region.ts";
import { regionOfResidual } from "./residual-region.ts";

const shop = { tools: shippedTools, rapid: 10_000 };
const free = catalogue.filter((c) => c.contour === "free" && c.setup.contour.length > 3 && c.group === "transverse");
const labels = ncLabels("en");

test("residual material requests the contour section it lies on, in the present stock", () => {
  for (const cycle of free) {
    const made = run(parse(printJob({ ...exampleJob(cycle), tool: 1 }, labels)), shop);
    const { proof, final } = simulate(made);
    const [left] = proof.residual;
    const [operation] = made.operations;
    if (!left || !operation) throw new Error("nothing stays");
    const region = regionOfResidual(left, operation, final);
    const whole = contourAt(made, 0);
    expect(region?.initialStock).toBe("now");
    const sought = region && operationRequestAt(region);
    expect(sought?.rows.length).toBeGreaterThan(1);
    expect(sought?.rows.length).toBeLessThanOrEqual((whole && operationRequestAt(whole))?.rows.length ?? 0);
  }
  expect(free.length).toBeGreaterThan(0);
});

test("an operation added to a program runs after the others, with its own contour", () => {
  for (const cycle of free) {
    const first = printJob(exampleJob(cycle), labels);
    const both = print(withOperation(parse(first), { ...exampleJob(cycle), tool: 3 }, labels));
    const made = run(parse(both), shop);
    expect(made.operations.map((o) => o.tool.T)).toEqual([cycle.setup.tool, 3]);
    expect(made.operations[1]?.plan.contour).toEqual(made.operations[0]?.plan.contour);
    expect(both).toContain("LBL  1");
  }
});

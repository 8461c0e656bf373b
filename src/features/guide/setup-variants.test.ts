import { undoStep } from "../../app/document/history.ts";
import { expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { never } from "../../kernel/never.ts";
import { parse } from "../../nc/parse.ts";
import { exampleJob, type SetJob } from "../../program/job/job.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { printedText } from "../../app/document/printed.ts";
import { openFirstWork, useEditor } from "../../app/document/store.ts";
import { SETUP_PAGES, setupVariants, type SetupPageId } from "./setup-variants.ts";
import { applySetupValue } from "./apply-value.ts";

const example = exampleJob(cuttingCycles[0] ?? never("no cycle"));
const job: SetJob = {
  ...example,
  blank: { ...example.blank, outside: "83.7", bore: "0", allowance: "1.3" },
  spindle: { ...example.spindle, cuttingSpeed: "173", limit: "2370", speed: "770" },
};
const valuesOf = (id: SetupPageId) =>
  setupVariants(id, job, shippedTools).map(({ value, isUsual }) => (isUsual ? `[${value}]` : `${value}`));

test("a smaller and a larger value next to the present one", () => {
  expect(valuesOf("blank.outside")).toEqual(["77.7", "[83.7]", "103.7"]);
  expect(valuesOf("blank.bore")).toEqual(["[0]", "25.1", "50.2"]);
  expect(valuesOf("blank.allowance")).toEqual(["[1.3]", "3.3", "6.3"]);
  expect(valuesOf("spindle.limit")).toEqual(["948", "[2370]", "4740"]);
  expect(valuesOf("perRevolution")).toEqual(["[1]", "0"]);
});

test("a speed comes with its own mode of the spindle", () => {
  const modes = (id: SetupPageId) => setupVariants(id, job, shippedTools).map(({ job: { spindle } }) => spindle.mode);
  expect(new Set(modes("spindle.speed"))).toEqual(new Set(["constant"]));
  expect(new Set(modes("spindle.cuttingSpeed"))).toEqual(new Set(["surface"]));
});

test("tools are compared with two others of the same orientation, the smaller nose first", () => {
  const tools = setupVariants("tool", job, shippedTools).map(
    ({ value }) => shippedTools.find(({ T }) => T === value) ?? never("no tool"),
  );
  expect(tools).toHaveLength(3);
  expect(new Set(tools.map(({ TO }) => TO)).size).toBe(1);
  expect(tools.map(({ RS }) => RS)).toEqual(tools.map(({ RS }) => RS).toSorted((a, b) => a - b));
});

test("every page shows two values at least, and each makes another program or another time", () => {
  for (const id of SETUP_PAGES) {
    const made = setupVariants(id, job, shippedTools).map(({ job: other }) => {
      const { seconds, steps } = run(parse(printedText(other)), { tools: shippedTools, rapid: Number(other.rapid) });
      return `${printedText(other)} ${steps.length} ${seconds}`;
    });
    expect(made.length, id).toBeGreaterThan(1);
    expect(new Set(made).size, id).toBe(made.length);
  }
});

test("an applied value is the one its page showed, and one step of undo restores it with its spindle mode", () => {
  for (const id of SETUP_PAGES) {
    openFirstWork(job, "w");
    const other = setupVariants(id, job, shippedTools).find(({ isUsual }) => !isUsual) ?? never("one value only");
    applySetupValue(id, other.value, id, other.value);
    expect(useEditor.getState().job, id).toEqual(other.job);
    undoStep();
    expect(useEditor.getState().job, id).toEqual(job);
  }
});

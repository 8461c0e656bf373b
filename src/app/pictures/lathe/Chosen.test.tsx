import { cleanup, render } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { cycleByNumber } from "../../../cycles/index.ts";
import { parse } from "../../../nc/parse.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { pathRole, toolpath } from "../../../view/scene.ts";
import { printedText } from "../../document/printed.ts";
import { clearSelection, NOTHING_SELECTED, useSelection } from "../../document/selected.ts";
import { ChosenPath } from "./Chosen.tsx";

afterEach(() => {
  cleanup();
  clearSelection();
});

test("a chosen call keeps the line styles of its moves", () => {
  const cycle = cycleByNumber(812);
  if (!cycle) throw new Error("no cycle");
  const made = run(parse(printedText(exampleJob(cycle))), { tools: shippedTools, rapid: 10_000 });
  const called = made.steps.filter((step) => step.operation !== null);
  useSelection.setState({ ...NOTHING_SELECTED, choice: { kind: "pass", operation: 0 } });
  const { container } = render(
    <svg>
      <ChosenPath run={made} />
    </svg>,
  );
  const drawn = [...container.querySelectorAll(".shape-marked path")].map((path) => [
    path.getAttribute("class"),
    path.getAttribute("d"),
  ]);
  expect(drawn).toEqual(toolpath(called).map(({ role, d }) => [`shape-${role}`, d]));
  expect(new Set(called.map(({ move }) => pathRole(move)))).toEqual(new Set(["rapid", "feed", "finish"]));
});

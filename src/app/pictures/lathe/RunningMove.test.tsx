import { cleanup, render } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { exampleJob } from "../../../program/job/job.ts";
import { cycleByNumber } from "../../../cycles/index.ts";
import { parse } from "../../../nc/parse.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { stretchData } from "../../../view/path.ts";
import { trackOf } from "../../../view/playback.ts";
import { manualClock } from "../../base/clock.ts";
import { printedText } from "../../document/printed.ts";
import { turnedMoveData } from "./Chosen.tsx";
import { RunningMove } from "./RunningMove.tsx";
import { createPlaybackStore } from "../../calculation/playback-store.ts";

const stepsOf = (number: number) => {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  return run(parse(printedText(exampleJob(cycle))), { tools: shippedTools, rapid: 10_000 }).steps;
};
const [one, other] = [stepsOf(811), stepsOf(821)];
/** A step that is a different move in both. */
const AT = 3;
const running = (box: HTMLElement) => box.querySelector(".shape-running")?.getAttribute("d");
const dataOf = (steps: typeof one) => stretchData(steps.slice(AT, AT + 1));

afterEach(cleanup);

test("the running move belongs to the open work, also at the same playback position", () => {
  const playback = createPlaybackStore(manualClock());
  playback.dispatch({ do: "load", track: trackOf(one) });
  playback.dispatch({ do: "seek", position: { step: AT, fraction: 0.5 } });
  const parts = (steps: typeof one) => (
    <svg>
      <RunningMove moves={steps} playback={playback} dataOf={turnedMoveData} />
    </svg>
  );
  const { container, rerender } = render(parts(one));
  expect(running(container)).toBe(dataOf(one));
  rerender(parts(other));
  expect(dataOf(other)).not.toBe(dataOf(one));
  expect(running(container)).toBe(dataOf(other));
});

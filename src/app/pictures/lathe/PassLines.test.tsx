import { cleanup, render } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { cycleByNumber } from "../../../cycles/index.ts";
import { parse } from "../../../nc/parse.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { run } from "../../../program/run/run.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { pathStretches } from "../../../view/passes.ts";
import { trackOf } from "../../../view/playback.ts";
import { manualClock } from "../../base/clock.ts";
import { printedText } from "../../document/printed.ts";
import { PassLines } from "./PassLines.tsx";
import { createPlaybackStore } from "../../calculation/playback-store.ts";

/** A frame of the clock, ms. */
const PICTURE = 16;

afterEach(cleanup);

test("passes run and fade with the playback, forwards and back, and stay unchanged at high speed", () => {
  const cycle = cycleByNumber(811);
  if (!cycle) throw new Error("no cycle");
  const { steps } = run(parse(printedText(exampleJob(cycle))), { tools: shippedTools, rapid: 10_000 });
  const stretches = pathStretches(steps),
    clock = manualClock(),
    playback = createPlaybackStore(clock);
  playback.dispatch({ do: "load", track: trackOf(steps) });
  const { container } = render(
    <svg>
      <PassLines stretches={stretches} playback={playback} isLong={false} />
    </svg>,
  );
  const classes = () => [...container.querySelectorAll(".lathe-paths > g")].map((g) => g.getAttribute("class"));
  const wanted = (step: number) =>
    stretches.map(({ first, last }) => `pass-${step > last ? "done" : step < first ? "coming" : "running"}`);
  expect(stretches.length).toBeGreaterThan(3);
  for (const step of [0, stretches[2]?.first ?? 0, steps.length, stretches[1]?.last ?? 0, 0]) {
    playback.dispatch({ do: "seek", position: { step, fraction: 0 } });
    expect(classes()).toEqual(wanted(step));
  }
  playback.dispatch({ do: "rate", rate: 100 });
  playback.dispatch({ do: "play" });
  let changes = 0,
    before = classes().join();
  for (let picture = 0; picture < 20; picture += 1) {
    clock.advance(PICTURE);
    if (classes().join() !== before) changes += 1;
    before = classes().join();
  }
  expect(changes).toBeLessThan(4);
  expect(changes).toBeGreaterThan(0);
  playback.dispatch({ do: "pause" });
  expect(classes()).toEqual(wanted(playback.get().position.step));
});

import { afterEach, expect, test, vi } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job.ts";
import { openPrompt, usePlace } from "../place.ts";
import { begin } from "../store.ts";
import { resumePlace, startKeepingPlace } from "./keep-place.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const blank = usePlace.getState();

afterEach(() => {
  vi.useRealTimers();
  sessionStorage.clear();
  usePlace.setState(blank);
});

const work = (name: string) => {
  vi.useFakeTimers();
  begin(exampleJob(cycle), name);
  const stop = startKeepingPlace();
  openPrompt("Q494", "-20");
  vi.runAllTimers();
  stop();
  usePlace.setState(blank);
};

test("the open prompt is open again after a reload, with the text that Escape brings back", () => {
  work("a");
  resumePlace();
  expect(usePlace.getState()).toMatchObject({ section: "prompts", prompt: "Q494", before: "-20" });
});

test("another work begins at its own place", () => {
  work("a");
  begin(exampleJob(cycle), "b");
  resumePlace();
  expect(usePlace.getState().prompt).toBeNull();
});

test.each(["", "{", "3", '{"work":"a"}'])("a damaged note %j is passed over", (text) => {
  work("a");
  sessionStorage.setItem("turnwise/place", text);
  resumePlace();
  expect(usePlace.getState().prompt).toBeNull();
});

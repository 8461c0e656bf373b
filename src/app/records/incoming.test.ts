import { expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import { shownPage, showGuide, showTools, usePlace } from "../place/place.ts";
import { useEditor } from "../document/store.ts";
import { showIncoming, takeIncoming, useIncoming } from "./incoming.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");

test("a received work is shown once accepted, whatever page was open", () => {
  showTools();
  showGuide("guide", String(cycle.number));
  const work = { ...exampleJob(cycle), name: "RECEIVED" };
  showIncoming({ work, from: "link" });
  takeIncoming({ work, from: "link" });
  expect([shownPage(usePlace.getState()).page, useIncoming.getState().incoming]).toEqual(["work", null]);
  expect(useEditor.getState().job?.name).toBe("RECEIVED");
});

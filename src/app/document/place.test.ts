import { beforeEach, expect, test } from "vitest";
import { cuttingCycles } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job/job.ts";
import {
  cover,
  shownPage,
  showElsewhere,
  showOwn,
  showSection,
  showSheet,
  showTools,
  showWhich,
  uncover,
  usePlace,
  type Cover,
} from "../place/place.ts";
import { goHome, goToEntrance } from "./go-home.ts";
import { openFirstWork, open, useEditor } from "./store.ts";

const [cycle] = cuttingCycles;
if (!cycle) throw new Error("the catalogue is empty");
const job = exampleJob(cycle);
const page = () => shownPage(usePlace.getState()).page;
const covers: readonly Cover[] = [
  { page: "sheet" },
  { page: "tools" },
  { page: "own" },
  { page: "guide", path: ["glossary"] },
];

beforeEach(() => {
  openFirstWork(null, null);
  goHome();
});

test.each(covers)("whatever opens another work shows it, under $page too", (over) => {
  openFirstWork(job, "first");
  cover(over);
  showWhich();
  open(job, "second");
  expect([page(), usePlace.getState().over]).toEqual(["work", null]);
  expect(useEditor.getState().work).toBe("second");
});

test("covers are stacked and closed one by one; tools and own cycles replace each other", () => {
  openFirstWork(job, "first");
  showSheet();
  showTools("r5");
  cover({ page: "guide", path: ["guide"] });
  cover({ page: "guide", path: ["glossary", "infeed"] });
  const closed = [page()];
  while (page() !== "work") {
    uncover();
    closed.push(page());
  }
  expect(closed).toEqual(["guide", "tools", "sheet", "work"]);
  uncover();
  expect(page()).toBe("work");
  showTools();
  showOwn();
  uncover();
  expect([page(), usePlace.getState().tools.row]).toEqual(["work", "r5"]);
});

test("closing a work leads back to the entrance that it was opened from", () => {
  goToEntrance({ page: "works" });
  open(job, "first");
  open(null, null);
  expect(page()).toBe("works");
  showElsewhere({ work: "other", name: "OTHER", cause: "isOpen" });
  expect(page()).toBe("elsewhere");
  open(job, "first");
  expect(page()).toBe("work");
});

test("a work opens in a section that its kind has", () => {
  openFirstWork(job, "first");
  showSection("setup");
  open({ name: "P", text: "BEGIN PGM P MM\nEND PGM P MM\n", encoding: "utf-8" }, "program");
  expect(["structure", "text"]).toContain(usePlace.getState().section);
  showSection("findings");
  open(job, "first");
  expect(usePlace.getState().section).toBe("findings");
});

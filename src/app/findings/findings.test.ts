import { expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { findings as english } from "../../i18n/en/workplace/findings.ts";
import { spotOn } from "../../kernel/plane/mill-motion.ts";
import { exampleJob, UNSET, type Job } from "../../program/job/job.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { engine } from "../calculation/engine.ts";
import type { Outcome } from "../calculation/outcome.ts";
import { printedText } from "../document/printed.ts";
import { readJob } from "../document/reading.ts";
import { isToDo } from "./entry.ts";
import { findingsOf } from "./findings.ts";
import { shownVerdict, toneOf } from "./verdict.ts";
import { verdictReasons, verdictTitle } from "./verdict-words.ts";

const outcomeOf = (text: string): Outcome =>
  engine.update({
    version: 1,
    text,
    table: { tools: shippedTools, mills: [], refused: new Map() },
    rapid: 10_000,
    control: "TNC 640",
  });

function jobOf(number: number, change: (job: Job) => Job = (job) => job): Job {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  return change(exampleJob(cycle));
}
const withPrompt =
  (q: string, text: string) =>
  (job: Job): Job => ({
    ...job,
    drafts: { [job.cycle]: { ...job.drafts[job.cycle], [q]: text } },
  });

function found(job: Job) {
  const read = readJob(job);
  const outcome = read?.reading.values ? outcomeOf(printedText(job)) : null;
  const entries = findingsOf(read, outcome);
  return { entries, verdict: shownVerdict(entries, outcome) };
}
const codes = (job: Job) => found(job).entries.map(({ issue }) => issue.code);

test.each([812, 852])("the printed example of %i has no error and is verified", (number) => {
  const { verdict } = found(jobOf(number));
  expect(verdict).toMatchObject({ state: "proved", faults: 0, open: 0 });
});

test("an empty prompt is neither an error nor verified", () => {
  const { entries, verdict } = found(jobOf(812, withPrompt("Q463", "")));
  expect(entries.every(isToDo)).toBe(true);
  expect(verdict).toMatchObject({ state: "none", faults: 0, open: 1 });
  expect(toneOf(verdict)).toBe("none");
});

test("a missing contour is a note while prompts are open, and an error when all are answered; it is listed once", () => {
  const empty = jobOf(820, (job) => ({ ...job, contour: [] }));
  expect(found(empty).verdict).toMatchObject({ state: "faults", faults: 1 });
  expect(codes(empty).filter((code) => code === "contourMissing" || code === "contourTooShort")).toEqual([
    "contourMissing",
  ]);
  const open = found(withPrompt("Q463", "")(empty));
  expect(open.verdict).toMatchObject({ state: "none", faults: 0, open: 1 });
  expect(open.entries.map(({ issue }) => [issue.code, issue.severity])).toEqual([
    ["missing", "error"],
    ["contourMissing", "info"],
  ]);
});

test("an unsuitable tool is listed as the cause, and its consequences are not", () => {
  const tool = shippedTools.find((t) => t.TYPE === "THREAD") ?? shippedTools.find((t) => t.TYPE === "RECESS");
  const { entries, verdict } = found(jobOf(812, (job) => ({ ...job, tool: tool?.T ?? 0 })));
  expect(entries[0]?.issue).toMatchObject({ code: "toolUnfit", severity: "error" });
  expect(entries.map(({ issue }) => issue.code)).not.toContain("angleNotFollowed");
  expect(toneOf(verdict)).toBe("bad");
});

test("many places with the same residual material are one finding with its total; a few are listed one by one", () => {
  const { entries, verdict } = found(jobOf(832));
  const stays = entries.filter(({ issue }) => issue.code === "materialLeft");
  expect(stays).toHaveLength(1);
  expect(stays[0]?.issue.data).toMatchObject({ places: 17, area: expect.closeTo(1.421, 3) });
  expect(verdict.residualArea).toBeCloseTo(1.421, 3);
  expect(stays[0]?.spot?.mark).toBe("A");
  const few = found(jobOf(812, withPrompt("Q500", "0"))).entries.filter(({ issue }) => issue.code === "materialLeft");
  expect(few.length).toBeGreaterThan(0);
  expect(few.filter(({ issue }) => "places" in issue.data)).toEqual([]);
});

test("worst first, each place of the picture with its own mark", () => {
  const { entries } = found(
    jobOf(812, (job) => ({ ...withPrompt("Q500", "0")(job), start: { x: "71.3", z: "-9.7" } })),
  );
  const weight = { error: 0, warning: 1, info: 2 };
  const weights = entries.map(({ issue }) => weight[issue.severity]);
  expect(weights).toEqual(weights.toSorted((a, b) => a - b));
  const marks = entries.flatMap(({ spot }) => (spot ? [spot.mark] : []));
  expect(marks.length).toBeGreaterThan(0);
  expect(new Set(marks).size).toBe(marks.length);
  for (const { spot } of entries)
    if (spot) {
      expect(spot.bounds.left).toBeLessThan(spot.place.z);
      expect(spot.bounds.right).toBeGreaterThan(spot.place.z);
    }
});

test.each([
  [
    "a waist that its tool does not pass, where the tool cuts it",
    "5",
    "APPR LT X-30 Y-10 LEN10",
    ["pathCutsContour"],
    {
      x: 0,
      y: 9,
    },
  ],
  [
    "a wall too short for its tool, at the wall",
    "7",
    "APPR LT X-30 Y-10 LEN10",
    ["toolRadiusTooLarge", "toolRadiusTooLarge"],
    {
      x: 10,
      y: -3,
    },
  ],
])("%s is a place of the plane", (_, tool, approach, codes, place) => {
  const outcome = outcomeOf(`BEGIN PGM P MM
TOOL DEF 1 L+0 R+${tool}
TOOL CALL 1 Z S4000
L X-70 Y-20 R0 FMAX M3
L Z-5 R0 F300
${approach} RL F200
L X+0 Y+0\nL X+10\nL Y-6\nL X+40\nL Y+15\nL X+10\nL Y+9\nL X+0\nL X-30 Y+19
DEP LT LEN30
END PGM P MM`);
  const found = findingsOf(null, outcome).filter(({ spot }) => spot);
  expect(found.map(({ issue }) => issue.code)).toEqual(codes);
  const spot = found[0]?.spot,
    radius = Number(tool);
  expect(spot).toMatchObject({ plane: "XY", place: { z: place.x, r: place.y } });
  // The picture then has the whole mill, which touches the place or is above it.
  const step = outcome.run.plane[spot?.position.step ?? -1],
    at = step && spotOn(step, spot?.position.fraction ?? 0);
  expect(Math.hypot((at?.x ?? NaN) - place.x, (at?.y ?? NaN) - place.y)).toBeLessThan(radius + 0.01);
  expect((spot?.bounds.right ?? 0) - place.x).toBeGreaterThan(2 * radius);
});

test.each([
  ["a cycle that is kept", "CYCL DEF 892 CHECK UNBALANCE~\nQ450=+0\n5 CYCL CALL", "unproved"],
  ["no cycle at all", "L X+50 Z-3 F0.2", "noOperation"],
])("%s is never green", (_, blocks, kind) => {
  const text = `0 BEGIN PGM A MM\n1 BLK FORM CYLINDER Z D60 L80 DIST+0\n2 FUNCTION MODE TURN\n3 TOOL CALL 1\n4 ${blocks}\n8 M30\n9 END PGM A MM\n`;
  const outcome = outcomeOf(text);
  const entries = findingsOf(null, outcome);
  const verdict = shownVerdict(entries, outcome);
  expect(verdict.doubts.map((doubt) => doubt.kind)).toContain(kind);
  expect(toneOf(verdict)).not.toBe("good");
});

const around = (blocks: string) =>
  `0 BEGIN PGM A MM\n1 BLK FORM CYLINDER Z D63.5 L80 DIST+0\n2 FUNCTION MODE TURN\n${blocks}3 M30\n4 END PGM A MM\n`;

test.each([
  ["nothing but its blank", "", "none"],
  [
    "a cut by hand",
    "TOOL CALL 1\nFUNCTION TURNDATA SPIN VCONST:OFF S520\nL X+91.3 Z+52 R0 FMAX M303\nL X+60.2 FMAX\nL Z-3.4 F0.2\n",
    "doubt",
  ],
])("a program with %s: is there anything to verify", (_, blocks, tone) => {
  const outcome = outcomeOf(around(blocks));
  const entries = findingsOf(null, outcome),
    verdict = shownVerdict(entries, outcome);
  expect([verdict.state, toneOf(verdict)]).toEqual(["incomplete", tone]);
  // A part turned with single moves may be right: the verdict says what was checked and what could not be.
  const { verdict: words } = english;
  expect(verdictTitle(words, "en", verdict)).toBe(tone === "doubt" ? words.noCycle : words.noOperation);
  expect(verdictReasons(words, verdict)).toEqual([
    tone === "doubt" ? words.because.noCycle : words.because.noOperation,
  ]);
});

test("a forgotten minus is questioned first, and findings of tool and stock that follow from it are not listed", () => {
  const { entries } = found(withPrompt("Q494", "55.4")(jobOf(812)));
  expect(entries[0]?.issue).toMatchObject({ code: "endInFront", severity: "error", data: { nearest: -55.4 } });
  expect(entries.filter(({ issue }) => issue.severity !== "info").map(({ issue }) => issue.code)).toEqual([
    "endInFront",
  ]);
  // Tool and blank are not set: both are proposed for the typed value.
  const proposed = found(
    withPrompt("Q494", "55.4")(jobOf(812, (job) => ({ ...job, tool: null, blank: UNSET.blank, start: UNSET.start }))),
  );
  expect(proposed.entries.map(({ issue }) => issue.code)).toContain("endInFront");
  expect(proposed.entries.map(({ issue }) => issue.code)).not.toContain("holderContact");
});

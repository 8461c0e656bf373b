import * as fc from "fast-check";
import { afterEach, expect, test } from "vitest";
import { typedJobsOf } from "../../../tests/control-file-texts.ts";
import { cuttingCycles } from "../../cycles/index.ts";
import { CLAMPING_KINDS } from "../../program/clamping/words.ts";
import { at } from "../../kernel/geometry/point.ts";
import type { Job } from "../../program/job/job.ts";
import { SETUP_PLACES } from "../../program/job/setup-places.ts";
import { NC_OUTPUTS } from "../../program/machine/nc-output.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { shippedList } from "../../program/tools/tool-list.ts";
import {
  setClamping,
  setContour,
  setLayout,
  setMaterial,
  setMeasured,
  setName,
  setNcLanguage,
  setParameter,
  setPerRevolution,
  setPrompt,
  setPrompts,
  setRapid,
  setRemarks,
  setSpindle,
} from "../document/edits.ts";
import { setOutput } from "../document/output.ts";
import { printedText } from "../document/printed.ts";
import { setPlace, takePlace } from "../document/setup-edits.ts";
import { closeStep, forgetAllSteps, historyOf, redo, undo } from "../document/steps.ts";
import { changeProgram, openContent, openDocument, openFirstWork, setBundle } from "../document/store.ts";
import { setPrediction } from "../document/work-task.ts";
import { isProgram, type Work } from "../document/work.ts";
import { readArchive, writeArchive } from "./archive.ts";
import { differenceOf, withDifference, type Json } from "./difference.ts";
import { linkOf, readLink } from "./link.ts";
import { readSave, SAVE_VERSION } from "./save-file.ts";

const file = (job: Work) => ({ version: SAVE_VERSION, savedAt: 1, job });

/** The ways that a work takes out of the page and back. */
const WAYS: Readonly<Record<string, (work: Work) => unknown>> = {
  "the device": (work) => readSave(JSON.parse(JSON.stringify(file(work))))?.job,
  "a link": (work) => {
    const read = readLink(linkOf("", work));
    return read.kind === "work" ? read.work : read;
  },
  "a backup": (work) => {
    const read = readArchive(writeArchive({ works: [{ work: "w", savedAt: 1, job: work }] }));
    return "problem" in read ? read : read.works[0]?.job;
  },
};

const textOf = (work: Work): string => (isProgram(work) ? work.text : printedText(work, shippedTools));

function staysWhole(work: Work): void {
  const text = textOf(work);
  for (const [name, way] of Object.entries(WAYS)) {
    const back = way(work);
    expect(back, name).toEqual(work);
    expect(textOf(back as Work), name).toBe(text);
  }
}

/** What a field may hold while somebody types: half a number, nothing, no number at all. */
const halfTyped = fc.oneof(
  fc.constantFrom("", "1.", "-", "+", "1/", "Q", "0.", "..", "abc", " 12 ", "7,5", "?"),
  fc.integer({ min: -900, max: 900 }).map((n) => String(n / 10)),
);
const clamping = fc.option(
  fc.record({
    kind: fc.constantFrom(...CLAMPING_KINDS),
    words: fc.dictionary(fc.constantFrom("D", "LENGTH", "FACE", "TIP"), halfTyped),
  }),
);

/** Unfinished set-ups: nothing chosen, half typed, and proposals that nobody confirmed. */
const unfinished = fc.record(
  {
    tool: fc.constantFrom(null, 1, 17, 99999),
    blank: fc.record({ outside: halfTyped, bore: halfTyped, length: halfTyped, allowance: halfTyped }),
    start: fc.record({ x: halfTyped, z: halfTyped }),
    proposals: fc.dictionary(fc.constantFrom(...SETUP_PLACES), halfTyped),
    spindle: fc.record({
      mode: fc.constantFrom("constant" as const, "surface" as const),
      speed: halfTyped,
      cuttingSpeed: halfTyped,
      limit: halfTyped,
    }),
    rapid: halfTyped,
    remarks: fc.string({ maxLength: 40 }),
    material: fc.constantFrom("42crmo4", "unknown"),
    task: fc.record({ id: fc.constant("t"), veiled: fc.boolean(), told: fc.array(halfTyped, { maxLength: 3 }) }),
  },
  { requiredKeys: [] },
);

/** A job with an unfinished set-up, values of another cycle, and half-typed prompts. */
const jobsOf = (cycle: (typeof cuttingCycles)[number]): fc.Arbitrary<Job> =>
  fc
    .record({
      job: typedJobsOf(cycle),
      other: fc.constantFrom(...cuttingCycles).chain(typedJobsOf),
      half: fc.dictionary(fc.constantFrom(...Object.keys(cycle.params)), halfTyped),
      setup: unfinished,
      held: clamping,
    })
    .map(({ job, other, half, setup, held }) => ({
      ...job,
      ...setup,
      ...(held && { clamping: held }),
      drafts: { ...other.drafts, [cycle.number]: { ...job.drafts[cycle.number], ...half } },
    }));

const saved = Object.entries(
  import.meta.glob<unknown>("../../../tests/saved/v*/*.json", { eager: true, import: "default" }),
);

test.each(saved)("%s keeps its text and what was typed on every way", (_, raw) => {
  const work = readSave(raw)?.job;
  expect(work).toBeDefined();
  if (work) staysWhole(work);
});

/** Cases of each cycle: a hundred over the catalogue. */
const EACH = Math.ceil(100 / cuttingCycles.length);

test.each(cuttingCycles.map((cycle) => [cycle.number, cycle] as const))(
  "an unfinished job of cycle %i keeps its text and what was typed on every way",
  (_, cycle) => {
    fc.assert(fc.property(jobsOf(cycle), staysWhole), { numRuns: EACH });
  },
);

const [first] = cuttingCycles;
const [started] = first ? fc.sample(jobsOf(first), { numRuns: 1, seed: 7 }) : [];
if (!first || !started) throw new Error("the catalogue is empty");
const prompts = Object.keys(first.params);
const job: Work = { ...started, task: { id: "t", told: [] } };
const program: Work = {
  name: "A.h",
  text: "0 BEGIN PGM A MM\n1 L X+41.3 Z-3.2",
  encoding: "utf-8",
  files: [{ name: "B.h", text: "L X+", encoding: "windows-1252" }],
  task: { id: "t", told: ["1."] },
};

/** Every change that an operator makes to a work of either kind, with a text and a number. */
const SHARED: Readonly<Record<string, (text: string, n: number) => void>> = {
  remarks: (text) => setRemarks(text),
  material: (text) => setMaterial(text),
  output: (_, n) => setOutput({ ...NC_OUTPUTS.manual, spindleOn: n }),
  measured: (_, n) =>
    setMeasured((list) => [
      ...list,
      { id: String(list.length), kind: "length", plane: "ZX", places: [{ at: at(n, 1), spot: "free" }] },
    ]),
  prediction: (text, n) => setPrediction(n % 3, text),
  tools: (_, n) => setBundle(n % 2 === 0 ? {} : { tools: shippedList.slice(0, n % 5), machine: "{" }),
};
const OF_JOB: typeof SHARED = {
  prompt: (text, n) => setPrompt(prompts[n % prompts.length] ?? "", text),
  prompts: (text) => setPrompts({ Q463: text }, { blank: { outside: text }, start: { z: text } }),
  place: (text, n) => setPlace(SETUP_PLACES[n % SETUP_PLACES.length] ?? "tool", text),
  taken: (text, n) => takePlace(SETUP_PLACES[n % SETUP_PLACES.length] ?? "tool", text),
  clamping: (text, n) => setClamping(n % 3 === 0 ? null : { kind: "softJaws", words: { D: text } }, null),
  spindle: (text) => setSpindle("cuttingSpeed", text),
  mode: (_, n) => setSpindle("mode", n % 2 === 0 ? "constant" : "surface"),
  parameter: (text) => setParameter("Q5", text),
  perRevolution: (_, n) => setPerRevolution(n % 2 === 0),
  rapid: (text) => setRapid(text),
  name: (text) => setName(text),
  layout: (_, n) => setLayout(n % 2 === 0 ? "iso" : "tnc7"),
  ncLanguage: (_, n) => setNcLanguage(n % 2 === 0 ? "de" : "en"),
  contour: (_, n) => setContour(started.contour.slice(n % 2)),
};
const OF_PROGRAM: typeof SHARED = {
  text: (text) => changeProgram((work) => ({ ...work, text: `${work.text}\n${text}` }), "text"),
  skip: (_, n) => changeProgram((work) => ({ ...work, skipMarked: n % 2 === 0 })),
};

const changesOf = (edits: typeof SHARED) =>
  fc.array(
    fc.record({
      edit: fc.constantFrom(...Object.keys(edits)),
      text: halfTyped,
      n: fc.nat(9),
      leaves: fc.boolean(),
    }),
    { minLength: 1, maxLength: 12 },
  );

function goThrough(way: "past" | "future"): void {
  const document = openDocument() ?? "";
  for (let left = historyOf(document)[way].length; left > 0; left--) (way === "past" ? undo : redo)(document);
}

const KINDS = [
  ["job", job, { ...SHARED, ...OF_JOB }],
  ["program", program, { ...SHARED, ...OF_PROGRAM }],
] as const;

afterEach(() => {
  forgetAllSteps();
  openFirstWork(null, null);
});

test.each(KINDS)("what is typed into a %s survives every way, undo, redo and a kept history", (_, work, edits) => {
  fc.assert(
    fc.property(changesOf(edits), (list) => {
      forgetAllSteps();
      openFirstWork(work, "w");
      for (const { edit, text, n, leaves } of list) {
        edits[edit]?.(text, n);
        if (leaves) closeStep();
      }
      const last = openContent() as Work;
      staysWhole(last);
      const [near, far] = [work, last] as unknown as readonly [Json, Json];
      expect(withDifference(near, differenceOf(near, far))).toEqual(last);
      goThrough("past");
      expect(openContent()).toEqual(work);
      goThrough("future");
      expect(openContent()).toEqual(last);
    }),
    { numRuns: 30 },
  );
});

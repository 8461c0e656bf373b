import { issue as contourIssue } from "../../kernel/plan/issue.ts";
import type { AnyIssue } from "../../i18n/message-texts.ts";
import type { Job } from "../../program/job/job.ts";
import { withPlace } from "../../program/job/setup-place.ts";
import { setupQuestions } from "../../program/job/setup-questions.ts";
import { joinPlaces, operationKey } from "../../report/places.ts";
import { triedDraft, type JobRunner } from "../../report/tried-draft.ts";
import { followsQuestion, QUESTIONS } from "../../sim/causes.ts";
import { stockIssues } from "../../sim/issues.ts";
import { rapidOf } from "../calculation/request.ts";
import { rememberingLast } from "../base/once.ts";
import { contourProblems } from "../document/contour-problems.ts";
import { printedText } from "../document/printed.ts";
import type { Outcome } from "../calculation/outcome.ts";
import type { JobReading } from "../document/reading.ts";
import { withoutConsequences } from "./consequences.ts";
import { inOrder, type FindingEntry } from "./entry.ts";
import { letterOf, spotOfProof, spotOfRun } from "./spots.ts";

type Found = Omit<FindingEntry, "id">;

const NO_PLACE = {
  at: null,
  block: null,
  line: null,
  operation: null,
  spot: null,
  residual: null,
  thickness: null,
} as const;
const atOf = (issue: AnyIssue): string | null => ("at" in issue ? (issue.at ?? null) : null);

/** How a job is run to try what its prompts offer. */
const runner = (tools: JobReading["tools"]): JobRunner => ({
  print: (job) => printedText(job, tools),
  shop: (job) => ({ tools, rapid: rapidOf(job) }),
});

/** Findings of the prompts and the contour table, before anything is calculated; cached, as offers are tried for them. */
const typed = rememberingLast((read: JobReading): readonly Found[] => {
  const { setup, cycle, job, reading, tools } = read;
  const asked = setup ? setupQuestions({ setup, cycle, job, partial: reading.partial, tools }) : [];
  // What is only proposed is proposed anew for another value.
  const set = () => [...(setup?.proposed ?? [])].reduce<Job>((each, place) => withPlace(each, place, ""), job);
  const found = setup ? triedDraft(set(), runner(tools), reading.issues, asked) : reading.issues;
  const prompts = found.map((issue): Found => ({ ...NO_PLACE, issue, at: issue.at ?? null }));
  if (read.cycle.contour !== "free") return prompts;
  const { contour } = read.job;
  // While prompts are open, a contour not begun is no error, only not done yet.
  const missing = () =>
    contourIssue("contourMissing", read.reading.values ? "error" : "info", { label: "" }, "contour");
  const table = contour.length === 0 ? [missing()] : contourProblems(contour);
  return [...prompts, ...table.map((issue): Found => ({ ...NO_PLACE, issue, at: "contour" }))];
});

/** The first operation of a call of an unknown tool: a suitable tool is reported there. */
function operationOfCall(
  { issues, operations }: Outcome["run"],
  { issue, block }: Outcome["run"]["issues"][number],
): number | null {
  if (issue.code !== "toolUnknown" && issue.code !== "toolIndexUnknown") return null;
  const better = issues.find((each) => each.issue.code === "betterTool" && (each.block ?? 0) > (block ?? 0));
  const index = better ? operations.findIndex((each) => each.block === better.block) : -1;
  return index < 0 ? null : index;
}

/** Findings of the run and the stock. */
function calculated({ run, simulation }: Outcome): readonly Found[] {
  const ran = run.issues.map((f): Found => {
    const spot = spotOfRun(run, f);
    return {
      ...NO_PLACE,
      issue: f.issue,
      at: atOf(f.issue),
      block: f.block,
      line: f.line,
      inFile: f.inFile,
      operation: f.operation ?? operationOfCall(run, f),
      spot: spot && { ...spot, mark: "" },
    };
  });
  const proved = stockIssues(simulation).map((p): Found => {
    const seen = spotOfProof(simulation, p);
    const operation = p.operation === null ? undefined : run.operations[p.operation];
    return {
      ...NO_PLACE,
      issue: p.issue,
      at: atOf(p.issue),
      block: p.block ?? operation?.block ?? null,
      operation: p.operation,
      spot: seen && { ...seen.spot, mark: "" },
      residual: seen?.residual ?? null,
      thickness: seen?.thickness ?? null,
    };
  });
  return [...ran, ...proved];
}

/** Up to this many places of one kind are listed one by one: each has its own mark in the picture. */
const FEW = 5;

/** Joins many places of one kind to one finding, as in the report. */
function groupPlaces(all: readonly Found[], operations: Outcome["run"]["operations"]): readonly Found[] {
  const placed = all.map((found) => {
    const operation = found.operation === null ? undefined : operations[found.operation];
    return { ...found, work: operationKey(found, operation) };
  });
  return joinPlaces(placed, FEW).map(({ work: _, joined, ...found }) =>
    joined ? { ...found, thickness: thickest(joined) } : found,
  );
}

const thickest = (all: readonly Pick<Found, "thickness">[]): number | null =>
  all.reduce<number | null>(
    (most, { thickness }) => (thickness === null ? most : Math.max(most ?? 0, thickness)),
    null,
  );

/** Numbers for findings with a place, letters for residual material, in the order of the list. */
function marked(entries: readonly FindingEntry[]): readonly FindingEntry[] {
  let [numbers, letters] = [0, 0];
  return entries.map((entry) => {
    if (!entry.spot) return entry;
    const mark = entry.spot.kind === "finding" ? String((numbers += 1)) : letterOf((letters += 1) - 1);
    return { ...entry, spot: { ...entry.spot, mark } };
  });
}

/**
 * Removes findings that follow from a dimension questioned by the prompts: the run has another set-up than the one
 * intended.
 */
function withoutFollowing(early: readonly Found[], late: readonly Found[]): readonly Found[] {
  const isAsked = early.some(({ issue }) => QUESTIONS.has(issue.code));
  return isAsked ? late.filter(({ issue }) => !followsQuestion(issue.code)) : late;
}

/** Whether a set blank is questioned for a diameter that the program questions, too. */
const isBlankOf = ({ issue }: Found, { issue: late, at }: Found): boolean =>
  issue.code === "blankAgainstContour" && late.code === "diameterOutside" && issue.data.other === at;

/**
 * Joins questions of the prompts with their consequences and repeats in the program: with an error among them, the
 * question is one.
 */
function joinQuestions(early: readonly Found[], late: readonly Found[]): readonly Found[] {
  const isRefused = late.some(({ issue }) => issue.severity === "error");
  const asked = early
    .filter(
      ({ issue, at }) => !QUESTIONS.has(issue.code) || !late.some((l) => l.issue.code === issue.code && l.at === at),
    )
    .map((found): Found => {
      const { issue } = found;
      const isCause = QUESTIONS.has(issue.code) ? isRefused : late.some((each) => isBlankOf(found, each));
      return isCause ? { ...found, issue: { ...issue, severity: "error" } as AnyIssue } : found;
    });
  return [...asked, ...withoutFollowing(early, late).filter((each) => !early.some((found) => isBlankOf(found, each)))];
}

/**
 * All findings of the open work, worst first, without repeats: those of the prompts at once, and those of the last
 * calculated program if it belongs to these values. A program has no prompts of its own: `read` is null.
 */
export function findingsOf(read: JobReading | null, outcome: Outcome | null): readonly FindingEntry[] {
  const early = read ? typed(read) : [];
  const run = outcome && (!read || read.reading.values) ? calculated(outcome) : [];
  // A start point that nobody has set is no fault of the operator.
  const isOwnStart = read?.setup?.proposed.has("start.x") && read.setup.proposed.has("start.z");
  const late = isOwnStart ? run.filter(({ issue }) => issue.code !== "startInsideEnvelope") : run;
  const all = new Map<string, FindingEntry>();
  for (const found of groupPlaces(withoutConsequences(joinQuestions(early, late)), outcome?.run.operations ?? [])) {
    const { issue, at, line, inFile } = found;
    // The text of a job is made from its prompts: a finding of both is listed once.
    const key = JSON.stringify([issue.code, at, issue.data, read ? null : line, inFile]);
    if (!all.has(key)) all.set(key, { ...found, id: `${issue.code} ${at ?? ""} ${found.block ?? ""} ${all.size}` });
  }
  return marked(inOrder([...all.values()]));
}

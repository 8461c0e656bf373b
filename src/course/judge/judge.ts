import { producedParts } from "../../sim/produced-parts.ts";
import { REAL_AREA } from "../../kernel/area/real-area.ts";
import { stockIssues } from "../../sim/issues.ts";
import type { RunFinding } from "../../program/state/run-types.ts";
import type { StockFinding } from "../../sim/simulation.ts";
import type { Task } from "../task.ts";
import { areaBeyond, distanceTo, missingMarks, residueMarks } from "./difference.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { RULES, type Answer, type TaskJudgement, type TaskMark, type RuleName } from "./judgement.ts";
import { ruleMarks } from "./rules.ts";
import { scoreOf } from "./score.ts";
import { shapedBy } from "./shaped-by.ts";
import { sizeMarks } from "./sizes.ts";
import { threadMarks } from "./threads.ts";
import { targetPart, type TargetPart } from "../target-part.ts";

/** Default limits of excess and missing material, mm², where a task states none. */
const RESIDUE = 0.05;
const MISSING = 0.01;
/** A groove this near to the target groove, mm, is that groove cut in the wrong place. */
const ASIDE = 2;

/** Rules about the shape of the part: what shapes the contour at their place is named. */
const SHAPED: ReadonlySet<RuleName> = new Set(["missing", "residue", "size"]);

/** The findings with a rule of their own; the others count as errors. */
const FOUND: Partial<Record<StockFinding["kind"], RuleName>> = {
  rapidInStock: "rapid",
  holderContact: "holder",
  clampContact: "holder",
  gouge: "gouge",
};

const ofFinding = (rule: RuleName, f: StockFinding): TaskMark => ({
  rule,
  passed: false,
  value: f.area,
  step: f.step,
  block: f.block,
  ...(f.operation !== null && { operation: f.operation }),
  place: f.place,
  rings: f.rings,
});

/**
 * Findings of the stock that are never allowed. With a target part, a cut into a cycle's own contour counts as missing
 * material.
 */
function foundMarks({ simulation }: Answer, wanted: TargetPart | null): TaskMark[] {
  return (["rapid", "holder", "gouge"] as const).flatMap((rule): TaskMark[] => {
    if (rule === "gouge" && wanted) return [];
    const found = simulation.findings.filter((f) => FOUND[f.kind] === rule);
    return found.length > 0 ? found.map((f) => ofFinding(rule, f)) : [{ rule, passed: true }];
  });
}

/** Findings of the run and of the stock that count for a rule, except those with marks of their own. */
function issueMarks(
  rule: "errors" | "clean",
  { run, simulation }: Answer,
  counts: (issue: RunFinding["issue"]) => boolean,
): TaskMark[] {
  const own: readonly string[] = [...Object.keys(FOUND), "threadOverruns"];
  const read = run.issues
    .filter(({ issue }) => counts(issue))
    .map(({ issue, block, operation }): TaskMark => ({
      rule,
      passed: false,
      ...(block !== null && { block }),
      ...(operation !== null && { operation }),
      ...("at" in issue && issue.at?.startsWith("Q") && { q: issue.at }),
      issue,
    }));
  const stock = stockIssues(simulation)
    .filter(({ issue }) => counts(issue) && !own.includes(issue.code))
    .map((found): TaskMark => {
      const { issue, block, operation, step } = found;
      const place = block ?? run.operations[operation ?? -1]?.block;
      return {
        rule,
        passed: false,
        ...(place !== undefined && { block: place }),
        ...(step !== null && { step }),
        ...(operation !== null && { operation }),
        issue,
      };
    });
  const all = [...read, ...stock];
  return all.length > 0 ? all : [{ rule, passed: true }];
}

/**
 * Warnings that count as errors, although the program runs: a feed of a hundredth of a millimetre per revolution, and a
 * recessing blade that cuts sideways. A task that counts all warnings or limits the time reports them there.
 */
const errorMarks = (answer: Answer, { clean = false, seconds }: Task["rules"]): TaskMark[] =>
  issueMarks(
    "errors",
    answer,
    ({ code, severity }) =>
      severity === "error" ||
      (!clean && ((code === "feedUnlikely" && seconds === undefined) || code === "toolCannotCutSideways")),
  );

/** With a target part, residual material is judged against that part alone. */
const cleanMarks = (answer: Answer, wanted: TargetPart | null): TaskMark[] =>
  issueMarks("clean", answer, ({ code, severity }) => severity === "warning" && !(wanted && code === "materialLeft"));

/** After a block that is not simulated nothing is known, so nothing can be judged right. */
function unprovedMarks({ run, simulation }: Answer): TaskMark[] {
  const milled = run.plane.find((s) => s.kind !== "rapid");
  const found = [
    ...simulation.proof.unproved.map(({ block, step, what }): TaskMark => ({
      rule: "unproved",
      passed: false,
      step,
      about: what,
      ...(block !== null && { block }),
    })),
    ...(milled ? [{ rule: "unproved", passed: false, block: milled.block } satisfies TaskMark] : []),
  ];
  return found.length > 0 ? found : [{ rule: "unproved", passed: true }];
}

/** Compares the made part with the target part. */
function partMarks(task: Task, wanted: TargetPart, answer: Answer): TaskMark[] {
  const { run, simulation } = answer,
    final = producedParts(simulation);
  const [lacks, adds] = [areaBeyond(wanted.blank, run.blank), areaBeyond(run.blank, wanted.blank)];
  const other = [...lacks, ...adds];
  const isOther = run.blank.length === 0 || areaOf(lacks) + areaOf(adds) > REAL_AREA;
  const blank: TaskMark = { rule: "blank", passed: !isOther, ...(isOther && other.length > 0 && { rings: other }) };
  if (run.blank.length === 0) return [blank];
  const threads = threadMarks(task.part?.threads ?? [], answer);
  const missing = missingMarks(wanted.solid, final, task.rules.missing ?? MISSING, answer);
  // Grooves at another pitch or diameter are reported once, by the thread, and not one by one.
  const isOfThread = ({ operation, place }: TaskMark) =>
    run.operations[operation ?? -1]?.plan.thread !== undefined &&
    place !== undefined &&
    threads.some(({ passed, rings }) => !passed && rings && distanceTo(rings, place) < ASIDE);
  const besides = missing.filter((mark) => mark.passed || !isOfThread(mark));
  return [blank, ...besides, ...threads, ...residueMarks(wanted.rings, final, task.rules.residue ?? RESIDUE, answer)];
}

/** In the order of the rules, failed marks first. */
const ordered = (marks: readonly TaskMark[]): TaskMark[] => {
  const rank = ({ rule, passed }: TaskMark) => 2 * RULES.indexOf(rule) + Number(passed);
  return marks.toSorted((a, b) => rank(a) - rank(b));
};

/** What is wrong with an answer, as `judge` says it, without what shapes the contour there. */
export function judgeUnplaced(task: Task, answer: Answer): TaskJudgement {
  const wanted = task.part ? targetPart(task.part) : null;
  const marks = ordered([
    ...errorMarks(answer, task.rules),
    ...unprovedMarks(answer),
    ...foundMarks(answer, wanted),
    ...(wanted ? partMarks(task, wanted, answer) : []),
    ...sizeMarks(task.sizes ?? [], answer),
    ...(task.rules.clean ? cleanMarks(answer, wanted) : []),
    ...ruleMarks(task.rules, answer),
  ]);
  const { par } = task;
  const score =
    task.kind === "drawing" && par && wanted
      ? scoreOf(par, wanted, task.rules.residue ?? RESIDUE, answer, marks)
      : undefined;
  return { passed: marks.every((m) => m.passed), marks, ...(score && { score }) };
}

/**
 * Judges the answer to a task: its part against the target part, and the rules of the task. Any program that makes the
 * part within the rules passes, however it is written.
 */
export function judge(task: Task, answer: Answer): TaskJudgement {
  const unplaced = judgeUnplaced(task, answer);
  const marks = unplaced.marks.map((mark) =>
    mark.passed || !SHAPED.has(mark.rule) ? mark : { ...mark, ...shapedBy(answer, mark) },
  );
  return { ...unplaced, marks };
}

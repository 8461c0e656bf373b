import type { AnyIssue } from "../i18n/message-texts.ts";
import type { Issue } from "../kernel/plan/issue.ts";
import { part } from "../kernel/geometry/point.ts";
import { fixesFinding, offerOf, withOffer } from "../kernel/plan/offer.ts";
import { parse } from "../nc/parse.ts";
import type { Job } from "../program/job/job.ts";
import { run } from "../program/run/run.ts";
import type { Run } from "../program/state/run-types.ts";
import type { Shop } from "../program/state/shop.ts";
import { stockIssues } from "../sim/issues.ts";
import { simulate } from "../sim/simulate.ts";

type Found = AnyIssue;

/** How a job is run: its printed text, and the shop. */
export interface JobRunner {
  readonly print: (job: Job) => string;
  readonly shop: (job: Job) => Shop;
}

/** Most steps of a checked run, and turns of its threads: each turn is cut like a step. */
const MOST_CHECKED = 300;

/** Whether a check takes no longer than a frame or two. */
function isCheckedSoon({ steps }: Run): boolean {
  let cost = steps.length;
  for (const { from, move } of steps)
    if (move.kind === "thread") cost += part.apart(from, move.to) / Math.abs(move.pitch);
  return cost <= MOST_CHECKED;
}

const atOf = (found: Found): string | undefined => ("at" in found ? found.at : undefined);

/** The job with the value that a finding offers for one of its prompts; null where it offers none. */
function withOffered(job: Job, found: Found): Job | null {
  const [offer, q, draft] = [offerOf(found as Issue), atOf(found), job.drafts[job.cycle] ?? {}];
  if (offer === null || q === undefined || !(q in draft)) return null;
  return { ...job, drafts: { ...job.drafts, [job.cycle]: { ...draft, [q]: String(offer) } } };
}

/**
 * Tries the values that findings of prompts and set-up offer, with a run and a check of the job's program. An invalid
 * value gets the offer that the run found for it; a question is asked only where its other sign mends it. What takes
 * long to check is not offered. Nothing is run where nothing is offered.
 */
export function triedDraft(
  job: Job,
  { print, shop }: JobRunner,
  invalid: readonly Issue[],
  questions: readonly Found[],
): readonly Found[] {
  if (![...invalid, ...questions].some((found) => withOffered(job, found))) return [...invalid, ...questions];
  const issuesOf = (tried: Job): readonly Found[] | null => {
    const ran = run(parse(print(tried)), shop(tried)),
      issues = ran.issues.map(({ issue }) => issue);
    // Without a whole path the check has nothing to add.
    if (issues.some(({ severity }) => severity === "error")) return issues;
    if (!isCheckedSoon(ran)) return null;
    return [...issues, ...stockIssues(simulate(ran)).map(({ issue }) => issue)];
  };
  const before = issuesOf(job) ?? [];
  const mends = (found: Found, tried: Job): boolean => {
    const after = issuesOf(tried);
    return after !== null && fixesFinding(found as Issue, before as readonly Issue[], after as readonly Issue[]);
  };
  return [
    ...invalid.map((found) => {
      if (!withOffered(job, found)) return found;
      const ran = before.find((each) => each.code === found.code && atOf(each) === found.at);
      const offered = withOffer(found, ran ? offerOf(ran as Issue) : null);
      const tried = withOffered(job, offered);
      return !tried || mends(offered, tried) ? offered : withOffer(found, null);
    }),
    ...questions.filter((found) => {
      const tried = withOffered(job, found);
      return !tried || mends(found, tried);
    }),
  ];
}

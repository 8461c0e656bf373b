import type { Action } from "../planning/types.ts";
import type { MissingTool, OtherWay, Residue, StepReason, WorkingPlan } from "../planning/working-plan.ts";
import type { PlanTexts } from "./en/plan.ts";
import type { Language } from "./languages.ts";
import { writer } from "./write.ts";

/** What the sentences of a plan are made of: its texts, the language of numbers, and how a time in s is written. */
export interface PlanWriter {
  readonly t: PlanTexts;
  readonly language: Language;
  readonly time: (seconds: number) => string;
}

/** A way in a few words: its cycle and its tool. */
export const planWayText = ({ t }: PlanWriter, cycle: number | null, tool: number, name = ""): string =>
  `${cycle === null ? t.steps.pathBlocks : t.steps.cycle(String(cycle))}, ${t.steps.tool(String(tool), name)}`;

/** The way of an action, with the name of its tool. */
export const planActionText = (w: PlanWriter, { cycle, tool }: Action): string =>
  planWayText(w, cycle, tool.T, tool.NAME);

/** Why a step is what it is. `own`: its action. */
export function planReasonText(w: PlanWriter, reason: StepReason, own: Action): string {
  const { because } = w.t;
  const way = (cycle: number | null, tool: number): string =>
    cycle === own.cycle && tool === own.tool.T ? because.samePath : planWayText(w, cycle, tool);
  switch (reason.kind) {
    case "onlyTool":
      return because.onlyTool;
    case "onlyCycle":
      return reason.cycle === null ? because.onlyPath : because.onlyCycle;
    case "faster":
      return because.faster(w.time(reason.seconds), way(reason.cycle, reason.tool));
    case "equal":
      return because.equal(way(reason.cycle, reason.tool));
    case "takesMore":
      return because.takesMore(writer(w.language).area(reason.area), way(reason.cycle, reason.tool));
    case "ownTool":
      return because.ownTool(way(reason.cycle, reason.tool));
    case "undersize":
      return because.undersize(`T${reason.tool}`);
    case "inOneCall":
      return because.inOneCall;
    case "sameTool":
      return because.sameTool;
    case "rule":
      return because.rules[reason.rule];
    case "rest":
      return because.rest(reason.step + 1);
    case "unfinished":
      return because.unfinished(
        [
          ...(reason.area > 0 ? [writer(w.language).area(reason.area)] : []),
          ...reason.threads.map((name) => w.t.left.thread(name)),
        ].join(", "),
      );
    case "byHand":
      return because.byHand;
  }
}

/** Shorter differences of time, s, and smaller ones of material, mm² of the half plane, are none. */
const SAME_RESULT = { seconds: 0.5, area: 0.05 };

/** What another way takes longer, and what it leaves or takes more; the same result where it differs in neither. */
export function planDifferenceText(w: PlanWriter, { longer, leaves }: Pick<OtherWay, "longer" | "leaves">): string {
  const { area } = writer(w.language);
  const { steps } = w.t;
  const differences = [
    ...(Math.abs(longer) < SAME_RESULT.seconds
      ? []
      : [(longer > 0 ? steps.longer : steps.shorter)(w.time(Math.abs(longer)))]),
    ...(Math.abs(leaves) < SAME_RESULT.area
      ? []
      : [(leaves > 0 ? steps.leaves : steps.takesMore)(area(Math.abs(leaves)))]),
  ];
  return differences.length === 0 ? steps.sameResult : differences.join(" · ");
}

/** The smallest data of a missing tool. */
export function missingToolText({ t: { left }, language }: PlanWriter, tool: MissingTool): string {
  const { length, angle } = writer(language);
  const of = (words: (text: string) => string, value: number | undefined, write = length) =>
    value === undefined ? [] : [words(write(value))];
  return [
    left.forms[tool.form],
    left.where[tool.site],
    ...(tool.hand ? [left[tool.hand]] : []),
    ...(tool.thread === undefined ? [] : [left.forThread(tool.thread)]),
    ...of(left.rises, tool.rises, angle),
    ...of(left.descends, tool.descends, angle),
    ...of(left.leastEdge, tool.leastEdge, angle),
    ...of(left.mostNose, tool.mostNose),
    ...of(left.mostWidth, tool.mostWidth),
    ...of(left.leastDepth, tool.leastDepth),
    ...(tool.across ? [left.across(length(tool.across[0]), length(tool.across[1]))] : []),
    ...of(left.mostDiameter, tool.mostDiameter),
    ...of(left.leastReach, tool.leastReach),
  ].join(", ");
}

/** The place of a region: Z of its ends. */
export const regionPlaceText = (
  { t, language }: Pick<PlanWriter, "t" | "language">,
  box: { readonly left: number; readonly right: number },
): string => t.left.at(writer(language).signed(box.right), writer(language).signed(box.left));

/** What is left: its area or its thread, with its place and the reason. */
export function residueText(w: PlanWriter, { region, thread, site, why }: Residue): string {
  const { left } = w.t;
  const what = region
    ? `${left.region(writer(w.language).area(region.area), left.where[site])}, ${regionPlaceText(w, region.box)}`
    : left.thread(thread);
  return `${what}: ${left.why[why]}`;
}

/** What a plan achieves: the sentence, whether the plan is complete, and whether its program is. */
export interface PlanVerdict {
  readonly text: string;
  readonly isGood: boolean;
  readonly isProved: boolean;
}

/** What a plan achieves, in a few words: the verdict is that of its whole program. */
export function planVerdict({ t, language }: PlanWriter, plan: WorkingPlan): PlanVerdict {
  const { result } = t;
  const { area } = writer(language);
  const isProved = plan.judged.verdict === "proved" && plan.gouge <= 0.01;
  const bad = (text: string) => ({ text, isGood: false, isProved });
  // The check finds damage behind the planned contour, too.
  const damage = plan.judged.reasons.reduce(
    (most, reason) => (reason.kind === "gouge" ? Math.max(most, reason.area) : most),
    plan.gouge,
  );
  if (damage > 0.01) return bad(result.damage(area(damage)));
  if (plan.judged.verdict === "faults") return bad(result.faults);
  if (plan.steps.length === 0) return bad(t.run.none);
  if (plan.judged.verdict === "incomplete") return bad(result.unchecked);
  const open = plan.residue.filter(({ why }) => why !== "rear" && why !== "clamping");
  const threads = open.filter(({ region }) => region === null).length,
    left = open.reduce((sum, { region }) => sum + (region?.area ?? 0), 0);
  const [first, second] = [...(threads > 0 ? [result.threads(threads)] : []), ...(left > 0 ? [area(left)] : [])];
  if (first !== undefined) return bad(result.left(second === undefined ? first : result.threadsAndArea(first, second)));
  return { text: plan.residue.length > 0 ? result.rest : result.complete, isGood: plan.isComplete, isProved };
}

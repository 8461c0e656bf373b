import { writer } from "../src/i18n/write.ts";
import type { Action } from "../src/planning/types.ts";
import type {
  MissingTool,
  OtherWay,
  PlanStep,
  Residue,
  StepReason,
  WorkingPlan,
} from "../src/planning/working-plan.ts";

/* What `npm run plan` says about a plan on standard error, in English as every command. */

const { area, length, angle, signed } = writer("en");

const seconds = (s: number): string => {
  const whole = Math.round(s);
  return whole < 60 ? `${whole} s` : `${Math.floor(whole / 60)} min ${whole % 60} s`;
};

const cycleWords = (cycle: number | null) => (cycle === null ? "path blocks" : `cycle ${cycle}`);
const wayWords = ({ cycle, tool }: { readonly cycle: number | null; readonly tool: number }) =>
  `${cycleWords(cycle)} with T${tool}`;
const actionWords = ({ cycle, tool }: Action) => wayWords({ cycle, tool: tool.T });

const RULES = {
  roughBeforeFinish: "roughing before finishing",
  outsideBeforeInside: "outside before bore",
  longBeforeThin: "long sections before thin ones",
  tolerancedLast: "toleranced surfaces last",
  undercutBeforeThread: "undercut before thread",
  faceFirst: "face first",
} as const;

function reasonWords(reason: StepReason): string {
  switch (reason.kind) {
    case "onlyTool":
      return `T${reason.tool} is the only tool that reaches it`;
    case "onlyCycle":
      return `only ${cycleWords(reason.cycle)} ${reason.cycle === null ? "work" : "works"} here`;
    case "faster":
      return `${seconds(reason.seconds)} faster than ${wayWords(reason)}`;
    case "equal":
      return `as quick as ${wayWords(reason)}, the usual way`;
    case "takesMore":
      return `removes ${area(reason.area)} more than ${wayWords(reason)}`;
    case "sameTool":
      return "no tool change";
    case "rule":
      return RULES[reason.rule];
    case "rest":
      return `removes what operation ${reason.step + 1} left`;
    case "unfinished":
      return `not made before: ${[...(reason.area > 0 ? [area(reason.area)] : []), ...reason.threads].join(", ")}`;
    case "byHand":
      return "set by hand";
  }
}

const otherWords = ({ tried, longer, leaves }: OtherWay): string =>
  [
    `or ${actionWords(tried.action)}:`,
    Math.abs(longer) < 0.5 ? "as long" : longer > 0 ? `${seconds(longer)} longer` : `${seconds(-longer)} shorter here`,
    ...(Math.abs(leaves) < 0.05 ? [] : [leaves > 0 ? `leaves ${area(leaves)} more` : `removes ${area(-leaves)} more`]),
  ].join(" ");

function stepLines({ tried, seconds: time, why, others }: PlanStep, i: number, titles: Titles): readonly string[] {
  const reasons = why.map(reasonWords).join("; ");
  return [
    `${String(i + 1).padStart(2)}. ${titles(tried.action)}: ${actionWords(tried.action)} ${tried.action.tool.NAME}, ${seconds(time)}` +
      (reasons === "" ? "" : ` (${reasons})`),
    ...others.map((other) => `      ${otherWords(other)}`),
  ];
}

const FORMS = {
  turning: "turning tool",
  recessing: "recessing tool",
  boring: "boring bar",
  drill: "drill",
  thread: "threading tool",
} as const;
const SITES = { outside: "outside", inside: "in the bore", face: "on the face" } as const;
const WHY = {
  tool: "no tool of the table reaches it",
  excluded: "a tool or cycle that makes it is excluded",
  clamping: "covered by the clamping",
  rear: "reached only from the rear end",
  fault: "every way that was tried stopped with a fault",
  bound: "the search ended before",
} as const;

function missingWords(tool: MissingTool): string {
  const data = [
    tool.hand && `${tool.hand} hand`,
    tool.descends !== undefined && `clears a flank of ${angle(tool.descends)}`,
    tool.leastEdge !== undefined && `setting angle at least ${angle(tool.leastEdge)}`,
    tool.mostNose !== undefined && `nose radius up to ${length(tool.mostNose)}`,
    tool.mostWidth !== undefined && `blade up to ${length(tool.mostWidth)} wide`,
    tool.leastDepth !== undefined && `cutting depth at least ${length(tool.leastDepth)}`,
    tool.mostDiameter !== undefined && `⌀ up to ${length(tool.mostDiameter)}`,
    tool.leastReach !== undefined && `reach at least ${length(tool.leastReach)}`,
    tool.thread !== undefined && `for ${tool.thread}`,
  ];
  return [`needs a ${FORMS[tool.form]} ${SITES[tool.site]}`, ...data.filter(Boolean)].join(", ");
}

function residueLine({ region, site, why, missing }: Residue): string {
  const what = region
    ? `${area(region.area)} ${SITES[site]}, Z${signed(region.box.right)} to Z${signed(region.box.left)}`
    : `thread ${missing?.thread ?? ""}`;
  return `left: ${what}: ${WHY[why]}${missing ? `; ${missingWords(missing)}` : ""}`;
}

const VERDICTS = {
  proved: "proved",
  faults: "the check found faults",
  incomplete: "not everything was simulated",
} as const;

/** Title of an action. */
export type Titles = (action: Action) => string;

/** A plan as lines: its steps with their reasons, what is left, time and verdict. */
export function planLines(plan: WorkingPlan, titles: Titles): readonly string[] {
  return [
    ...plan.steps.flatMap((step, i) => stepLines(step, i, titles)),
    ...plan.residue.map(residueLine),
    ...(plan.gouge > 0.01 ? [`contour damage: ${area(plan.gouge)}`] : []),
    `${seconds(plan.seconds)}, ${plan.tools.length} tools, ${plan.toolChanges} tool changes: ${VERDICTS[plan.judged.verdict]}`,
  ];
}

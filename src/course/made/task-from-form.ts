import type { LessonLanguage } from "../../i18n/languages.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { areaOf } from "../../kernel/area/area.ts";
import { difference, intersection, union } from "../../kernel/area/clip.ts";
import { toDiameter } from "../../kernel/units.ts";
import { parse } from "../../nc/parse.ts";
import { lessPlainCuts, machiningArea } from "../../sim/finished.ts";
import { producedParts } from "../../sim/produced-parts.ts";
import { calledTools } from "../judge/rules.ts";
import { judge } from "../judge/judge.ts";
import type { Answer, RuleName } from "../judge/judgement.ts";
import { TASK_FORMAT, taskSchema, type Task, type TaskRules } from "../task.ts";
import { promptsText } from "../prompts.ts";
import { targetPart } from "../target-part.ts";
import { withFaults } from "./faults.ts";
import { NUMBER_RULES, type TaskForm, type RuleDraft, type WordsDraft } from "./task-form.ts";
import { isComplete, predictionOf } from "./made-questions.ts";
import { wordsOfForm } from "./form-words.ts";
import { grooveFilling, threadsOf, targetThread, type ThreadDraft } from "./made-threads.ts";
import { contourSources } from "./contour-sources.ts";
import { outlineText } from "./outline-text.ts";

/*
 * A task made from a program: the program is its answer, and the part that it makes is the target part. Everything is
 * proposed and can be edited.
 */

/** Limits that every answer breaks, so that the judge reports the actual values. */
const ASK_ALL: TaskRules = { depth: 0, speed: 0, mostTools: 0, seconds: 0, passes: -1 };

/** Lines of a program without their numbers. */
const bare = (raw: string): string => raw.trim().replace(/^\/?\d+[ \t]+/, "");
export const linesOfText = (text: string): string[] =>
  text
    .split(/\r?\n/)
    .map((line) => line.trimEnd())
    .filter((line) => line.trim() !== "");

/** The lines that define the blank of a program, then the contours that they name. */
function blankLines(text: string): readonly string[] {
  const { blocks } = parse(text);
  const found = blocks.filter(({ statement: { kind } }) => /^blank/.test(kind)).map(({ raw }) => bare(raw));
  const labels = new Set(
    found.flatMap((line) => [.../\bLBL(?:IN)?\s+(\d+)/g[Symbol.matchAll](line)].map(([, label]) => Number(label))),
  );
  const behind = [...labels].flatMap((label) => {
    const from = blocks.findIndex(({ statement: s }) => s.kind === "label" && s.label === label);
    const rest = from < 0 ? [] : blocks.slice(from);
    const end = rest.findIndex(({ statement: s }) => s.kind === "label" && s.label === 0);
    return rest.slice(0, end + 1).map(({ raw }) => bare(raw));
  });
  return [...found, ...behind];
}

/** The greatest values that the judge measures, by rule. */
function found(task: Task, answer: Answer): ReadonlyMap<RuleName, number> {
  const values = new Map<RuleName, number>();
  for (const { rule, value } of judge(task, answer).marks)
    if (value !== undefined && Number.isFinite(value)) values.set(rule, Math.max(values.get(rule) ?? 0, value));
  return values;
}

/** A value rounded up to a step. */
const above = (value: number | undefined, step: number, share = 1): string =>
  value === undefined ? "" : String(Math.round(Math.ceil((value * share) / step - ROUNDED) * step * 1000) / 1000);
const ROUNDED = 0.001;
/** Steps to which proposed limits are rounded up: mm, rpm, s, mm², µm; and the extra share of time allowed. */
const STEPS = { depth: 0.1, speed: 100, seconds: 10, residue: 0.1, rz: 1 } as const,
  LONGER = 1.3;

/** The sources of a part's outlines: the finished contours of the program, or the made stock. */
export const PART_SOURCES = ["contours", "made"] as const;
export type PartSource = (typeof PART_SOURCES)[number];

/** The outlines of the part that an answer makes; chosen threads are drawn by their crest. */
export function outlinesFrom(
  answer: Answer,
  from: PartSource,
  threads: readonly ThreadDraft[],
): Pick<TaskForm, "outside" | "bore"> {
  const { run, simulation } = answer;
  const made = producedParts(simulation);
  const parts = from === "contours" ? union(run.operations.map(({ plan }) => plan.part)) : [];
  const contours =
    parts.length > 0
      ? lessPlainCuts(intersection(run.blank, difference(parts, machiningArea(run.operations))), simulation)
      : [];
  const grooves = threads
    .filter(({ on }) => on)
    .map((thread) => grooveFilling(thread, made))
    .filter((ring) => ring.length > 2);
  const shape = contours.length > 0 ? contours : made,
    rings = grooves.length > 0 ? union([...shape, ...grooves]) : shape;
  const { outside = [], bore = [] } = outlineText(rings, run.blank, contourSources(answer));
  return { outside: outside.join("\n"), bore: bore.join("\n") };
}

/** The target part of a form. */
export function targetPartOfForm({
  blank,
  outside,
  bore,
  threads,
}: Pick<TaskForm, "blank" | "outside" | "bore" | "threads">): NonNullable<Task["part"]> {
  const [outer, inner] = [linesOfText(outside), linesOfText(bore)],
    asked = threads.filter(({ on }) => on).map(targetThread);
  return {
    blank: linesOfText(blank),
    ...(outer.length > 0 && { outside: outer }),
    ...(inner.length > 0 && { bore: inner }),
    ...(asked.length > 0 && { threads: asked }),
  };
}

/** Whether a form has a target part at all. */
export const hasTargetPart = ({ kind, blank, outside, bore }: TaskForm): boolean =>
  kind !== "predict" && `${blank}${outside}${bore}`.trim() !== "";

/** Whether a kind asks questions before the run: to predict it, or to find a fault by reading. */
export const hasQuestions = (kind: Task["kind"]): boolean => kind === "predict" || kind === "fault";

const NO_WORDS: WordsDraft = { title: "", ask: "", hints: ["", "", ""] };

/** A form filled in from a program; texts, kind and start are left to the instructor. */
export function proposedTask(answer: Answer): TaskForm {
  const { run } = answer;
  const blank = blankLines(answer.text).join("\n");
  const threads = threadsOf(answer);
  const made = { blank, ...outlinesFrom(answer, "contours", threads), threads };
  const wanted = targetPart(targetPartOfForm(made)),
    { left, right } = boxAround([...wanted.rings]);
  const probe: Task = {
    format: TASK_FORMAT,
    id: "probe",
    kind: "make",
    start: { empty: true },
    part: targetPartOfForm(made),
    rules: { ...ASK_ALL, residue: 0, missing: 0, rz: [{ from: left, to: right, most: 0 }] },
    words: {},
  };
  const is = found(probe, answer);
  const tools = [...calledTools(answer).keys()],
    cycles = [...new Set(run.operations.map(({ cycle }) => cycle))];
  const off = (text: string): RuleDraft => ({ on: false, text }),
    on = (text: string): RuleDraft => ({ on: text !== "", text });
  const residue = Math.max(0.5, Number(above(is.get("residue"), STEPS.residue, LONGER)));
  const missing = Math.max(0.1, Number(above(is.get("missing"), STEPS.residue, LONGER)));
  return {
    kind: "make",
    ...made,
    material: null,
    sizes: [],
    rules: {
      depth: on(above(is.get("depth"), STEPS.depth)),
      speed: on(above(is.get("speed"), STEPS.speed)),
      mostTools: off(String(tools.length)),
      seconds: off(above(is.get("seconds"), STEPS.seconds, LONGER)),
      passes: off(String(is.get("passes") ?? "")),
      residue: on(String(residue)),
      missing: on(String(missing)),
      rz: off(above(is.get("rz"), STEPS.rz)),
      cycles: off(cycles.join(", ")),
    },
    offer: "called",
    tools,
    clean: false,
    questions: [],
    start: "empty",
    prompts: { operation: 0, emptied: [] },
    faults: [],
    program: null,
    words: NO_WORDS,
  };
}

const numberOf = (text: string): number | null => {
  const value = Number(text.trim().replace(",", ".").replace("−", "-"));
  return text.trim() === "" || !Number.isFinite(value) ? null : value;
};
const numbersOf = (text: string): readonly number[] => text.split(/[,;\s]+/).flatMap((each) => numberOf(each) ?? []);

function rulesOf(form: TaskForm, answer: Answer): TaskRules {
  const { rules, clean, offer } = form;
  const made: Record<string, unknown> = {};
  for (const rule of NUMBER_RULES) {
    const { on, text } = rules[rule],
      value = numberOf(text);
    if (!on || value === null) continue;
    if (rule !== "rz") made[rule] = value;
    else {
      const { rings, outside } = targetPart(targetPartOfForm(form));
      const { left, right } = boxAround([...rings]);
      const turned = [...outside].flatMap((s) => [s.from.z, s.to.z]);
      made["rz"] = [{ from: Math.min(right, 0), to: turned.length > 0 ? Math.min(...turned) : left, most: value }];
    }
  }
  if (rules.cycles.on) made["cycles"] = [...numbersOf(rules.cycles.text)];
  if (offer !== "all") made["tools"] = offer === "called" ? [...calledTools(answer).keys()] : [...form.tools];
  return { ...made, ...(clean && { clean }) };
}

/** The lines of the contour that a cycle call follows. */
function contourLines(
  text: string,
  lines: readonly { readonly line: number; readonly file?: string }[],
): readonly string[] {
  const own = lines.filter(({ file }) => file === undefined).map(({ line }) => line);
  const all = text.split(/\r?\n/);
  if (own.length === 0) return [];
  const from = all.slice(0, Math.min(...own)).findLastIndex((line) => /\bLBL\b/.test(line));
  const length = all.slice(from + 1).findIndex((line) => /\bLBL\s+0\b/.test(line));
  return all.slice(from + 1, from + 1 + Math.max(0, length)).map(bare);
}

/** The values of a cycle call as typed in its prompts. */
export function promptsOf({ run }: Answer, operation: number): readonly (readonly [string, string])[] {
  const values = run.operations[operation]?.call?.values ?? {};
  return Object.entries(values)
    .filter((entry): entry is [string, number] => typeof entry[1] === "number")
    .map(([q, value]) => [q, String(value)] as const);
}

function startOf(made: TaskForm, answer: Answer): Task["start"] {
  const {
    start,
    prompts: { operation: index, emptied },
  } = made;
  const operation = answer.run.operations[index];
  if (start === "program") return { program: [...learnerProgramOfForm(made, answer)] };
  if (start === "empty" || !operation) return { empty: true };
  const contour = contourLines(answer.text, operation.contourLines ?? []);
  const { left, right, low, high } = boxAround([...answer.run.blank]);
  const isPlain = answer.run.blank.length === 1 && answer.run.blank[0]?.length === 4;
  const across = (r: number) => String(toDiameter(r as typeof operation.start.r));
  return {
    cycle: operation.cycle,
    values: Object.fromEntries(promptsOf(answer, index).filter(([q]) => !emptied.includes(q))),
    tool: operation.tool.T,
    at: { x: across(operation.start.r), z: String(operation.start.z) },
    ...(isPlain && {
      blank: {
        outside: across(high),
        bore: low > 0 ? across(low) : "",
        length: String(right - left),
        allowance: String(right),
      },
    }),
    ...(contour.length > 0 && { contour: [...contour] }),
  };
}

/** The program that the learner starts with. */
export const learnerProgramOfForm = ({ program, faults }: TaskForm, { text }: Answer): readonly string[] =>
  program === null ? withFaults(linesOfText(text), faults) : linesOfText(program);

/** The starting state as a program; null where it is an empty program, or the cycle of the prompts is unknown. */
export function startProgramOfForm(made: TaskForm, answer: Answer): string | null {
  if (made.start === "empty") return null;
  if (made.start === "program") return learnerProgramOfForm(made, answer).join("\n");
  return promptsText({
    format: TASK_FORMAT,
    id: "probe",
    kind: "make",
    start: startOf(made, answer),
    rules: {},
    words: {},
  });
}

/** Why a form is not a task yet. */
export type FormFault = "title" | "ask" | "part" | "shape" | "questions" | "noQuestion" | "begins";

function questionFaults({ kind, questions, start }: TaskForm): readonly FormFault[] {
  if (!hasQuestions(kind)) return [];
  if (questions.length === 0) return kind === "predict" ? ["noQuestion"] : [];
  return [
    ...(questions.some((each) => !isComplete(each)) ? ["questions" as const] : []),
    ...(start === "empty" ? ["begins" as const] : []),
  ];
}

/** A title as an id; `mark` keeps two equal titles apart. */
const idOf = (title: string, mark: string): string =>
  `${
    title
      .normalize("NFKD")
      .toLowerCase()
      .replace(/[^a-z0-9]+/g, "-")
      .replace(/^-|-$/g, "")
      .slice(0, 36) || "task"
  }-${mark}`;

/** The task of a form, or what is missing. `mark`: a short text of letters and digits that distinguishes this task. */
export function taskOfForm(
  made: TaskForm,
  answer: Answer,
  language: LessonLanguage,
  mark: string,
): Task | readonly FormFault[] {
  const {
    words: { title, ask },
    kind,
  } = made;
  const foretells = kind === "predict",
    hasPart = hasTargetPart(made);
  const part = targetPartOfForm(made),
    wanted = hasPart ? targetPart(part) : null;
  const faults: FormFault[] = [
    ...(title.trim() === "" ? ["title" as const] : []),
    ...(ask.trim() === "" ? ["ask" as const] : []),
    ...(wanted && (wanted.issues.length > 0 || wanted.rings.length === 0 || areaOf(wanted.rings) === 0)
      ? ["part" as const]
      : []),
    ...questionFaults(made),
  ];
  if (faults.length > 0) return faults;
  const sizes = made.sizes
    .filter(({ on }) => on)
    .map(({ kind: of, at, nominal, upper, lower }) => ({
      kind: of,
      at,
      nominal,
      upper: numberOf(upper) ?? 0,
      lower: numberOf(lower) ?? 0,
    }));
  const asked = hasQuestions(kind) ? made.questions : [];
  const judged = {
    ...(hasPart && { part }),
    ...(sizes.length > 0 && { sizes }),
    ...(made.material !== null && { material: made.material }),
    rules: rulesOf(made, answer),
    ...(kind === "drawing" && {
      par: { seconds: Math.ceil(answer.simulation.totalSeconds), tools: calledTools(answer).size },
    }),
    solution: linesOfText(answer.text),
  };
  const read = taskSchema.safeParse({
    format: TASK_FORMAT,
    id: idOf(title, mark),
    kind,
    start: startOf(made, answer),
    ...(asked.length > 0 && { predict: asked.map(predictionOf) }),
    words: wordsOfForm(made, asked, language),
    ...(!foretells && judged),
  });
  return read.success ? read.data : ["shape"];
}

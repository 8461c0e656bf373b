import fc from "fast-check";
import { answerOf } from "../../src/course/judge/answer.ts";
import { judge } from "../../src/course/judge/judge.ts";
import type { RuleName, TaskJudgement } from "../../src/course/judge/judgement.ts";
import { TASK_FORMAT, taskSchema, type Task } from "../../src/course/task.ts";

/** Uneven sizes on the grid of a control. */
export const mm = (min: number, max: number) =>
  fc.integer({ min: Math.round(min * 1000), max: Math.round(max * 1000) }).map((n) => n / 1000);

/**
 * A shoulder turned by hand in one pass: blank ⌀, finished ⌀, and length; the tool leaves its nose radius in the
 * corner.
 */
export interface Shoulder {
  readonly outer: number;
  readonly diameter: number;
  readonly length: number;
}
/** Nose radius of tool 1, mm. */
export const NOSE = 0.8;
/** Length of the blank behind the shoulder, mm. */
const BEHIND = 31.7;

export const shoulders: fc.Arbitrary<Shoulder> = fc
  .tuple(mm(41, 90), mm(1.3, 8), mm(9, 60))
  .map(([outer, depth, length]) => ({
    outer,
    diameter: Math.round((outer - 2 * depth) * 1000) / 1000,
    length,
  }));

interface Written {
  readonly unit?: "MM" | "INCH";
  readonly tool?: number;
  readonly spin?: string;
  readonly feed?: number;
  /** Lines that replace the two blocks for the shoulder. */
  readonly cuts?: readonly string[];
  readonly blank?: string;
  readonly before?: readonly string[];
}

export const blankLine = ({ outer, length }: Shoulder) =>
  `BLK FORM CYLINDER Z D${outer} L${(length + BEHIND).toFixed(3)} DIST+0`;
const INCH = 25.4;

/**
 * A whole program. Block 6 moves to the front of the face, 7 turns along the cylinder, 8 retracts along the shoulder.
 */
export function programOf(
  s: Shoulder,
  { unit = "MM", tool = 1, spin, feed = 0.2, cuts, blank, before = [] }: Written = {},
): string {
  const n = (size: number) => (unit === "MM" ? `${size}` : (size / INCH).toFixed(7).replace(/\.?0+$/, ""));
  const cylinder = unit === "MM" ? blankLine(s) : `BLK FORM CYLINDER Z D${n(s.outer)} L${n(s.length + BEHIND)} DIST+0`;
  return [
    `0 BEGIN PGM HAND ${unit}`,
    `1 ${blank ?? cylinder}`,
    "2 FUNCTION MODE TURN",
    `3 TOOL CALL ${tool}`,
    `4 ${spin ?? (unit === "MM" ? "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500" : "FUNCTION TURNDATA SPIN VCONST:OFF S900")}`,
    "5 M136",
    ...before,
    `6 L X${n(s.diameter)} Z${n(2)} R0 FMAX M303`,
    ...(cuts ?? [`7 L Z-${n(s.length)} F${unit === "MM" ? feed : (feed / INCH).toFixed(5)}`, `8 L X${n(s.outer + 2)}`]),
    `9 L Z${n(50)} FMAX`,
    "10 M30",
    `11 END PGM HAND ${unit}`,
  ].join("\n");
}

/** A task for a shoulder with the nose radius in its corner. */
export const taskOf = (s: Shoulder, more: Partial<Task> = {}): Task =>
  taskSchema.parse({
    format: TASK_FORMAT,
    id: "law",
    kind: "make",
    start: { empty: true },
    part: {
      blank: [blankLine(s)],
      outside: ["L X+0 Z+0", `L X${s.diameter}`, `L Z-${s.length}`, `RND R${NOSE}`, `L X${s.outer}`],
    },
    words: {},
    ...more,
  });

export const judged = (task: Task, text: string): TaskJudgement => judge(task, answerOf(text));
export const refusedBy = (judgement: TaskJudgement): RuleName[] => [
  ...new Set(judgement.marks.filter((m) => !m.passed).map((m) => m.rule)),
];
export const sumOf = ({ marks }: TaskJudgement, rule: RuleName): number =>
  marks.filter((m) => m.rule === rule).reduce((sum, m) => sum + (m.value ?? 0), 0);

import { z } from "zod/mini";
import { usualTable } from "../program/tools/cutting-table.ts";
import { RULES } from "./judge/judgement.ts";
import { inLanguages, words } from "./words.ts";

/*
 * A task is one file: the assignment, the starting state, the target part, the rules of the judgement, hints, one
 * answer that passes, and wrong answers with the place of each fault. docs/tasks.md describes it for instructors.
 */

export const TASK_FORMAT = "turnwise-task/1";

/** Most lines of a program in a task, and most entries of any other list. */
const MOST = { lines: 2000, listed: 60 };
/** Most hints of a task. */
export const HINTS = 3;
const id = z.string().check(z.regex(/^[a-z0-9][a-z0-9-]{1,60}$/));
const lines = z.array(z.string().check(z.maxLength(200))).check(z.minLength(1), z.maxLength(MOST.lines));
const listed = <S extends z.core.$ZodType>(schema: S) => z.array(schema).check(z.maxLength(MOST.listed));
const typed = z.string().check(z.maxLength(40));
/** Greatest number in a task, in any unit: no lathe is a kilometre long. */
const LARGEST = 1_000_000;
const finite = z.number().check(z.gte(-LARGEST), z.lte(LARGEST));

/** What opens when the task starts: prompts of one cycle, a program, or an empty program. */
const start = z.union([
  z.object({
    /** Number of the cycle whose prompts open. */
    cycle: z.int(),
    /** Given values, as typed, by Q; the other prompts are empty. */
    values: z._default(z.record(z.string().check(z.regex(/^Q\d+$/)), typed), {}),
    /** Blank as typed, mm: outside and bore as ⌀; absent: proposed. */
    blank: z.optional(z.object({ outside: typed, bore: typed, length: typed, allowance: typed })),
    tool: z.optional(finite),
    /** Tip at the cycle call, ⌀ and Z. */
    at: z.optional(z.object({ x: typed, z: typed })),
    /** Contour as lines of a contour subprogram, without LBL, for cycles that follow one. */
    contour: z.optional(lines),
  }),
  z.object({ program: lines }),
  z.object({ empty: z.literal(true) }),
]);

/**
 * The target part. `outside` is its outline as lines of a contour subprogram, from the axis or the bore at the free end
 * to the unmachined blank; behind the last point (farther along −Z) the part is as the blank. `bore` is the outline of
 * the hollow, from the free end inwards to the unmachined hollow or the solid of the blank.
 */
const part = z.object({
  /** `BLK FORM` line or lines. */
  blank: lines,
  outside: z.optional(lines),
  bore: z.optional(lines),
  /**
   * Threads; the outline draws their crest. Between crest and root (⌀) there must be grooves over the full length,
   * nearly down to the root, `pitch` mm apart if given. `name` is for the drawing: "M36×2".
   */
  threads: z.optional(
    listed(z.object({ from: finite, to: finite, crest: finite, root: finite, pitch: z.optional(finite), name: typed })),
  ),
});

/** A size measured on the made part. Nominal and measured sizes mm; `upper` and `lower` are deviations. */
const size = z.object({
  /**
   * "diameter": outside at Z = at; "bore": inside at Z = at; "face": Z of the first material from the free end at ⌀ =
   * at.
   */
  kind: z.enum(["diameter", "bore", "face"]),
  at: finite,
  nominal: finite,
  upper: finite,
  lower: finite,
});

/**
 * The rules of the shop. An absent rule is not checked; contour damage on the target part and rapids in stock are never
 * allowed.
 */
const rules = z.object({
  /** Most excess material on the target part, mm² of the half section; by default 0.05. */
  residue: z.optional(finite),
  /** Most material missing from it, mm²; by default 0.01. */
  missing: z.optional(finite),
  /** Whether warnings fail the task too; default: only errors do. */
  clean: z.optional(z.boolean()),
  /** Greatest actual depth of a roughing pass, mm; greatest programmed spindle limit or speed, rpm. */
  depth: z.optional(finite),
  speed: z.optional(finite),
  /** The only tools that may be called; most tools; most seconds. */
  tools: z.optional(listed(finite)),
  mostTools: z.optional(z.int()),
  seconds: z.optional(finite),
  /** Cycles that must be called; cycles that must not. */
  cycles: z.optional(listed(z.int())),
  without: z.optional(listed(z.int())),
  /** Range of a parameter in every called cycle (only in `cycle`, if given): from and to, inclusive. */
  values: z.optional(
    listed(z.object({ q: typed, cycle: z.optional(z.int()), from: z.optional(finite), to: z.optional(finite) })),
  ),
  /** Exact number of roughing passes of all called cycles. */
  passes: z.optional(z.int()),
  /** Greatest theoretical Rz of the target part's surfaces, µm, between two Z. */
  rz: z.optional(listed(z.object({ from: finite, to: finite, most: finite }))),
  /** Words that must each be in the text of some block: "M136", "APPR LCT". */
  words: z.optional(listed(z.string().check(z.maxLength(200)))),
});

/** Predictions whose right answer comes from the kernel. */
const measured = [
  /**
   * A number: passes, real infeed mm, seconds, residue mm², or a size as in `sizes`. Tolerance `within`: by default
   * passes must be exact, the others agree to two decimals.
   */
  z.object({
    ask: z.enum(["passes", "infeed", "seconds", "residue"]),
    /** Index of the cycle call, from 0; absent: all together. */
    operation: z.optional(z.int()),
    within: z.optional(finite),
  }),
  z.object({ ask: z.enum(["diameter", "bore", "face"]), at: finite, within: z.optional(finite) }),
  /** A place on the part: residual material, contour damage, or the first rapid through material. Tolerance in mm. */
  z.object({ ask: z.enum(["residuePlace", "gougePlace", "rapidPlace"]), within: z._default(finite, 3) }),
] as const;
/** The element of the contour that a parameter shapes, as a place. Tolerance in mm. */
const elementPlace = z.object({ ask: z.literal("elementPlace"), q: typed, within: z._default(finite, 1) });
/** The right one of `words.choices`, from 0. */
const rightChoice = z.int();
/** Blocks with the fault: any of these numbers is right. */
const rightBlocks = listed(z.int()).check(z.minLength(1));

/** A question about a run; for `choice` and `block` it states the right answer. */
export const prediction = z.union([
  ...measured,
  elementPlace,
  z.object({ ask: z.literal("choice"), right: rightChoice }),
  z.object({ ask: z.literal("block"), right: rightBlocks }),
]);
/** The same in a task: what learners get of an exam does not state the right answer. */
const taskPrediction = z.union([
  ...measured,
  z.object({ ask: z.literal("choice"), right: z.optional(rightChoice) }),
  z.object({ ask: z.literal("block"), right: z.optional(rightBlocks) }),
]);

/** The id of a material of the shipped cutting data. */
export const materialId = z.enum(usualTable.materials.map((each) => each.id));

const taskWords = z.object({
  title: words,
  /** The assignment. An empty line begins a new paragraph. */
  ask: words,
  /** At most three stages: where to look; what is behind it; what to do. Those of the course have all three. */
  hints: z._default(z.array(words).check(z.maxLength(HINTS)), []),
  /** Questions before the run, one text for each of `predict`. */
  questions: z.optional(listed(words)),
  /** The options of a `choice`, one list for each of `predict` (empty for others). */
  choices: z.optional(listed(listed(words))),
  /** Shown when the task is passed: what was learned. */
  learned: z.optional(words),
});

/** The same questions with other values. A learner who answered wrongly gets the next ones at each try. */
const variant = z.object({
  /** Lines that replace those of the program which begin with the same block number or parameter. */
  with: lines,
  /** Numbers in the assignment, the questions and the choices, with what replaces them. */
  numbers: z._default(z.record(typed, typed), {}),
  /** The right choices and blocks that differ, by the index of the question. */
  right: z._default(z.record(z.string().check(z.regex(/^\d+$/)), rightChoice), {}),
  /** Texts that differ. Questions and choices: by the index of the question. */
  words: z.optional(
    inLanguages(
      z.object({
        ask: z.optional(words),
        questions: z.optional(z.record(z.string(), words)),
        choices: z.optional(z.record(z.string(), listed(words))),
      }),
    ),
  ),
});

/** An answer that must fail. */
const wrong = z.object({
  program: lines,
  /** The rule that it must fail. */
  rule: z.enum(RULES),
  /** The place of the fault on the part (⌀ and Z, within 3 mm) or its block; at least one of the two. */
  at: z.optional(z.object({ x: finite, z: finite })),
  block: z.optional(z.int()),
});

export const taskSchema = z.object({
  format: z.literal(TASK_FORMAT),
  id,
  /**
   * "make": make a part or a block; "fault": fix a program with a fault; "predict": predict the run, nothing is
   * written; "drawing": free programming from a workshop drawing, with a score.
   */
  kind: z.enum(["make", "fault", "predict", "drawing"]),
  start,
  part: z.optional(part),
  sizes: z.optional(listed(size)),
  /** Id of a material of the shipped cutting data: for the drawing's title block and the advice. */
  material: z.optional(materialId),
  /** The drawing takes its surface marks from `rules.rz`. */
  rules: z._default(rules, {}),
  predict: z.optional(listed(taskPrediction)),
  /** For a "predict" that starts with a program. Where there are none left, the kernel looks for other numbers. */
  variants: z.optional(listed(variant)),
  /** What a good answer of a "drawing" needs: seconds and tools for full marks. */
  par: z.optional(z.object({ seconds: finite, tools: z.int() })),
  words: inLanguages(taskWords),
  /**
   * Words as in `rules.words`: only an answer with all of them shows `words.learned`, which speaks of one of several
   * ways.
   */
  learnedBy: z.optional(listed(z.string().check(z.maxLength(200)))),
  /** An answer that passes, as a whole program; absent for "predict" alone. */
  solution: z.optional(lines),
  wrong: z.optional(listed(wrong)),
});

export type Task = z.infer<typeof taskSchema>;

/**
 * A task's id as shown in program names and on drawings: without the number of its original lesson. Lessons move, but
 * ids never change: progress is stored by them.
 */
export const shownId = ({ id }: Pick<Task, "id">): string => id.replace(/^l\d\d-/, "");

export type TaskRules = z.infer<typeof rules>;
export type WrongAnswer = z.infer<typeof wrong>;
export type TaskSize = z.infer<typeof size>;
export type SizeKind = TaskSize["kind"];
export type TaskPrediction = z.infer<typeof taskPrediction>;
/** A question of a task, or on the page of a lesson. */
export type Prediction = TaskPrediction | z.infer<typeof prediction>;
export type TaskVariant = z.infer<typeof variant>;
export type TaskWords = z.infer<typeof taskWords>;

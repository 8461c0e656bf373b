import { areaOf } from "../../kernel/area/area.ts";
import type { Task } from "../task.ts";
import type { TargetPart } from "../target-part.ts";
import { areaBeyond } from "./difference.ts";
import type { Answer, RuleName, Score, ScorePart, TaskMark } from "./judgement.ts";
import { calledTools } from "./rules.ts";
import { secondsOfAnswer } from "./shop.ts";

const POINTS = { proof: 40, residue: 20, time: 25, tools: 15 } as const;
/** Rules that must hold for any points: no speed is worth a broken tool. */
const NEVER: ReadonlySet<RuleName> = new Set(["errors", "unproved", "blank", "rapid", "holder", "gouge", "missing"]);
/** This share of the material to cut, left as residue, earns no points. */
const MOST_LEFT = 0.05;

const share = (part: number): number => Math.min(1, Math.max(0, part));

/** The score of a free program. `residue`: allowed excess, mm². */
export function scoreOf(
  par: NonNullable<Task["par"]>,
  wanted: TargetPart,
  residue: number,
  answer: Answer,
  marks: readonly TaskMark[],
): Score {
  const { final } = answer.simulation;
  const seconds = secondsOfAnswer(answer);
  const isSafe = marks.every((m) => m.passed || !NEVER.has(m.rule));
  const rules = new Set(marks.flatMap((m) => (m.rule === "residue" ? [] : [m.rule])));
  const broken = new Set(marks.flatMap((m) => (m.rule === "residue" || m.passed ? [] : [m.rule])));
  const left = areaOf(areaBeyond(final, wanted.rings));
  const most = MOST_LEFT * (areaOf(wanted.blank) - areaOf(wanted.rings));
  const threads = marks.every((m) => m.passed || m.rule !== "residue" || m.about === undefined);
  const tools = calledTools(answer).size;
  const held = rules.size - broken.size;
  const parts = (
    [
      ["proof", held / rules.size, held, rules.size],
      ["residue", threads ? 1 - Math.max(0, left - residue) / most : 0, left, residue],
      ["time", seconds > 0 ? par.seconds / seconds : 0, seconds, par.seconds],
      ["tools", tools > 0 ? par.tools / tools : 0, tools, par.tools],
    ] as const
  ).map(([what, part, value, of]): ScorePart => ({
    what,
    points: isSafe ? Math.round(POINTS[what] * share(part)) : 0,
    of: POINTS[what],
    value,
    par: of,
  }));
  return { total: parts.reduce((sum, p) => sum + p.points, 0), parts };
}

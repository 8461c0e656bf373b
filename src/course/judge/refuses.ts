import { at, part } from "../../kernel/geometry/point.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import type { Task, WrongAnswer } from "../task.ts";
import { distanceTo } from "./difference.ts";
import { judge } from "./judge.ts";
import type { Answer, TaskMark } from "./judgement.ts";

/** Tolerance of a place that a file states, mm. */
const NEAR = 3;

/** Whether a mark is at a place: at its point or anywhere in its region. */
function showsAt({ place, rings }: TaskMark, x: number, z: number): boolean {
  const wanted = at(z, toRadius(diameter(x)));
  if (place && part.apart(place, wanted) <= NEAR) return true;
  return rings !== undefined && distanceTo(rings, wanted) <= NEAR;
}

/** Whether a wrong answer fails the rule that its file states, at the stated place or in the stated block. */
export function isRefusedAsStated(task: Task, { rule, at: where, block }: WrongAnswer, answer: Answer): boolean {
  return judge(task, answer).marks.some((mark) => {
    if (mark.passed || mark.rule !== rule) return false;
    const definedIn = mark.operation === undefined ? undefined : answer.run.operations[mark.operation]?.definedIn;
    const isPlace = !where || showsAt(mark, where.x, where.z);
    const isBlock = block === undefined || mark.block === block || definedIn === block;
    return isPlace && isBlock;
  });
}

import { at, part } from "../../kernel/geometry/point.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import type { Task, WrongAnswer } from "../task.ts";
import { distanceTo } from "./difference.ts";
import { judge } from "./judge.ts";
import type { Answer, TaskMark } from "./judgement.ts";

/** How near a place must be to the one that a file names, mm. */
const NEAR = 3;

/** Whether a mark shows at a place: at its own, or anywhere on its region. */
function showsAt({ place, rings }: TaskMark, x: number, z: number): boolean {
  const wanted = at(z, toRadius(diameter(x)));
  if (place && part.apart(place, wanted) <= NEAR) return true;
  return rings !== undefined && distanceTo(rings, wanted) <= NEAR;
}

/** Whether a wrong answer is refused by the rule that its file names, at the place or in the block that it names. */
export function refuses(task: Task, { rule, at: where, block }: WrongAnswer, answer: Answer): boolean {
  return judge(task, answer).marks.some((mark) => {
    if (mark.passed || mark.rule !== rule) return false;
    const definedIn = mark.operation === undefined ? undefined : answer.run.operations[mark.operation]?.definedIn;
    const isPlace = !where || showsAt(mark, where.x, where.z);
    const isBlock = block === undefined || mark.block === block || definedIn === block;
    return isPlace && isBlock;
  });
}

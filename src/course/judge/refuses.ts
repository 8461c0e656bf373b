import { boxAround } from "../../kernel/box.ts";
import { isInside } from "../../kernel/clip.ts";
import { at, part, type Pt, type Ring } from "../../kernel/point.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import type { Task, WrongAnswer } from "../task.ts";
import { judge } from "./judge.ts";
import type { Answer, TaskMark } from "./judgement.ts";

/** How near a place must be to the one that a file names, mm. */
const NEAR = 3;

/** How far a point is from an area, mm; 0 inside it. */
export function distanceTo(rings: readonly Ring[], p: Pt): number {
  if (rings.some((ring) => isInside(ring, p))) return 0;
  const edges = rings.flatMap((ring) => ring.map((to, i) => part.line(ring.at(i - 1) as Pt, to)));
  return edges.reduce((least, edge) => Math.min(least, part.distanceTo(edge, p)), Infinity);
}

/** Whether a mark shows at a place: at its own, or in a small region on all of it. */
function showsAt({ place, rings }: TaskMark, x: number, z: number): boolean {
  const wanted = at(z, toRadius(diameter(x)));
  if (place && part.apart(place, wanted) <= NEAR) return true;
  return rings !== undefined && rings.length > 0 && boxAround(rings).right > -Infinity && distanceTo(rings, wanted) <= NEAR;
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

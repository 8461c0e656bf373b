import { producedParts } from "../../sim/produced-parts.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import { diameter, toRadius } from "../../kernel/units.ts";
import { scanCrossings } from "../../sim/scan.ts";
import { bandOfThread, type TargetThread } from "../target-part.ts";
import type { Answer, TaskMark } from "./judgement.ts";

/** Sampling distance along the profile of a thread, mm. */
const STEP = 0.02;
/** Most samples of all threads together: a long list of threads takes no more time than a short one. */
const MOST_LINES = 60_000;
/** Least depth of a groove as a share of the thread depth, and the share at which two grooves are separate. */
const DEEP = 0.85;
const APART = 0.5;
/** Relative tolerance of a measured pitch. */
const SAME_PITCH = 0.01;

interface Grooves {
  /** Z of the middle of each groove, from the left. */
  readonly middles: readonly number[];
  /** Depth of the shallowest whole groove, as a share of the required depth. */
  readonly depth: number;
}

/** The grooves between crest and root, from the profile of a stock. */
function groovesOf(stock: readonly Ring[], { from, to, crest, root }: TargetThread, most: number): Grooves {
  const [left, right] = [Math.min(from, to), Math.max(from, to)];
  const count = Math.min(most, Math.max(2, Math.floor((right - left) / STEP))),
    step = Math.max(STEP, (right - left) / most);
  const lines = Array.from({ length: count }, (_, i) => left + (i + 0.5) * step);
  const [top, full] = [toRadius(diameter(crest)), toRadius(diameter(Math.abs(crest - root)))];
  const profile = scanCrossings(stock, "r", lines).map((found) => {
    const r = crest > root ? found.at(-1) : found[0];
    return r === undefined ? 1 : Math.abs(r - top) / full;
  });
  const grooves: { first: number; last: number; depth: number }[] = [];
  let begun = false;
  profile.forEach((depth, i) => {
    const line = lines[i] ?? 0,
      open = grooves.at(-1);
    if (depth < APART) begun = false;
    else if (begun && open) Object.assign(open, { last: line, depth: Math.max(open.depth, depth) });
    else {
      begun = true;
      grooves.push({ first: line, last: line, depth });
    }
  });
  // A thread may end in half a groove.
  const whole = grooves.length > 3 ? grooves.slice(1, -1) : grooves;
  return { middles: grooves.map((g) => (g.first + g.last) / 2), depth: Math.min(...whole.map((g) => g.depth)) };
}

/**
 * Whether a thread has grooves over its full length, deep enough, and at its pitch where the task states one. Material
 * left in it is residue, with the name of the thread in `about`; `value` is the measured pitch, mm, 0 without one.
 */
export function threadMarks(threads: readonly TargetThread[], { run, simulation }: Answer): TaskMark[] {
  return threads.map((thread, entry): TaskMark => {
    const { from, to, crest, pitch, name } = thread;
    const { middles, depth } = groovesOf(producedParts(simulation), thread, Math.floor(MOST_LINES / threads.length));
    const [first, last] = [middles[0] ?? 0, middles.at(-1) ?? 0];
    const ways = middles.slice(1).map((z, i) => z - (middles[i] ?? 0));
    // A thread that begins in a chamfer has a wider first groove.
    const value = ways.toSorted((a, b) => a - b)[Math.floor(ways.length / 2)] ?? 0;
    const wanted = pitch ?? value;
    const [begins, ends] = [Math.min(from, to), Math.max(from, to)];
    const isWhole = first - begins < 1.5 * wanted && ends - last < 1.5 * wanted;
    const isEven = ways.slice(1, -1).every((way) => Math.abs(way - value) < value / 4);
    const passed =
      middles.length > 1 && isWhole && isEven && depth >= DEEP && Math.abs(value - wanted) <= SAME_PITCH * wanted;
    const operation = run.operations.findLastIndex(
      (o) =>
        o.plan.thread &&
        o.plan.moves.some((m) => m.kind === "thread" && m.to.z < ends + wanted && m.to.z > begins - 2 * wanted),
    );
    return {
      rule: "residue",
      about: name,
      passed,
      value,
      entry,
      rings: [bandOfThread(thread)],
      place: at((from + to) / 2, toRadius(diameter(crest))),
      ...(pitch !== undefined && { limit: pitch }),
      ...(operation >= 0 && { operation, block: run.operations[operation]?.block ?? 0 }),
    };
  });
}

import type { MeasuredMoment } from "../../kernel/measured.ts";
import type { MillMotion } from "../../kernel/mill-motion.ts";
import type { Ring } from "../../kernel/point.ts";
import type { Stated, Step } from "../../kernel/step.ts";
import type { Tool } from "../../kernel/tool.ts";

/** What makes the stock of a program. */
export interface StockMaker {
  readonly blank: readonly Ring[];
  readonly stated: readonly Stated[];
  readonly steps: readonly Step[];
}

const BASIS = 2_166_136_261, PRIME = 16_777_619, FINE = 1e4;

/** One number more in a print. */
const added = (print: number, value: number): number => Math.imul(print ^ Math.round(value * FINE), PRIME) >>> 0;
const withRings = (print: number, rings: readonly Ring[]): number =>
  rings.reduce((sum, ring) => ring.reduce((own, { z, r }) => added(added(own, z), r), added(sum, ring.length)), print);

/** What of a tool cuts: its holder takes no stock, and its name does nothing. */
function toolPrint(tool: Tool): number {
  const { holder: _, NAME: __, ...cuts } = tool;
  return [...JSON.stringify(cuts)].reduce((sum, c) => added(sum, c.codePointAt(0) ?? 0), BASIS);
}

function withMove(print: number, { from, move }: Step): number {
  const sum = added(added(added(added(print, from.z), from.r), move.to.z), move.to.r);
  return move.kind === "arc" ? added(added(added(sum, move.centre.z), move.centre.r), move.turn === "cw" ? 1 : 2) : sum;
}

type PrintOf = (moment: Omit<MeasuredMoment, "print">) => string | null;

/** Prints along steps: `withStep` adds what one does, `begun` what is stated before another. */
function printsAlong<S>(
  steps: readonly S[],
  start: number,
  withStep: (print: number, step: S) => number,
  begun: (print: number, step: number) => number,
): PrintOf {
  const until: number[] = [start];
  return ({ step, fraction, block }) => {
    const last = block === undefined ? steps.length : step;
    if (last > steps.length) return null;
    const wanted = Math.min(steps.length, fraction > 0 ? last + 1 : last);
    for (let i = until.length; i <= wanted; i += 1) {
      const done = steps[i - 1], print = until[i - 1] ?? BASIS;
      until.push(done ? withStep(print, done) : print);
    }
    return added(begun(until[wanted] ?? BASIS, last), block === undefined ? 0 : fraction).toString(36);
  };
}

/**
 * Prints of the stock at moments of a program: two moments with the same print have the same stock, since all that was done until then
 * is the same. A moment without a block is the end, however many steps there are. Asked for again, nothing is counted twice.
 */
export function printsOf({ blank, stated, steps }: StockMaker): PrintOf {
  const tools = new Map<Tool, number>();
  const toolOf = (tool: Tool): number => {
    const known = tools.get(tool) ?? toolPrint(tool);
    tools.set(tool, known);
    return known;
  };
  return printsAlong(steps, withRings(BASIS, blank), (print, step) => added(withMove(print, step), toolOf(step.tool)),
    (print, last) => stated.filter((each) => each.step <= last).reduce((sum, { rings }) => withRings(sum, rings), print));
}

/** A height that nobody knows, in a print: no program goes there, mm. */
const NO_HEIGHT = 1e6;

const withMotion = (print: number, { from, to, centre, turn, radius }: MillMotion): number =>
  [from.x, from.y, from.z ?? NO_HEIGHT, to.x, to.y, to.z ?? NO_HEIGHT, centre?.x ?? 0, centre?.y ?? 0, turn === "cw" ? 1 : 2, radius]
    .reduce(added, print);

/** The same of milled stock: `blank` are its outlines in the plane, those of each height. */
export const printsOfMilled = (blank: readonly Ring[], motions: readonly MillMotion[]): PrintOf =>
  printsAlong(motions, withRings(BASIS, blank), withMotion, (print) => print);

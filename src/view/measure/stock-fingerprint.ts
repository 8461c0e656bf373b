import type { MeasuredMoment } from "../../kernel/plan/measured.ts";
import type { MillMotion } from "../../kernel/plane/mill-motion.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { StatedBlank, Step } from "../../kernel/time/step.ts";
import type { Tool } from "../../kernel/plan/tool.ts";

/** The inputs that determine the stock of a program. */
export interface StockMaker {
  readonly blank: readonly Ring[];
  readonly stated: readonly StatedBlank[];
  readonly steps: readonly Step[];
}

const BASIS = 2_166_136_261,
  PRIME = 16_777_619,
  FINE = 1e4;

/** Adds one number to a fingerprint. */
const added = (print: number, value: number): number => Math.imul(print ^ Math.round(value * FINE), PRIME) >>> 0;
const withRings = (print: number, rings: readonly Ring[]): number =>
  rings.reduce((sum, ring) => ring.reduce((own, { z, r }) => added(added(own, z), r), added(sum, ring.length)), print);

/** The cutting part of a tool: its holder removes no stock, and its name has no effect. */
function toolPrint(tool: Tool): number {
  const { holder: _, NAME: __, ...cuts } = tool;
  return [...JSON.stringify(cuts)].reduce((sum, c) => added(sum, c.codePointAt(0) ?? 0), BASIS);
}

function withMove(print: number, { from, move }: Step): number {
  const sum = added(added(added(added(print, from.z), from.r), move.to.z), move.to.r);
  return move.kind === "arc" ? added(added(added(sum, move.centre.z), move.centre.r), move.turn === "cw" ? 1 : 2) : sum;
}

type PrintOf = (moment: Omit<MeasuredMoment, "print">) => string | null;

/** Fingerprints along steps: `withStep` adds one step, `begun` the blanks stated before another. */
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
      const done = steps[i - 1],
        print = until[i - 1] ?? BASIS;
      until.push(done ? withStep(print, done) : print);
    }
    return added(begun(until[wanted] ?? BASIS, last), block === undefined ? 0 : fraction).toString(36);
  };
}

/**
 * Fingerprints of the stock at moments of a program: two moments with the same fingerprint have the same stock, since
 * everything done until then is the same. A moment without a block is the end, however many steps there are. Partial
 * results are cached.
 */
export function stockFingerprints({ blank, stated, steps }: StockMaker): PrintOf {
  const tools = new Map<Tool, number>();
  const toolOf = (tool: Tool): number => {
    const known = tools.get(tool) ?? toolPrint(tool);
    tools.set(tool, known);
    return known;
  };
  return printsAlong(
    steps,
    withRings(BASIS, blank),
    (print, step) => added(withMove(print, step), toolOf(step.tool)),
    (print, last) =>
      stated.filter((each) => each.step <= last).reduce((sum, { rings }) => withRings(sum, rings), print),
  );
}

/** Number for an unknown height, mm: no program goes there. */
const NO_HEIGHT = 1e6;

const turnPrint = (turn: MillMotion["turn"]): number => (turn === "cw" ? 1 : 2);
/** The numbers of an arc; a line adds none, so that it never matches an arc. */
function wayPrint({ centre, turn, side }: MillMotion): readonly number[] {
  if (side)
    return [
      3,
      "XYZ".indexOf(side.plane[0] ?? ""),
      side.centre.x ?? 0,
      side.centre.y ?? 0,
      side.centre.z ?? 0,
      turnPrint(side.turn),
    ];
  return centre ? [4, centre.x, centre.y, turnPrint(turn)] : [];
}

function withMotion(print: number, m: MillMotion): number {
  const { from, to, radius } = m;
  return [from.x, from.y, from.z ?? NO_HEIGHT, to.x, to.y, to.z ?? NO_HEIGHT, ...wayPrint(m), radius].reduce(
    added,
    print,
  );
}

/** A motion of a program that may also turn: `turned` counts the turning steps before it. */
type MilledMotion = MillMotion & { readonly turned: number };

/**
 * The same for milled stock: `blank` are its outlines in the plane, those of each height; `turned` makes the body that
 * is milled.
 */
export function milledFingerprints(
  blank: readonly Ring[],
  motions: readonly MilledMotion[],
  turned: StockMaker,
): PrintOf {
  const milled = printsAlong(motions, withRings(BASIS, blank), withMotion, (print) => print);
  const before = turned.steps.length > 0 ? stockFingerprints(turned) : null;
  return (moment) => {
    const own = milled(moment),
      last = motions[moment.block === undefined ? motions.length - 1 : Math.min(moment.step, motions.length - 1)];
    if (own === null || !before) return own;
    const body = before({ step: last?.turned ?? 0, fraction: 0, block: 0 });
    return body && `${own} ${body}`;
  };
}

import fc from "fast-check";
import type { Cycle, Given } from "../../src/cycles/define.ts";
import type { Draw, RandomSetup, Setups } from "../../src/cycles/random-setup.ts";
import { catalogue } from "../../src/cycles/index.ts";
import { at, type Pt, type Ring } from "../../src/kernel/geometry/point.ts";
import type { TipOrientation, Tool } from "../../src/kernel/plan/tool.ts";
import { length, rounded } from "../../src/kernel/units.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";

/**
 * A random set-up of a cycle: values, contour, tool, start point and matching blank. Plain data: it can be written to a
 * file.
 */
export interface Situation {
  readonly values: Readonly<Record<string, number>>;
  readonly given: Given;
  readonly tool: Tool;
  readonly start: Pt;
  readonly blank: readonly Ring[];
}

/** A law's message about a situation; null when the law holds. */
export type Finding = string | null;

/** fast-check as the random generator of a cycle. */
const drawing = (g: fc.GeneratorValue): Draw => ({
  one: <T>(...of: readonly T[]) => of[g(fc.nat, { max: of.length - 1 })] as T,
  whole: (min, max) => g(fc.integer, { min, max }),
});

/** Margin round the blank for start points, mm. */
const ROOM = 15;

/**
 * Usually the drawn set-up; sometimes with a short cutting edge, another tool orientation, or a start point anywhere
 * round the blank.
 */
function situationOf({ values, contour, tool: { T, ...changed }, start, blank }: RandomSetup, draw: Draw): Situation {
  const tool = shippedTools.find((x) => x.T === T) as Tool;
  const share = () => draw.whole(0, 1000) / 1000;
  const [z0, z1, r1] = [
    Math.min(...blank.map((q) => q.z)),
    Math.max(...blank.map((q) => q.z)),
    Math.max(...blank.map((q) => q.r)),
  ];
  const anywhere = () => at(rounded(z0 - ROOM + share() * (z1 - z0 + 2 * ROOM)), rounded(share() * (r1 + ROOM)));
  const [isUsual, pointsThere, wholeEdge] = [draw.whole(1, 7) <= 5, draw.whole(1, 14) <= 12, draw.whole(1, 7) <= 5];
  const called = isUsual ? start : anywhere();
  return {
    values,
    given: { contour, start: called },
    tool: {
      ...tool,
      ...(changed as Partial<Tool>),
      ...(!pointsThere && { TO: draw.whole(1, 8) as TipOrientation }),
      // A set-up that states the edge length may depend on it.
      ...(!wholeEdge && changed.CUTLENGTH === undefined && { CUTLENGTH: length(draw.whole(2000, 5000) / 1000) }),
    },
    start: called,
    blank: [blank],
  };
}

/** A situation with another machining operation. */
export const doing = (s: Situation, operation: number): Situation => ({
  ...s,
  values: { ...s.values, Q215: operation },
});

/**
 * Random situations for one machining operation (Q215). A draw without a contour is repeated at once: a filter would
 * repeat the same draw.
 */
export const drawnFrom = (setups: Setups, operation: number): fc.Arbitrary<Situation> =>
  fc.gen().map((g) => {
    const draw = drawing(g);
    let drawn = setups(draw);
    while (drawn === null) drawn = setups(draw);
    return doing(situationOf(drawn, draw), operation);
  });

/** The random set-ups of each cycle's file, by number. */
const setups = new Map(
  Object.values(import.meta.glob<Record<string, unknown>>("../../src/cycles/c*.ts", { eager: true })).flatMap((file) =>
    Object.entries(file).flatMap(([name, value]): [number, Setups][] =>
      name.startsWith("setups") ? [[Number(name.slice(6)), value as Setups]] : [],
    ),
  ),
);

/** Whether a cycle has a machining operation (Q215); one that does not has only the operation that counts as 0. */
const choosesOperation = (cycle: Cycle) => Object.values(cycle.params).some((p) => p.shown === "operation");

/** The cutting cycles of the catalogue, each with its random situations for one machining operation. */
export const situations = (operation: number): { cycle: Cycle; arbitrary: fc.Arbitrary<Situation> }[] =>
  catalogue
    .filter((cycle) => cycle.group !== "special" && (operation === 0 || choosesOperation(cycle)))
    .map((cycle) => {
      const own = setups.get(cycle.number);
      if (!own) throw new Error(`src/cycles/c${cycle.number}.ts exports no setups${cycle.number}`);
      return { cycle, arbitrary: drawnFrom(own, operation) };
    });

/**
 * Number of set-ups of a cycle in `npm test`, where a cycle with a printed list has `most`: the families share their
 * strategies.
 */
export const casesOf = (cycle: Cycle, most: number): number => (cycle.evidence === "A" ? most : Math.ceil(most / 6));

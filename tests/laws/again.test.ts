import fc from "fast-check";
import { expect, test } from "vitest";
import { AnswerCache } from "../../src/kernel/answer-cache.ts";
import { parse } from "../../src/nc/parse.ts";
import { incrementalParser } from "../../src/nc/reread.ts";
import { incrementalRunner } from "../../src/program/run/incremental-run.ts";
import { run } from "../../src/program/run/run.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { incrementalSimulator, simulate } from "../../src/sim/simulate.ts";
import type { Simulation } from "../../src/sim/simulation.ts";
import { traceStock } from "../../src/sim/tracing.ts";
import { brokenByEdit, edits, unedited, type Edit } from "./edited-programs.ts";
import { movingPrograms } from "./moving-programs.ts";

/*
 * An edited program, calculated incrementally: the result must equal that of the program alone. `npm run laws --
 * --edits=N` tries more.
 */

const programs = import.meta.glob<string>(["../../src/examples/*.h", "../programs/**/*.h"], {
  query: "?raw",
  import: "default",
  eager: true,
});
const textOf = (name: string): string => Object.entries(programs).find(([path]) => path.endsWith(name))?.[1] ?? "";

const shop = { tools: shippedTools, rapid: 10_000, tracing: traceStock };
const ran = (text: string) => run(parse(text), shop);

const holdsFor = (text: string, changes: readonly Edit[]): void => {
  const broken = brokenByEdit(unedited(text), changes);
  expect(broken?.kept).toBe(broken?.alone);
  expect(broken).toBeNull();
};

test("a changed program with calls, jumps, shifts and parameters is run and proved as from scratch", () => {
  fc.assert(fc.property(movingPrograms, fc.array(edits, { minLength: 4, maxLength: 8 }), holdsFor), {
    numRuns: Number(process.env["LAW_CASES"] ?? 6),
  });
});

test.each([
  ["flange.h", 2],
  ["shoulder-812.h", 4],
  ["turn-blank.h", 3],
] as const)("what is proved again of a changed %s is what is proved of it alone", (name, numRuns) => {
  const text = textOf(name);
  expect(text).not.toBe("");
  fc.assert(
    fc.property(fc.array(edits, { minLength: 2, maxLength: 5 }), (changes) => {
      holdsFor(text, changes);
    }),
    { numRuns },
  );
});

/** A cycle that is called once more in front of another one, without values: it cuts nothing. */
test("an operation that cuts nothing has no measures of another one", () => {
  const cycle = (diameter: number) => [
    "CYCL DEF 811 SHOULDER, LONGITDNL. ~",
    ...["Q215=+1 ~", "Q460=+2 ~", `Q493=+${diameter} ~`, "Q494=-20 ~", "Q463=+3 ~", "Q478=+0.3 ~"],
    ...["Q483=+0.4 ~", "Q484=+0.2 ~", "Q505=+0.2 ~", "Q506=+0"],
    "L X+84 Z+2 FMAX",
    "CYCL CALL",
  ];
  const text = [
    "BEGIN PGM NOTHING MM",
    "BLK FORM CYLINDER Z D80 L100 DIST+1",
    "FUNCTION MODE TURN",
    "TOOL CALL 1",
    "FUNCTION TURNDATA SPIN VCONST:OFF S800",
    "M136",
    "L X+110 Z+30 R0 FMAX M303",
    ...cycle(60),
    "L Z+2 FMAX",
    // Longer than the steps between two snapshots.
    ...Array.from({ length: 12 }, (_, i) => `L X+${90 + i} FMAX`),
    ...cycle(50),
    "M30",
    "END PGM NOTHING MM",
    "",
  ].join("\n");
  const other = text.replace("L Z+2 FMAX\n", "CYCL DEF 811 SHOULDER, LONGITDNL. ~\nQ215=+1\nCYCL CALL\n$&");
  const proved = incrementalSimulator();
  proved(ran(text));
  const again = proved(ran(other));
  expect(again.proof.operations).toHaveLength(3);
  expect(again.proof.operations[1]).toMatchObject({ cut: 0, airPasses: 0, deepest: null });
  expect(again).toStrictEqual(simulate(ran(other)));
});

/** The number of marks that two simulations share: identical arrays, not recomputed ones. */
const kept = (a: Simulation, b: Simulation): number =>
  b.checkpoints.filter((mark, i) => mark.stock === a.checkpoints[i]?.stock).length;

test("a changed end reuses the stock before it", () => {
  const text = textOf("shaft.h");
  const proved = incrementalSimulator();
  const before = proved(ran(text));
  const last = [...text.matchAll(/CYCL DEF 831[\s\S]*?Q460=\+([\d.]+)/g)].at(-1);
  expect(last).toBeDefined();
  const at = (last?.index ?? 0) + (last?.[0].length ?? 0);
  const changed = ran(`${text.slice(0, at)}.4${text.slice(at)}`);
  const after = proved(changed);
  expect(after).toEqual(simulate(changed));
  const lastOperation = changed.operations.at(-1)?.firstStep ?? 0;
  expect(kept(before, after)).toBeGreaterThanOrEqual(
    before.checkpoints.filter(({ step }) => step <= lastOperation).length,
  );
});

test("a proof is reused when a state returns, and when no move changes", () => {
  // Roughing alone leaves its oversize.
  const text = textOf("flange.h").replaceAll(/Q215=\+?0/g, "Q215=+1");
  const [proved, memory, read, runs] = [
    incrementalSimulator(),
    new AnswerCache(),
    incrementalParser(),
    incrementalRunner(),
  ];
  const simulationOf = (each: string) => {
    memory.runEnded();
    return proved(runs(read(each), { ...shop, memory }, []));
  };
  const before = simulationOf(text);
  const noted = simulationOf(text.replace("END PGM", "; a note\n$&"));
  expect(kept(before, noted)).toBe(before.checkpoints.length);
  // The first cycle changes: everything after it is cut again.
  const other = simulationOf(text.replace(/Q463=\+?[\d.]+/, "Q463=+1.37"));
  expect(kept(before, other)).toBeLessThan(before.checkpoints.length / 2);
  const again = simulationOf(text);
  expect(kept(before, again)).toBe(before.checkpoints.length);
  expect(again).toEqual(before);
  expect(again.proof.residual[0]?.ring).toBe(before.proof.residual[0]?.ring);
  expect(before.proof.residual.length).toBeGreaterThan(0);
});

import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { blockNumbers, startLines } from "../../nc/program.ts";
import { blockSpan } from "./block-span.ts";
import { choiceOf, contourOf, definitionOf, markedBy, runningPart, type MoveSpan } from "./path-index.ts";
import { filesByName } from "../state/program-files.ts";
import { run } from "./run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const made = (text: string, files: Readonly<Record<string, string>> = {}) => {
  const program = parse(text);
  const result = run(program, {
    tools: shippedTools,
    rapid: 10_000,
    files: filesByName(
      Object.entries(files).map(([name, content]) => ({ name, text: content })),
      parse,
    ),
  });
  const numbers = blockNumbers(program),
    lines = startLines(program);
  /** Marks of the block with this number. */
  const of = (number: number) => {
    const index = numbers.indexOf(number);
    return markedBy(result, { kind: "blocks", span: blockSpan(program, index), line: lines[index] ?? 0 });
  };
  return { program, run: result, of };
};
const example = (name: string) => made(readFileSync(new URL(`../../examples/${name}.h`, import.meta.url), "utf8"));
const whole = ({
  firstStep: first,
  lastStep: last,
}: {
  readonly firstStep: number;
  readonly lastStep: number;
}): MoveSpan => ({
  first,
  last,
});

describe("the flange", () => {
  const { program, run: result, of } = example("flange");
  test("a definition and its call mark the same moves, those of the call", () => {
    const [, roughing] = result.operations;
    expect(of(19).stretches).toEqual([whole(roughing as never)]);
    expect(of(21)).toEqual(of(19));
    expect(of(19).begin).toBe(roughing?.firstStep);
  });
  test("a motion block marks its own moves, and every move leads back to what marks it", () => {
    const marked = of(20);
    expect(
      marked.stretches.flatMap(({ first, last }) => result.steps.slice(first, last + 1).map((s) => s.block)),
    ).toEqual([20]);
    result.steps.forEach((step, i) => {
      const choice = choiceOf(result, i);
      const { stretches } = choice ? markedBy(result, choice) : { stretches: [] };
      // Positioning of a call belongs to no pass.
      if (step.move.phase !== "position" || step.operation === null)
        expect(stretches.some(({ first, last }) => first <= i && i <= last)).toBe(true);
    });
  });
  test("a tool call stands for all up to the next one", () => {
    const { stretches } = of(15);
    const blocks = new Set(
      stretches.flatMap(({ first, last }) => result.steps.slice(first, last + 1).map((s) => s.block)),
    );
    expect([...blocks]).toEqual([20, 21, 23, 24, 25, 26]);
  });
  test("a block that moves nothing shows where the next one begins", () => {
    const feed = of(17);
    expect(feed.stretches).toEqual([]);
    expect(result.steps[feed.begin ?? -1]?.block).toBe(20);
  });
  test("behind the last move there is nothing to show", () => {
    const last = program.blocks.length - 1;
    expect(markedBy(result, { kind: "blocks", span: { from: last, to: last }, line: 0 })).toEqual({
      stretches: [],
      contour: [],
      begin: null,
    });
  });
  test("the dialog of a pass is at its definition", () => {
    const third = result.operations[2];
    expect(definitionOf(result, (third?.firstStep ?? 0) + 4)).toEqual({ line: third?.definedLine });
    expect(definitionOf(result, 0)).toBeNull();
  });
  test("a line of the contour marks its element and the cuts nearest to it", () => {
    const facing = result.operations[0];
    const lines = startLines(program),
      numbers = blockNumbers(program);
    expect(facing?.contourLines?.length).toBe(contourOf(facing as never).length);
    const place = facing?.contourLines?.[0];
    const number = numbers[lines.indexOf(place?.line ?? 0)] ?? -1;
    const marked = of(number);
    expect(marked.contour).toContainEqual(contourOf(facing as never)[0]);
    expect(marked.stretches.length).toBeGreaterThan(0);
    for (const { first, last } of marked.stretches)
      for (const step of result.steps.slice(first, last + 1)) expect(step.move.kind).not.toBe("rapid");
  });
});

describe("the part that runs", () => {
  const { run: result } = example("flange");
  const [facing, roughing] = result.operations;
  test("pass, phase and call of a step lie in one another", () => {
    const inside = (roughing?.firstStep ?? 0) + 7;
    const of = (part: "operation" | "phase" | "pass") =>
      markedBy(result, runningPart(result, inside, part) ?? { kind: "segments", segments: [] });
    const count = (stretches: readonly MoveSpan[]) =>
      stretches.reduce((sum, { first, last }) => sum + last - first + 1, 0);
    expect(of("operation").stretches).toEqual([whole(roughing as never)]);
    expect(count(of("pass").stretches)).toBeGreaterThan(0);
    expect(count(of("pass").stretches)).toBeLessThan(count(of("phase").stretches));
    const { pass } = result.steps[inside]?.move ?? {};
    for (const { first, last } of of("pass").stretches)
      for (const step of result.steps.slice(first, last + 1)) expect(step.move.pass).toBe(pass);
  });
  test("between two calls it is the one that comes, behind the last one that", () => {
    expect(runningPart(result, (facing?.lastStep ?? 0) + 1, "pass")).toEqual({ kind: "pass", operation: 1 });
    expect(runningPart(result, result.steps.length, "operation")).toEqual({
      kind: "pass",
      operation: result.operations.length - 1,
    });
  });
});

const head =
  "0 BEGIN PGM T MM\n1 BLK FORM CYLINDER Z D80 L100 DIST+1 DI20\n2 FUNCTION MODE TURN\n3 TOOL CALL 1\n4 FUNCTION TURNDATA " +
  "SPIN VCONST:OFF S500\n5 M136\n6 L X+100 Z+50 R0 FMAX\n";

describe("blocks that run more than once", () => {
  const text = `${head}7 CALL LBL 3\n8 L X+93.4 FMAX\n9 CALL LBL 3\n10 M30\n11 LBL 3\n12 L IX-1.7 F0.13\n13 L IZ-2.3\n14 LBL 0\n15 END PGM T MM\n`;
  const { run: result, of } = made(text);
  const blocks = (stretches: readonly MoveSpan[]) =>
    stretches.map(({ first, last }) =>
      result.steps
        .slice(first, last + 1)
        .map((s) => s.block)
        .join(" "),
    );
  test("each run of a block is a stretch of its own, in the order of the run", () => {
    const runs = result.steps.filter((s) => s.block === 12).length;
    expect(runs).toBeGreaterThan(1);
    expect(blocks(of(12).stretches)).toEqual(Array.from({ length: runs }, () => "12"));
    expect(of(12).begin).toBe(0);
  });
  test("a call and its label stand for the subprogram", () => {
    expect(of(7)).toEqual(of(11));
    expect(new Set(blocks(of(7).stretches).join(" ").split(" "))).toEqual(new Set(["12", "13"]));
  });
  test("block numbers that stand twice are told apart", () => {
    const twice = made(`${head}7 L X+93.4 FMAX\n7 L Z+11.9 FMAX\n8 M30\n9 END PGM T MM\n`);
    const mark = (index: number) =>
      markedBy(twice.run, { kind: "blocks", span: { from: index, to: index }, line: 0 }).stretches;
    expect(mark(7)).toEqual([{ first: 0, last: 0 }]);
    expect(mark(8)).toEqual([{ first: 1, last: 1 }]);
  });
  test("a label that is not there stands for its call alone", () =>
    expect(blockSpan(parse("0 BEGIN PGM T MM\n1 CALL LBL 7\n2 END PGM T MM\n"), 1)).toEqual({ from: 1, to: 1 }));
});

describe("called programs", () => {
  const sub = "0 BEGIN PGM CUT MM\n1 L X+91.7 FMAX\n2 L Z+3.1 FMAX\n3 L IX-8.3 FMAX\n4 END PGM CUT MM\n";
  const { run: result, of } = made(
    `${head}7 CALL PGM TNC:\\work\\cut\n8 L Z+7.3 FMAX\n9 CALL PGM cut.h\n10 M30\n11 END PGM T MM\n`,
    {
      "CUT.H": sub,
    },
  );
  test("the call marks all that ran in it", () => expect(of(7).stretches).toEqual([{ first: 0, last: 2 }]));
  test("a line of the file marks its moves of every call, however the file is written", () => {
    expect(markedBy(result, { kind: "inFile", file: "cut.h", line: 3 }).stretches).toEqual([
      { first: 1, last: 1 },
      { first: 5, last: 5 },
    ]);
    expect(choiceOf(result, 5)).toEqual({ kind: "inFile", file: "CUT.H", line: 3 });
    expect(definitionOf(result, 5)).toEqual({ file: "CUT.H", line: 3 });
    expect(markedBy(result, { kind: "inFile", file: "other.h", line: 3 }).begin).toBeNull();
  });
});

test("a part that is repeated marks each of its runs", () => {
  const { run: result, of } = made(
    `${head}7 L X+93.4 FMAX\n8 LBL 5\n9 L IX-1.7 F0.13\n10 CALL LBL 5 REP2\n11 M30\n12 END PGM T MM\n`,
  );
  const cuts = result.steps.flatMap(({ block }, i) => (block === 9 ? [i] : []));
  expect(cuts).toEqual([1, 2, 3]);
  expect(of(9).stretches).toEqual([{ first: 1, last: 3 }]);
});

import * as fc from "fast-check";
import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { print, type Program } from "../../nc/program.ts";
import {
  duplicatedOperation,
  isRefused,
  movedOperation,
  retooledOperation,
  switchedOperation,
  withoutOperation,
  type Refusal,
} from "./operation-edits.ts";
import { isOff, operationsOf, wholeOf } from "./operations.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const shipped = import.meta.glob<string>("../../examples/*.h", { query: "?raw", import: "default", eager: true });
const goldens = import.meta.glob<string>("../../../tests/programs/*.h", {
  query: "?raw",
  import: "default",
  eager: true,
});
const named = (name: string) => Object.entries(shipped).find(([path]) => path.endsWith(`/${name}.h`))?.[1] ?? "";
const flange = named("flange");
const texts = [...Object.values(shipped), ...Object.values(goldens)];

const made = (next: Program | Refusal): Program => {
  if (isRefused(next)) throw new Error(`refused: ${next.refused}`);
  return parse(print(next));
};
const unitsOf = (program: Program) => operationsOf(program).units;
const summary = (program: Program) =>
  unitsOf(program).map(({ title, definitions, toolCall }) => {
    const cycle = program.blocks[definitions[0] ?? -1]?.statement;
    const tool = program.blocks[toolCall ?? -1]?.statement;
    return `${title ?? "-"} ${cycle?.kind === "cycle" ? cycle.cycle : "-"} T${tool?.kind === "toolCall" ? String(tool.tool) : "-"}`;
  });
const numbers = (program: Program) => program.blocks.flatMap(({ number }) => (number === null ? [] : [number]));

/** Other file styles: numbered in tens, without numbers, with a final comment, with Windows line ends. */
const tens = (text: string) =>
  text.replace(/^(\/?)(\d+) /gm, (_, mark: string, n: string) => `${mark}${Number(n) * 10 + 10} `);
const gaps = (text: string) =>
  text.replace(/^(\/?)(\d+) /gm, (_, mark: string, n: string) => `${mark}${Number(n) + (Number(n) > 11 ? 7 : 0)} `);
const bare = (text: string) => text.replace(/^\d+ /gm, "");
const windows = (text: string) => text.replaceAll("\n", "\r\n");
const ended = (text: string) => `${text.trimEnd()}\n; END OF FILE, no line behind it`;
const lettered = (text: string) => text.replace(/^(\d+) /gm, "N$1 ");
const written = fc.constantFrom<(text: string) => string>(
  (text) => text,
  tens,
  gaps,
  bare,
  windows,
  ended,
  lettered,
  (text) => windows(tens(text)),
);

describe("the operations of a program", () => {
  test("the flange has eight, of which two go on with a tool", () => {
    expect(summary(parse(flange))).toEqual([
      "FACING 820 T15",
      "ROUGHING OUTSIDE 812 T1",
      "- 812 T1",
      "FINISHING OUTSIDE 812 T3",
      "- 812 T3",
      "ROUGHING THE BORE 812 T5",
      "FINISHING THE BORE 812 T6",
      "GROOVE IN THE FACE 852 T8",
    ]);
  });

  test("every block between frame and end is in one section, and in one operation, its opening or its closing", () => {
    for (const text of texts) {
      const { sections, units, from, to } = operationsOf(parse(text));
      let at = from;
      for (const section of sections) {
        expect(section.from).toBe(at);
        at = section.opening.to;
        for (const unit of section.units) {
          expect(units[unit]?.from).toBe(at);
          at = units[unit]?.to ?? -1;
        }
        expect(section.closing).toEqual({ from: at, to: section.to });
        at = section.to;
      }
      expect(at).toBe(to);
    }
  });

  test("an operation without a structure comment, called by M99, with its start point before the definition", () => {
    const program = parse(
      [
        "BEGIN PGM A MM",
        "FUNCTION MODE TURN",
        "TOOL CALL 7",
        "L X+90 Z+3.5 FMAX M303",
        "CYCL DEF 812 X ~",
        "Q215=+0",
        "L X+81.3 FMAX M99",
        "L X+61.7 FMAX M99",
        "L Z+70 FMAX",
        "M30",
        "END PGM A MM",
      ].join("\n"),
    );
    const all = operationsOf(program);
    expect(all.units).toHaveLength(1);
    expect(wholeOf(all, 0)).toEqual({ from: 2, to: 8 });
    expect(all.units[0]?.fixedReason).toBeNull();
  });

  test("an operation with a jump target or a datum shift is fixed", () => {
    const text = (middle: string) =>
      `BEGIN PGM A MM\nTOOL CALL 1\nCYCL DEF 812 X ~\nQ215=+0\nL X+50 Z+2 FMAX M99\n${middle}M30\nEND PGM A MM\n`;
    expect(
      unitsOf(parse(text("LBL 4\nTOOL CALL 2\nL X+5 Z+1 F0.2\nCALL LBL 4 REP 3\n"))).map(
        ({ fixedReason }) => fixedReason,
      ),
    ).toEqual(["label", "label"]);
    expect(
      unitsOf(parse(text("TOOL CALL 2\nTRANS DATUM AXIS Z-3.2\nL X+5 Z+1 F0.2\n"))).map(
        ({ fixedReason }) => fixedReason,
      ),
    ).toEqual([null, "frame"]);
    expect(movedOperation(parse(text("TOOL CALL 2\nTRANS DATUM AXIS Z-3.2\nL X+5 Z+1 F0.2\n")), 0, 1)).toEqual({
      refused: "frame",
      unit: 1,
    });
  });

  test("a subprogram that is called is no operation, and its call is one", () => {
    const program = parse(
      "BEGIN PGM A MM\nTOOL CALL 1\nL X+9 FMAX\nCALL LBL 7\nL X+90 FMAX\nM30\nLBL 7\nL Z-4.5 F0.13\nLBL 0\nEND PGM A MM\n",
    );
    expect(unitsOf(program).map(({ from, to, fixedReason }) => [from, to, fixedReason])).toEqual([[1, 5, null]]);
  });

  test("a parameter that one operation sets and the other reads keeps them in order", () => {
    const program = parse(
      "BEGIN PGM A MM\nTOOL CALL 1\nQ7 = 3.5\nCYCL DEF 812 X ~\nQ215=+0\nL X+5 Z+2 FMAX M99\nTOOL CALL 2\nCYCL DEF 812 X ~\nQ493=+Q7\n" +
        "L X+5 Z+2 FMAX M99\nM30\nEND PGM A MM\n",
    );
    expect(movedOperation(program, 1, 0)).toEqual({ refused: "parameter", unit: 0, parameter: "Q7" });
  });
});

const all = texts.map(parse).flatMap((program) => unitsOf(program).map((_, unit) => ({ text: print(program), unit })));
/** Operations without skip marks. */
const unmarked = all.filter(({ text, unit }) => {
  const program = parse(text);
  const { from, to } = wholeOf(operationsOf(program), unit);
  return program.blocks.slice(from, to).every(({ skip }) => !skip);
});
const one = fc.constantFrom(...unmarked);
const case_ = fc.tuple(one, written).map(([{ text, unit }, write]) => ({ program: parse(write(text)), unit }));
/** A program whose operations set spindle, feed unit and contour themselves: reordering them adds nothing. */
const whole = fc.tuple(written, fc.nat(6)).map(([write, unit]) => ({ program: parse(write(flange)), unit }));

describe("an operation is changed as a whole", () => {
  test("down and up again is the same to the byte", () => {
    fc.assert(
      fc.property(whole, ({ program, unit }) => {
        const down = made(movedOperation(program, unit, unit + 1));
        expect(print(down)).not.toBe(print(program));
        expect(print(made(movedOperation(down, unit + 1, unit)))).toBe(print(program));
      }),
      { numRuns: 150 },
    );
  });

  test("doubled and taken out again is the same to the byte", () => {
    fc.assert(
      fc.property(case_, ({ program, unit }) => {
        const twice = duplicatedOperation(program, unit);
        expect(isRefused(twice)).toBe(unitsOf(program)[unit]?.fixedReason !== null);
        if (isRefused(twice)) return;
        const read = made(twice);
        expect(unitsOf(read)).toHaveLength(unitsOf(program).length + 1);
        expect(print(made(withoutOperation(read, unit + 1)))).toBe(print(program));
      }),
      { numRuns: 150 },
    );
  });

  test("switched off and on again is the same to the byte; off, it runs no call", () => {
    fc.assert(
      fc.property(case_, ({ program, unit }) => {
        const off = switchedOperation(program, unit, false);
        expect(isRefused(off)).toBe(unitsOf(program)[unit]?.fixedReason !== null);
        if (isRefused(off)) return;
        const read = made(off);
        const [then, now] = [unitsOf(program)[unit], unitsOf(read)[unit]];
        expect(now && isOff(read, now)).toBe(true);
        expect(then && isOff(program, then)).toBe(false);
        expect(print(made(switchedOperation(read, unit, true)))).toBe(print(program));
      }),
      { numRuns: 150 },
    );
  });

  test("blocks of other operations keep every byte but their numbers", () => {
    const without = (text: string) => text.replace(/^\d+ /gm, "").replace(/^M303\n/, "");
    const program = parse(flange);
    const { units } = operationsOf(program);
    const others = (p: Program, unit: number) =>
      unitsOf(p)
        .filter((_, i) => i !== unit)
        .map(({ from, to }) =>
          without(
            p.blocks
              .slice(from, to)
              .map(({ raw }) => raw)
              .join(""),
          ),
        );
    units.forEach((_, unit) => {
      if (unit === 0) return;
      expect(others(made(movedOperation(program, unit, 0)), 0)).toEqual(others(program, unit));
    });
  });
});

const shop = { tools: shippedTools, rapid: 10_000 };
const movesOf = (program: Program, skipMarked = false) => run(program, { ...shop, skipMarked });

describe("an operation keeps the settings it needs", () => {
  test("the second with a tool, moved behind another tool, calls its own, switches the spindle on, and goes back", () => {
    const moved = made(movedOperation(parse(flange), 2, 4));
    expect(summary(moved)).toEqual([
      "FACING 820 T15",
      "ROUGHING OUTSIDE 812 T1",
      "FINISHING OUTSIDE 812 T3",
      "- 812 T3",
      "ROUGHING OUTSIDE 812 T1",
      "ROUGHING THE BORE 812 T5",
      "FINISHING THE BORE 812 T6",
      "GROOVE IN THE FACE 852 T8",
    ]);
    const { from, to } = wholeOf(operationsOf(moved), 4);
    const text = moved.blocks
      .slice(from, to)
      .map(({ raw }) => raw)
      .join("");
    expect(text).toMatch(
      /TOOL CALL 1\n\d+ FUNCTION TURNDATA SPIN VCONST:ON VC:220 SMAX2500\n\d+ M136\n\d+ L X\+140 Z\+80 R0 FMAX\n/,
    );
    expect(text).toMatch(/M303\n/);
    expect(text).toMatch(/L X\+140 FMAX\n\d+ L Z\+80 FMAX\n$/);
    expect(numbers(moved)).toEqual(numbers(moved).map((_, i) => i));
    const [was, is] = [movesOf(parse(flange)), movesOf(moved)];
    expect(is.operations.map(({ tool, cycle }) => [tool.T, cycle])).toEqual(
      [0, 1, 3, 4, 2, 5, 6, 7].map((i) => [was.operations[i]?.tool.T, was.operations[i]?.cycle]),
    );
  });

  test("one that goes on with spindle and feed unit of another gets its own when it comes first", () => {
    const program = parse(
      Object.entries(goldens)
        .find(([path]) => path.endsWith("/two-tools.h"))?.[1]
        .replaceAll("+Q7", "+44.4") ?? "",
    );
    const first = made(movedOperation(program, 1, 0));
    const { from, to } = wholeOf(operationsOf(first), 0);
    expect(
      first.blocks
        .slice(from, to)
        .map(({ raw }) => raw)
        .join(""),
    ).toMatch(/^3 \* - FINISHING\n4 TOOL CALL 3\n5 FUNCTION TURNDATA SPIN VCONST:ON VC:187\.5 SMAX2345\n6 M136\n/);
  });

  test("switched off, the first with a tool leaves tool and spindle to the second, and runs no more", () => {
    const off = made(switchedOperation(parse(flange), 1, false));
    const text = print(off);
    expect(text).toContain("\n/19 CYCL DEF 812");
    expect(text).toContain("\n20 L X+100 Z+2 FMAX M303\n/21 CYCL CALL\n22 CYCL DEF");
    const [was, is] = [movesOf(parse(flange)), movesOf(off, true)];
    expect(is.operations.map(({ block }) => block)).toEqual(
      was.operations.map(({ block }) => block).filter((block) => block !== 21),
    );
  });

  test("another tool: where it is shared, the other operation keeps its own", () => {
    const other = made(retooledOperation(parse(flange), 2, 3));
    expect(summary(other).slice(1, 4)).toEqual([
      "ROUGHING OUTSIDE 812 T1",
      "ROUGHING OUTSIDE 812 T3",
      "FINISHING OUTSIDE 812 T3",
    ]);
    const alone = made(retooledOperation(parse(flange), 7, 9));
    expect(print(alone)).toBe(flange.replace("62 TOOL CALL 8\n", "62 TOOL CALL 9\n"));
  });

  test("taken out, the first with a tool leaves it to the second", () => {
    const less = made(withoutOperation(parse(flange), 1));
    expect(summary(less).slice(0, 3)).toEqual([
      "FACING 820 T15",
      "ROUGHING OUTSIDE 812 T1",
      "FINISHING OUTSIDE 812 T3",
    ]);
    expect(print(less)).toContain("18 L X+140 Z+80 R0 FMAX\n19 M303\n20 CYCL DEF 812");
  });
});

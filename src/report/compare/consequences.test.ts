import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import type { ComparedOperation } from "../../program/compare/by-operation.ts";
import {
  changedEffects,
  consequenceOf,
  effectsByUnit,
  effectsOf,
  type Effects,
  type ProgramRun,
} from "./consequences.ts";

const program = parse(
  [
    "BEGIN PGM S MM", // 0
    "FUNCTION MODE TURN",
    "* - FIRST", // 2
    "TOOL CALL 1",
    "CYCL DEF 811 CYCLE ~", // 4, 5
    " Q463=+2",
    "L X+60 Z+2 FMAX", // 6
    "CYCL CALL",
    "* - SECOND", // 8
    "TOOL CALL 3",
    "CYCL DEF 812 CYCLE ~", // 10, 11
    " Q463=+1",
    "L X+60 Z+2 FMAX", // 12
    "CYCL CALL",
    "M30",
    "END PGM S MM",
    "",
  ].join("\n"),
);

/** A call that cuts, defined in a line. */
const call = (definedLine: number, passes: number, infeed: number, seconds: number, definedFile?: string) => ({
  definedLine,
  seconds,
  plan: { passes, infeed, moves: [{}] },
  ...(definedFile !== undefined && { definedFile }),
});
const CALLS = [
  call(4, 3, 1.5, 20),
  call(10, 2, 0.5, 7),
  call(5, 4, 1.2, 30),
  { ...call(10, 9, 9, 9), plan: { passes: 9, infeed: 9, moves: [] } },
  call(4, 6, 0.7, 11, "Other.H"),
];
const LEFT = [
  { operation: 0, area: 0.25 },
  { operation: 2, area: 0.5 },
  { operation: 1, area: 2 },
  { operation: 4, area: 8 },
];
const ran = {
  run: { operations: CALLS, seconds: 99 },
  simulation: { proof: { residual: LEFT } },
} as unknown as ProgramRun;

const effects = (own: Partial<Effects> = {}): Effects => ({ passes: 5, infeed: 1, seconds: 20, residue: 0.5, ...own });

describe("the effects of a change", () => {
  test("are those of all calls of an operation: passes, time and residue add up, the infeed is the deepest", () => {
    expect([...effectsByUnit(ran, program, null)]).toEqual([
      [0, { passes: 7, infeed: 1.5, seconds: 50, residue: 0.75 }],
      [1, { passes: 2, infeed: 0.5, seconds: 7, residue: 2 }],
    ]);
    expect([...effectsByUnit(ran, program, "OTHER.h")]).toEqual([
      [0, { passes: 6, infeed: 0.7, seconds: 11, residue: 8 }],
    ]);
    expect([...effectsByUnit(ran, program, "third.h")]).toEqual([]);
    expect(effectsOf(ran)).toEqual({ passes: 24, infeed: 9, seconds: 99, residue: 10.75 });
  });

  test("belong to an operation in each program by its place there", () => {
    const [before, after] = [
      new Map([
        [0, effects()],
        [1, effects({ passes: 6 })],
      ]),
      new Map([[1, effects({ passes: 7 })]]),
    ];
    const at = (a: number | null, b: number | null) =>
      consequenceOf(
        { a: a === null ? null : { place: a }, b: b === null ? null : { place: b } } as ComparedOperation,
        before,
        after,
      );
    expect(at(0, 1)).toEqual({ before: effects(), after: effects({ passes: 7 }) });
    expect(at(1, 0)).toEqual({ before: effects({ passes: 6 }), after: null });
    expect(at(null, 1)).toEqual({ before: null, after: effects({ passes: 7 }) });
  });

  test.each<[string, Effects | null, Effects | null, readonly string[]]>([
    ["nothing", null, null, []],
    ["the same", effects(), effects(), []],
    ["too little to show", effects(), effects({ infeed: 1.0004, seconds: 20.04, residue: 0.496 }), []],
    [
      "just enough",
      effects(),
      effects({ infeed: 1.0006, seconds: 20.06, residue: 0.494 }),
      ["infeed", "seconds", "residue"],
    ],
    ["one pass", effects(), effects({ passes: 6 }), ["passes"]],
    ["all of what is added", null, effects(), ["infeed", "passes", "seconds", "residue"]],
    ["all of what is removed", effects(), null, ["infeed", "passes", "seconds", "residue"]],
  ])("that are shown: %s", (_, before, after, names) => {
    expect(changedEffects({ before, after })).toEqual(names);
  });
});

import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../run/run.ts";
import { readTools } from "../tools/read-tools.ts";

const table = readTools(
  JSON.stringify({
    tools: [
      { T: 41, NAME: "D8", TYPE: "DRILL", R: 4, "T-ANGLE": 118, LCUTS: 90 },
      { T: 43, NAME: "M8", TYPE: "TAP", R: 4, PITCH: 1.27 },
    ],
  }),
);
const mills = "tools" in table ? (table.mills ?? []) : [];
const INCH = 25.4;

/** Values of a definition: lengths are tenths of an inch, so that both units write them exactly. */
interface Cycle {
  readonly number: number;
  readonly lengths: Readonly<Record<string, number>>;
  /** mm/min; an inch program counts tenths of an inch. */
  readonly feeds?: Readonly<Record<string, number>>;
  readonly others?: Readonly<Record<string, number>>;
}

function runOf({ number, lengths, feeds = {}, others = {} }: Cycle, unit: "MM" | "INCH" = "MM") {
  const inch = unit === "INCH";
  const size = (tenths: number) => (inch ? (tenths / 10).toFixed(4) : ((tenths * INCH) / 10).toFixed(4));
  const written = [
    ...Object.entries(lengths).map(([q, v]) => `${q}=${size(v)}`),
    ...Object.entries(feeds).map(([q, v]) => `${q}=${inch ? v / (INCH / 10) : v}`),
    ...Object.entries(others).map(([q, v]) => `${q}=${v}`),
  ];
  const lines = [
    `BEGIN PGM B ${unit}`,
    `BLK FORM CYLINDER Z D${size(20)} L${size(40)} DIST+0`,
    "FUNCTION MODE TURN",
    `TOOL CALL ${number === 207 || number === 209 ? 43 : 41} Z`,
    "FUNCTION TURNDATA SPIN VCONST:OFF S600",
    "M137",
    `L X+0 Y+0 Z+${size(20)} R0 FMAX M3`,
    [`CYCL DEF ${number} HOLE`, ...written].join(" ~\n"),
    "CYCL CALL",
    "M30",
    `END PGM B ${unit}`,
    "",
  ];
  return run(parse(lines.join("\n")), { tools: [], mills, rapid: 10_000 });
}

/** Rapids, feeds and rests by their end in tenths of an inch. */
const movesOf = (cycle: Cycle, unit?: "MM" | "INCH") =>
  runOf(cycle, unit).steps.map(({ move: m }) => {
    const to = +((Number(m.to.z) * 10) / INCH).toFixed(3);
    if (m.kind !== "feed") return `${m.kind} ${to}`;
    return m.dwell ? `rest ${+m.dwell.toFixed(3)} ${to}` : `F${+m.feed.toFixed(3)}${m.feedUnit.slice(2)} ${to}`;
  });

const HEIGHTS = { Q200: 1, Q203: 2, Q204: 9 };
const FEEDS = { Q206: 127, Q208: 508 };
const DEEP: Cycle = {
  number: 205,
  lengths: { ...HEIGHTS, Q201: -25, Q202: 10, Q212: 3, Q205: 5, Q258: 0.4, Q259: 2.4, Q256: 0, Q257: 0, Q379: 0 },
  feeds: { ...FEEDS, Q253: 762 },
  others: { Q211: 0.5 },
};
const CASES: readonly (readonly [string, Cycle, readonly string[]])[] = [
  [
    "205: infeeds become smaller down to the least, and the stop distance grows with the depth",
    DEEP,
    // 10, 7, 5, then the rest; 0.4 + 2 · depth / 25 above each of them.
    [
      "rapid 3",
      "F127/min -8",
      "rapid 3",
      "rapid -6.8",
      "F127/min -15",
      "rapid 3",
      "rapid -13.24",
      "F127/min -20",
      "rapid 3",
      "rapid -17.84",
      "F127/min -23",
      "rest 5 -23",
      "F508/min 3",
      "rapid 11",
    ],
  ],
  [
    "205: from a start that lies deeper the depths count from there; whole steps break no chip at their end",
    {
      ...DEEP,
      lengths: { ...DEEP.lengths, Q202: 10, Q212: 0, Q205: 0, Q379: 5, Q257: 5, Q256: 0.5 },
      others: { Q211: 0 },
    },
    [
      "rapid 3",
      "F762/min -2",
      "F127/min -8",
      "rapid -7.5",
      "F127/min -13",
      "rapid 3",
      "rapid -11.6",
      "F127/min -18",
      "rapid -17.5",
      "F127/min -23",
      "F508/min 3",
      "rapid 11",
    ],
  ],
  [
    "205: without infeeds and without a feed of its own it retracts at the feed of the plunge",
    {
      ...DEEP,
      lengths: { ...HEIGHTS, Q201: -12, Q202: 0, Q257: 12, Q256: 1 },
      feeds: { Q206: 127 },
      others: {},
    },
    ["rapid 3", "F127/min -10", "F127/min 3", "rapid 11"],
  ],
  [
    "203: each chip break, then out of the bore, with the rest outside and the dwell at the bottom",
    {
      number: 203,
      lengths: { ...HEIGHTS, Q204: 1, Q201: -16, Q202: 6, Q212: 1, Q205: 4, Q256: 0.4 },
      feeds: FEEDS,
      others: { Q210: 0.2, Q211: 0.3, Q213: 1 },
    },
    [
      "rapid 3",
      "F127/min -4",
      "rapid -3.6",
      "F127/min -9",
      "F508/min 3",
      "rest 2 3",
      "rapid -8",
      "F127/min -13",
      "rapid -12.6",
      "F127/min -14",
      "rest 3 -14",
      "F508/min 3",
    ],
  ],
  [
    "201 and 202: down, dwell, and back",
    { number: 201, lengths: { ...HEIGHTS, Q201: -8 }, feeds: FEEDS, others: { Q211: 0.4 } },
    ["rapid 3", "F127/min -6", "rest 4 -6", "F508/min 3", "rapid 11"],
  ],
  [
    "206: back at the feed of the plunge",
    { number: 206, lengths: { ...HEIGHTS, Q201: -8 }, feeds: FEEDS, others: { Q211: 0.4 } },
    ["rapid 3", "F127/min -6", "rest 4 -6", "F127/min 3", "rapid 11"],
  ],
  [
    "209: chips broken by a count of pitches",
    { number: 209, lengths: { ...HEIGHTS, Q201: -10, Q239: 0.5, Q257: 4 }, others: { Q256: 2 } },
    [
      "rapid 3",
      "F1.27/rev -2",
      "F1.27/rev -1",
      "F1.27/rev -6",
      "F1.27/rev -5",
      "F1.27/rev -8",
      "F1.27/rev 3",
      "rapid 11",
    ],
  ],
  [
    "209: out of the bore without such a count; never above the clearance",
    { number: 209, lengths: { ...HEIGHTS, Q201: -8, Q239: 0.5, Q257: 4 }, others: { Q256: 0 } },
    ["rapid 3", "F1.27/rev -2", "F1.27/rev 3", "F1.27/rev -6", "F1.27/rev 3", "rapid 11"],
  ],
  [
    "209: a retraction that is longer than the bore ends at the clearance",
    { number: 209, lengths: { ...HEIGHTS, Q201: -8, Q239: 0.5, Q257: 4 }, others: { Q256: 40 } },
    ["rapid 3", "F1.27/rev -2", "F1.27/rev 3", "F1.27/rev -6", "F1.27/rev 3", "rapid 11"],
  ],
];

describe("drilling cycles with values that matter", () => {
  test.each(CASES)("%s", (_, cycle, moves) => {
    expect(movesOf(cycle)).toEqual(moves);
    expect(runOf(cycle).unproved).toEqual([]);
  });

  test.each(CASES)("the same in inches: %s", (_, cycle, moves) => expect(movesOf(cycle, "INCH")).toEqual(moves));

  test.each<[string, Cycle]>([
    ["a start at the bottom", { ...DEEP, lengths: { ...DEEP.lengths, Q379: 25 } }],
    ["a start below the bottom", { ...DEEP, lengths: { ...DEEP.lengths, Q379: 30 } }],
    ["more chip breaks than anybody means", { ...DEEP, lengths: { ...DEEP.lengths, Q257: 0.004, Q256: 0.002 } }],
    ["a negative clearance", { ...DEEP, lengths: { ...DEEP.lengths, Q200: -1 } }],
    ["no pitch", { number: 209, lengths: { ...HEIGHTS, Q201: -8, Q239: 0, Q257: 4 } }],
  ])("%s is no bore", (_, cycle) => {
    const done = runOf(cycle);
    expect(done.steps.filter((s) => s.move.kind !== "rapid")).toEqual([]);
    expect(done.unproved).toHaveLength(1);
  });
});

import { expect, test } from "vitest";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { simulate } from "../sim/simulate.ts";
import { report } from "./report.ts";

/** Q1 is almost 0 and Q2 almost infinite, as far as a computer counts. */
const HEAD = [
  "BEGIN PGM FINITE MM",
  "BLK FORM CYLINDER Z D80 L100 DIST+1",
  "TOOL CALL 1",
  "FUNCTION MODE TURN",
  "FUNCTION TURNDATA SPIN VCONST:OFF S800",
  "M136",
  "Q1 = 1 / 10000000000",
  "Q2 = 4200000000",
  ...Array.from({ length: 5 }, () => ["Q1 = Q1 * Q1", "Q2 = Q2 * Q2"]).flat(),
  "L X+110 Z+30 R0 FMAX M303",
];

const shoulder = (changed: string): string[] => [
  "CYCL DEF 811 SHOULDER, LONGITDNL. ~",
  ...["Q215=+0", "Q460=+2", "Q493=+60", "Q494=-20", "Q463=+2", "Q478=+0.3", "Q483=+0.4", "Q484=+0.2", "Q505=+0.2"].map(
    (value) => `${value.slice(0, 5) === changed.slice(0, 5) ? changed : value} ~`,
  ),
  "Q506=+0",
  "L X+84 Z+2 FMAX",
  "CYCL CALL",
];
/** A contour as far as Q2, in passes of the least infeed. */
const along = [
  "CYCL DEF 14.0 CONTOUR",
  "CYCL DEF 14.1 CONTOUR LABEL 5",
  "CYCL DEF 810 TURN CONTOUR LONG. ~",
  ...[
    "Q215=+0",
    "Q460=+2",
    "Q499=+0",
    "Q463=+0.001",
    "Q478=+0.3",
    "Q483=+0.4",
    "Q484=+0.2",
    "Q505=+0.2",
    "Q487=+1",
  ].map((value) => `${value} ~`),
  ...["Q488=+0.1 ~", "Q479=+0 ~", "Q480=+0 ~", "Q482=+0 ~", "Q506=+0"],
  "L X+84 Z+2 FMAX",
  "CYCL CALL",
  "M30",
  "LBL 5",
  "L X+20 Z+0",
  "L Z-Q2",
  "L X+Q2",
  "LBL 0",
];
const DIGITS = "9".repeat(400);

/** Far beyond every size, time and count of a part. */
const FAR = 1e20;

/** Where a value holds a number that is not finite, or beyond all reason. */
function infiniteIn(value: unknown, path = ""): string[] {
  if (typeof value === "number") return Math.abs(value) < FAR ? [] : [`${path}: ${value}`];
  if (typeof value === "string") return /Infinity|NaN/.test(value) ? [`${path}: ${value}`] : [];
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([name, each]) => infiniteIn(each, `${path}.${name}`));
}

test.each([
  ...["Q463=+Q1", "Q478=+Q1", "Q494=-Q2", "Q460=+Q2", "Q483=+Q1", `Q463=+${DIGITS}`].map((value) => shoulder(value)),
  along,
  ["L X+60 Z-3 F+Q1", "L Z-9"],
  ["M137", "L X+60 Z-3 F+Q1", "L Z-9"],
  ["L X+Q2 Z-3 F+Q2", "L X+90"],
  [`L X+${DIGITS} Z-${DIGITS} F0.2`],
  ["FUNCTION TURNDATA SPIN VCONST:OFF S+Q1", "L X+60 Z-3 F0.2"],
  ["FUNCTION TURNDATA SPIN VCONST:ON VC:+Q2 SMAX+Q1", "L X+60 Z-3 F0.2"],
  ["CYCL DEF 9.0 DWELL TIME", `CYCL DEF 9.1 DWELL +${DIGITS}`, "L X+70 F0.2"],
  ["TRANS DATUM Z+Q2", "L X+60 Z+0 F0.2"],
  ["L X+60 Z-3 F0.2", "CC X+Q2 Z+0", "C X+80 Z+0 DR+"],
  ["L X+70 Z-3 RR F0.2", "RND R+Q2", "L X+80 Z-20"],
  ["FN 4: Q3 = +1 DIV +Q1", "L X+Q3 F0.2"],
])("every number of a report is finite: %s", (...body) => {
  const text = [...HEAD, ...body.flat(), "L X+200 Z+100 FMAX", "M30", "END PGM FINITE MM", ""].join("\n");
  const made = run(parse(text), { tools: shippedTools, rapid: 10_000 });
  const milliseconds = { parse: 0, plan: 0, simulate: 0 };
  expect(infiniteIn(report({ file: "FINITE.H", run: made, simulation: simulate(made), milliseconds }, "en"))).toEqual(
    [],
  );
});

import { expect, test } from "vitest";
import type { Tool } from "../kernel/plan/tool.ts";
import { length } from "../kernel/units.ts";
import { parse } from "../nc/parse.ts";
import { run } from "../program/run/run.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { simulate } from "../sim/simulate.ts";
import { verdictOf } from "./verdict.ts";

const head = `0 BEGIN PGM V MM
1 BLK FORM CYLINDER Z D75 L100 DIST+0
2 FUNCTION MODE TURN
3 TOOL CALL 1
4 FUNCTION TURNDATA SPIN VCONST:ON VC:150 SMAX2500
5 M136
6 L X+160 Z+60 R0 FMAX
`;
const cycle = `7 CYCL DEF 812 ABSATZ LAENGS ERW. ~
 Q215=+0 ~
 Q460=+2 ~
 Q491=+75 ~
 Q492=+0 ~
 Q493=+50.5 ~
 Q494=-55.3 ~
 Q495=+0 ~
 Q501=+0 ~
 Q502=+0.5 ~
 Q500=+1.5 ~
 Q496=+0 ~
 Q503=+0 ~
 Q504=+0.5 ~
 Q463=+3 ~
 Q478=+0.3 ~
 Q483=+0.4 ~
 Q484=+0.2 ~
 Q505=+0.2 ~
 Q506=+0
8 L X+75 Z+2 R0 FMAX M303
9 CYCL CALL
`;
const end = "10 M30\n11 END PGM V MM\n";
const holder = { width: length(20), length: length(80), offsetZ: length(6), offsetX: length(14) };
const tools: readonly Tool[] = shippedTools.map((t) => ({ ...t, holder }));
const judge = (text: string, own = tools) => {
  const made = run(parse(text), { tools: own, rapid: 10_000 });
  return verdictOf(made, simulate(made));
};

test("a clean program with a described holder is verified, and clear", () => {
  expect(judge(head + cycle + end)).toEqual({ verdict: "proved", reasons: [], isClear: true });
});

test("an undescribed holder keeps the verdict, but is never clear", () => {
  const bare = tools.map(({ holder: _, ...t }) => t);
  expect(judge(head + cycle + end, bare)).toEqual({
    verdict: "proved",
    isClear: false,
    reasons: [{ kind: "holderUnknown", block: 8, tool: 1, name: "CNMG-80-R08" }],
  });
});

test("undescribed flanks are not clear either", () => {
  const open = tools.map(({ "P-ANGLE": _, ...t }) => t);
  const judged = judge(head + cycle + end, open);
  expect(judged.isClear).toBe(false);
  expect(judged.reasons).toContainEqual({ kind: "flanksUnknown", block: 8, tool: 1, name: "CNMG-80-R08" });
});

test("an operation that cut nothing makes it incomplete: the second call of the same cycle", () => {
  const judged = judge(`${head}${cycle}10 L X+75 Z+2 R0 FMAX\n11 CYCL CALL\n12 M30\n13 END PGM V MM\n`);
  expect(judged).toMatchObject({
    verdict: "incomplete",
    reasons: [{ kind: "nothingCut", block: 11, operation: 1 }],
    isClear: false,
  });
});

test("no operation at all is incomplete", () => {
  expect(judge(head + end)).toMatchObject({ verdict: "incomplete", reasons: [{ kind: "noOperation", block: null }] });
});

test("a cycle that is not simulated makes it incomplete from its block on", () => {
  const kept = `10 CYCL DEF 835 TIEFLOCH ~\n Q460=+2\n11 L X+75 Z+2 R0 FMAX\n12 CYCL CALL\n13 M30\n14 END PGM V MM\n`;
  const judged = judge(head + cycle + kept);
  expect(judged.verdict).toBe("incomplete");
  expect(judged.reasons).toContainEqual({ kind: "unproved", block: 12, what: "CYCL DEF 835 TIEFLOCH" });
});

test("milling between turning is not verified", () => {
  const milled = "10 FUNCTION MODE MILL\n11 L X+50 Y+0 R0 FMAX\n12 L X+60 Y+7 R0 F200\n13 M30\n14 END PGM V MM\n";
  expect(judge(head + cycle + milled).reasons).toContainEqual({ kind: "milling", block: 12 });
});

test("a fault outweighs a gap: both are reported, the fault first", () => {
  const rapid = `${head}7 L X-12.5 Z-20 FMAX\n8 M30\n9 END PGM V MM\n`;
  const judged = judge(rapid);
  expect(judged.verdict).toBe("faults");
  expect(judged.reasons.map((r) => r.kind)).toEqual(["rapidInStock", "holderContact", "noOperation"]);
});

test("an error of the program is a fault", () => {
  expect(judge(head + cycle.replace("Q493=+50.5", "Q493=+75") + end).reasons[0]).toMatchObject({
    kind: "error",
    block: 7,
    count: 1,
  });
});

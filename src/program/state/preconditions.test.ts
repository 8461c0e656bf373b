import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const VALUES =
  "Q215=+0 Q460=+2 Q491=+75 Q492=+0 Q493=+50 Q494=-55 Q495=+5 Q501=+1 Q502=+0.5 Q500=+1.5 Q496=+0 Q503=+1 Q504=+0.5 Q463=+3 " +
  "Q478=+0.3 Q483=+0.4 Q484=+0.2 Q505=+0.2 Q506=+0";
const CONTOUR_VALUES =
  "Q215=+0 Q460=+2 Q499=+0 Q463=+3 Q478=+0.3 Q483=+0.4 Q484=+0.2 Q505=+0.2 Q487=+1 Q488=+0 Q479=+0 Q480=+0 Q482=+0 Q506=+0";
const defined = (number: number, values: string) => `CYCL DEF ${number} NAME ~\n${values.split(" ").join(" ~\n")}`;
const SHOULDER = defined(812, VALUES);
const OUTLINE = "LBL 2\nL X+75 Z-20\nL X+50\nRND R2\nL X+20 Z-25\nRND R2\nL Z+0\nLBL 0";
const FREE = `CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL2\n${defined(820, CONTOUR_VALUES)}`;
const TO_START = "L X+75 Z+2 R0 FMAX";

interface Frame {
  readonly mode?: string;
  readonly tool?: string;
  readonly m136?: string;
  readonly unit?: string;
}
const program = (
  body: string,
  { mode = "FUNCTION MODE TURN", tool = "TOOL CALL 1", m136 = "M136", unit = "MM" }: Frame = {},
) =>
  [
    "BEGIN PGM T " + unit,
    "BLK FORM CYLINDER Z D75 L100 DIST+0",
    mode,
    tool,
    "FUNCTION TURNDATA SPIN VCONST:ON VC:150 SMAX2500",
    m136,
    "L X+160 Z+60 R0 FMAX M303",
    body,
    "END PGM T " + unit,
    "",
  ]
    .filter((l, i) => l !== "" || i > 7)
    .join("\n");
const made = (body: string, frame?: Frame) => run(parse(program(body, frame)), { tools: shippedTools, rapid: 10_000 });
/** Findings above a notice as "severity code@block" with the field; blocks count from 0 as the control numbers them. */
const said = (body: string, frame?: Frame) =>
  made(body, frame)
    .issues.filter((f) => f.issue.severity !== "info")
    .map(
      (f) => `${f.issue.severity} ${f.issue.code}${"at" in f.issue && f.issue.at ? ` ${f.issue.at}` : ""}@${f.block}`,
    );

const CALLED = `${SHOULDER}\n${TO_START}\nCYCL CALL\nM30`;
const FREE_CALLED = `${FREE}\n${TO_START}\nCYCL CALL\nM30\n${OUTLINE}`;
const FACING: Frame = { tool: "TOOL CALL 15" };

test("the programs that the cases are made from have no fault", () => {
  expect(said(CALLED)).toEqual([]);
  expect(said(FREE_CALLED, FACING)).toEqual([]);
});

describe("a cycle call", () => {
  test.each<[string, string, string[], Frame?]>([
    ["no FUNCTION MODE", CALLED, ["error notInTurnMode@8"], { mode: "" }],
    [
      "FUNCTION MODE only behind it",
      CALLED.replace("M30", "FUNCTION MODE TURN\nM30"),
      ["error notInTurnMode@8"],
      { mode: "" },
    ],
    ["FUNCTION MODE MILL", CALLED, ["error notInTurnMode@9"], { mode: "FUNCTION MODE MILL" }],
    [
      "RR on the way to the start point",
      CALLED.replace(TO_START, "L X+80 Z+5 RR F0.2\nL X+75 Z+2"),
      ["error compensationActive@10"],
    ],
    [
      "RL in the block of M99",
      CALLED.replace(`${TO_START}\nCYCL CALL`, "L X+75 Z+2 RL F0.2 M99"),
      ["error compensationActive@8"],
    ],
    [
      "RL from an arc",
      CALLED.replace(TO_START, "CR X+75 Z+2 R+200 DR+ RL F0.2"),
      ["error controlRule@8", "error compensationActive@9"],
    ],
    ["R0 again before it", CALLED.replace(TO_START, "L X+80 Z+5 RR F0.2\nL X+75 Z+2 R0"), []],
    ["defined and not called", CALLED.replace("CYCL CALL\n", ""), ["warning cycleNeverCalled@7"]],
    [
      "defined again before its call",
      CALLED.replace(TO_START, `${SHOULDER}\n${TO_START}`),
      ["warning cycleNeverCalled@7"],
    ],
    ["called behind M30", `${SHOULDER}\n${TO_START}\nM30\nCYCL CALL`, ["warning neverReached@10"]],
    ["a position behind M30 and another", `${CALLED}\n${TO_START}\nL Z+5`, ["warning neverReached@11"]],
    ["M2 in a block, then a call", `${SHOULDER}\nL X+75 Z+2 FMAX M2\nCYCL CALL`, ["warning neverReached@9"]],
    [
      "an unknown parameter, and one twice",
      CALLED.replace("Q506=+0", "Q506=+0 ~\nQ999=+5 ~\nQ478=+0.3"),
      ["warning parameterForeign Q999@7", "warning parameterForeign Q478@7"],
    ],
    [
      "M89 calls at each position until M99",
      `${SHOULDER}\nL X+75 Z+2 FMAX M89\nL X+75 Z+2 FMAX M99\nL X+90 FMAX\nM30`,
      [],
    ],
  ])("%s", (_, body, expected, frame) => expect(said(body, frame)).toEqual(expected));

  test("without FUNCTION MODE TURN it is planned and shown all the same", () => {
    const whole = made(CALLED).operations[0]?.plan;
    expect(made(CALLED, { mode: "" }).operations[0]?.plan).toEqual(whole);
    expect(made(CALLED, { mode: "FUNCTION MODE MILL" }).operations[0]?.plan).toEqual(whole);
  });
  test("M89 runs the cycle at every positioning block, M99 ends it", () =>
    expect(
      made(`${SHOULDER}\nL X+75 Z+2 FMAX M89\nL X+76 Z+2 FMAX\nL X+77 Z+2 FMAX M99\nL X+90 FMAX\nM30`).operations,
    ).toHaveLength(3));
  test("a foreign parameter is reported on its own line", () => {
    const lines = made(CALLED.replace("Q506=+0", "Q506=+0 ~\nQ999=+5 ~\nQ478=+0.3")).issues.map((f) => f.line);
    expect(lines).toEqual([28, 29]);
  });
});

describe("feeds", () => {
  const shoulder = (change: [string, string][], frame?: Frame) =>
    said(
      change.reduce((t, [a, b]) => t.replace(a, b), CALLED),
      frame,
    );
  const contour = (change: [string, string][]) =>
    said(
      change.reduce((t, [a, b]) => t.replace(a, b), FREE_CALLED),
      FACING,
    );
  test("0 and FAUTO without a feed, for each feed that the operation runs with", () => {
    expect(shoulder([["Q478=+0.3", "Q478=+0"]])).toEqual(["error feedZero Q478@7"]);
    expect(
      shoulder([
        ["Q478=+0.3", "Q478=FAUTO"],
        ["Q505=+0.2", "Q505=FAUTO"],
      ]),
    ).toEqual(["error feedZero Q478@7", "error feedZero Q505@7"]);
    expect(
      shoulder([
        ["Q215=+0", "Q215=+1"],
        ["Q505=+0.2", "Q505=+0"],
      ]),
    ).toEqual([]);
    expect(
      shoulder([
        ["Q215=+0", "Q215=+2"],
        ["Q478=+0.3", "Q478=+0"],
      ]),
    ).toEqual([]);
    expect(shoulder([["Q478=+0.3", "Q478=FAUTO"]], { tool: "TOOL CALL 1 F0.25" })).toEqual([]);
  });
  test("FAUTO is the feed of TOOL CALL, whatever a path block said since", () => {
    const body = CALLED.replace("Q478=+0.3", "Q478=FAUTO").replace(TO_START, `L X+80 Z+3 R0 F0.9\n${TO_START}`);
    const moves = made(body, { tool: "TOOL CALL 1 F0.25" }).operations[0]?.plan.moves ?? [];
    const roughing = moves.flatMap((m) => (m.kind === "feed" && m.phase === "rough" ? [m.feed] : []));
    expect([...new Set(roughing)]).toEqual([0.25]);
  });
  test("Q488 = 0 is automatic, FAUTO without a feed is not", () => {
    expect(contour([["Q488=+0", "Q488=+0"]])).toEqual([]);
    expect(contour([["Q478=+0.3", "Q478=+0"]])).toEqual(["error feedZero Q478@9"]);
  });
  test("implausible feeds", () => {
    expect(shoulder([["Q478=+0.3", "Q478=+300"]])).toEqual(["warning feedUnlikely Q478@7"]);
    expect(shoulder([], { m136: "" })).toEqual(["warning feedUnlikely Q478@6", "warning feedUnlikely Q505@6"]);
    expect(
      shoulder(
        [
          ["Q478=+0.3", "Q478=+300"],
          ["Q505=+0.2", "Q505=+100"],
        ],
        { m136: "" },
      ),
    ).toEqual([]);
    expect(said("L X+90 Z+5 F200\nL Z+4\nL Z+3\nM30")).toEqual(["warning feedUnlikely F@7"]);
    expect(said("L X+90 Z+5 F200\nM136\nL Z+4\nL Z+3\nM30", { m136: "" })).toEqual(["warning feedUnlikely F@8"]);
    expect(said("L X+90 Z+5 F0.2\nM30", { m136: "" })).toEqual(["warning feedUnlikely F@6"]);
    expect(said("L X+3 Z+0.2 F0.01\nM30", { unit: "INCH" })).toEqual([]);
    expect(said("L X+3 Z+0.2 F0.3\nM30", { unit: "INCH" })).toEqual(["warning feedUnlikely F@7"]);
  });
  test("plain cuts with F0 or FAUTO, once where it begins", () => {
    expect(said("L X+90 Z+5 F0\nL Z+4\nL Z+3 F0.2\nM30")).toEqual(["error feedZero F@7"]);
    expect(said("L X+90 Z+5 FAUTO\nL Z+4\nM30")).toEqual(["error feedZero F@7"]);
    expect(said("L X+90 Z+5 FAUTO\nM30", { tool: "TOOL CALL 1 F0.2" })).toEqual([]);
    expect(said("L X+90 Z+5\nL Z+4\nL Z+3\nM30")).toEqual(["error feedMissing@7"]);
  });
});

describe("a fault is reported once, with its cause", () => {
  test.each<[string, string, string[], Frame?]>([
    ["the program runs into its contour", FREE_CALLED.replace("M30\n", ""), ["error runsIntoLabel@12"], FACING],
    ["no tool", CALLED, ["error noToolCalled@8"], { tool: "" }],
    ["a tool that is not in the table", CALLED, ["error toolUnknown tool@3"], { tool: "TOOL CALL 99" }],
    [
      "the label of the contour is missing",
      FREE_CALLED.replace("LBL 2\n", "LBL 3\n"),
      ["error labelMissing@11", "warning neverReached@14"],
      FACING,
    ],
    ["a label twice", `${FREE_CALLED}\n${OUTLINE}`, ["error labelTwice@21"], FACING],
    [
      "the first block of the contour is incomplete",
      FREE_CALLED.replace("L X+75 Z-20", "L X+75"),
      ["error contourStartIncomplete@14"],
      FACING,
    ],
    [
      "a parameter without a value, used again and again",
      "Q5 = Q1 + 1\nL X+Q5 FMAX\nL Z+Q1 FMAX\nL Z-Q5 FMAX\nM30",
      ["error parameterUnset Q1@7"],
    ],
    ["a cycle with such a parameter", CALLED.replace("Q493=+50", "Q493=+Q90"), ["error parameterUnset Q90@7"]],
    ["a start point that hangs on one", CALLED.replace("L X+75 Z+2", "L X+Q90 Z+2"), ["error parameterUnset Q90@8"]],
    [
      "an APPR in PS with RL",
      "L X+100 Z+10 RL F0.2\nAPPR LT X+60 Z+0 LEN3 RL F0.2\nL Z-20\nDEP LT LEN3\nM30",
      ["error compensationActive@8"],
    ],
    [
      "an APPR without a side",
      "L X+100 Z+10 R0 FMAX\nAPPR LT X+60 Z+0 LEN3 F0.2\nL Z-20\nDEP LT LEN3\nM30",
      ["warning approachUncompensated@8"],
    ],
    [
      "an APPR LT from inside the contour",
      "L X+100 Z+10 R0 FMAX\nAPPR LT X+60 Z+0 LEN-3 RL F0.2\nL Z-20\nDEP LT LEN3\nM30",
      ["error outOfRange LEN@8"],
    ],
  ])("%s", (_, body, expected, frame) => expect(said(body, frame)).toEqual(expected));

  test("the actual number of the element is reported, not always the first", () => {
    const element = (body: string) =>
      made(`L X+100 Z+10 F0.2\nL X+60\nL Z-10\nL X+62\nRND R5\nL Z-20\n${body}M30`).issues.find(
        (f) => f.issue.code === "cornerElementTooLong",
      )?.issue.data;
    expect(element("")).toMatchObject({ element: 4 });
  });
});

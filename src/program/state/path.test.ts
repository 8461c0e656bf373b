import { describe, expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { readContour } from "../blocks/contour-subprogram.ts";
import { Machine } from "./machine.ts";
import { runInput } from "./run-input.ts";
import type { Shop } from "./shop.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const shop: Shop = { tools: shippedTools, rapid: 10_000 };
const n = (value: number) => Math.round(value * 1e6) / 1e6 + 0;
type Corner = {
  readonly from: readonly number[];
  readonly to: readonly number[];
  readonly centre: readonly number[] | null;
};
const corner = (from: readonly number[], to: readonly number[], centre: readonly number[] | null): Corner => ({
  from: from.map(n),
  to: to.map(n),
  centre: centre && centre.map(n),
});

/** `u` is the first axis of the plane, `v` the second: in turning Z and a diameter. */
const turned = (text: string) =>
  text.replace(/v([+-]?[\d.]+)/g, (_, v: string) => `X${2 * Number(v)}`).replaceAll("u", "Z");
const milledText = (text: string) => text.replaceAll("v", "Y").replaceAll("u", "X");
const onMainLevel = (text: string) =>
  run(
    parse(`BEGIN PGM T MM\nFUNCTION MODE TURN\nTOOL CALL 15\n${turned(text)}\nL IZ+1 FMAX M30\nEND PGM T MM`),
    shop,
  ).steps.flatMap(({ from, move }) =>
    move.kind === "rapid"
      ? []
      : [corner([from.z, from.r], [move.to.z, move.to.r], move.kind === "arc" ? [move.centre.z, move.centre.r] : null)],
  );
const inContour = (text: string) =>
  readContour(new Machine(runInput(parse(`LBL 1\n${turned(text)}\nLBL 0`), shop)), 1, 0)?.contour.segments.map((s) =>
    corner([s.from.z, s.from.r], [s.to.z, s.to.r], s.kind === "arc" ? [s.centre.z, s.centre.r] : null),
  );
const milled = (text: string) =>
  run(
    parse(
      `BEGIN PGM T MM\nTOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z S4000\nL Z+20 R0 FMAX\n${milledText(text)}\nL IX+1 FMAX M30\nEND PGM T MM`,
    ),
    shop,
  ).plane.flatMap((s) =>
    s.kind === "rapid" || s.seconds === 0
      ? []
      : [corner([s.from.x, s.from.y], [s.to.x, s.to.y], s.centre ? [s.centre.x, s.centre.y] : null)],
  );

describe("a block leads to the same place on the main level, in a contour and under a mill", () => {
  test.each([
    ["L", "L u0 v10 F100\nL u-10 v12\nL Iu-5"],
    ["CR", "L u0 v10 F100\nL u-10\nCR u-20 v20 R+12 DR-"],
    ["CR the longer way", "L u0 v30 F100\nL u-10\nCR u-20 v40 R-12 DR+"],
    ["C", "L u0 v10 F100\nCC u-10 v10\nC u-10 v20 DR-"],
    ["CC that leaves out an axis", "L u0 v10 F100\nCC u-10\nC u-10 v20 DR-"],
    ["CT", "L u0 v10 F100\nL u-10\nCT u-20 v20"],
    ["LP", "L u0 v10 F100\nCC u-20 v10\nLP PR+10 PA+90"],
    ["LP that keeps its distance", "L u0 v10 F100\nCC u-20 v10\nLP PA+90"],
    ["LP with an incremental distance and angle", "L u0 v10 F100\nCC u-20 v10\nLP IPR-5 IPA+45"],
    ["CP", "L u0 v10 F100\nCC u-20 v10\nCP PA+90 DR+"],
    ["CTP", "L u0 v10 F100\nL u-5\nCC u-20 v10\nCTP PR+10 PA+90"],
  ])("%s", (_, text) => {
    const main = onMainLevel(text);
    expect(main.length).toBeGreaterThan(0);
    expect(inContour(text)).toEqual(main);
    expect(milled(text)).toEqual(main);
  });
});

const codes = (text: string) =>
  run(parse(`BEGIN PGM T MM\n${text}\nM30\nEND PGM T MM`), shop)
    .issues.map((f) => `${f.issue.code}@${f.block}`)
    .filter((c) => !c.startsWith("frameMissing"));
const TURNING = "FUNCTION MODE TURN\nTOOL CALL 15\nL X+20 Z+0 F100\nCC X+20 Z-20";
const MILLING = "TOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z S4000\nL X+0 Y+10 Z+5 F100\nCC X-20 Y+10";

describe("an unknown value is reported once, and the position is unknown until it is programmed again", () => {
  test.each([
    ["an end round the pole", "LP PR+Q1 PA+90", ["parameterUnset@5"]],
    ["a radius", "CR Z-5 X+20 R+Q1 DR+", ["parameterUnset@5"]],
    ["a distance that is added to", "LP IPR+Q1 PA+90", ["parameterUnset@5"]],
  ])("%s", (_, block, expected) => {
    expect(codes(`${TURNING}\n${block}`)).toEqual(expected);
    expect(codes(`${MILLING}\n${block.replace("Z-5 X+20", "X-5 Y+10")}`)).toEqual(expected);
  });
  test("the way to the point behind it is no cut from where the tool stood before", () => {
    const { steps } = run(
      parse(`BEGIN PGM T MM\n${TURNING}\nLP PR+Q1 PA+90\nL X+40\nL Z-50\nL Z-60\nEND PGM T MM`),
      shop,
    );
    expect(steps.map((s) => [s.from.z, s.move.to.z])).toEqual([[-50, -60]]);
  });
  test("polar words that count from an unknown point", () => {
    expect(codes("FUNCTION MODE TURN\nTOOL CALL 15\nCC X+20 Z-20\nLP IPR+5 PA+90 F100")).toEqual(["startUnknown@4"]);
  });
});

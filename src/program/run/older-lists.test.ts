import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { exampleJob } from "../job/job.ts";
import { printJob } from "../job/print-job.ts";
import { run } from "./run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const LATER = { Q510: 0.8, Q511: 100, Q462: 0, Q211: 0, Q562: 0 };

/** The example of a cycle with these values, and with a list of older software that lacks them. */
function both(number: number, values: Readonly<Record<string, number>>): readonly [string, string] {
  const cycle = cycleByNumber(number);
  if (!cycle) throw new Error(`no cycle ${number}`);
  const job = exampleJob(cycle);
  const typed = Object.fromEntries(Object.entries(values).map(([q, value]) => [q, String(value)]));
  const whole = printJob({ ...job, drafts: { [number]: { ...job.drafts[number], ...typed } } }, ncLabels("en"));
  const lines = whole.split("\n").filter((line) => !Object.keys(values).some((q) => line.startsWith(`${q}=`)));
  // The new last line of the list has no continuation.
  const last = lines.findLastIndex((line) => /^Q\d+=/.test(line));
  return [whole, lines.with(last, (lines[last] ?? "").replace(/ ~$/, "")).join("\n")];
}
const ran = (text: string) => run(parse(text), { tools: shippedTools, rapid: 10_000 });
const said = (text: string) => ran(text).issues.map(({ issue }) => issue);
const placeOf = (issue: object) => ("at" in issue ? issue.at : null);

describe("lists that older software wrote", () => {
  const all = { Q463: 0, ...LATER };
  test.each<[number, Readonly<Record<string, number>>]>([
    [860, LATER],
    [861, LATER],
    [861, all],
    [862, LATER],
    [870, LATER],
    [871, all],
    [872, LATER],
    [862, { Q562: 0 }],
    [872, { Q211: 0, Q562: 0 }],
    [852, { Q488: 0 }],
  ])("%i without %j runs with what the control fills in", (number, values) => {
    const [whole, older] = both(number, values);
    expect(ran(older).steps.map(({ move }) => move)).toEqual(ran(whole).steps.map(({ move }) => move));
    expect(ran(older).steps.length).toBeGreaterThan(10);
    const filled = Object.entries(values).map(([q, value]) => `${q}=${value}`);
    expect(said(older).filter(({ code }) => code === "listOfOlderSoftware")).toEqual([
      {
        code: "listOfOlderSoftware",
        severity: "info",
        data: { cycle: number, filled: expect.arrayContaining(filled) as unknown },
      },
    ]);
    expect(said(whole).filter(({ code }) => code === "listOfOlderSoftware")).toEqual([]);
    expect(said(older).filter(({ severity }) => severity === "error")).toEqual([]);
  });

  test.each([
    [862, "Q478"],
    [852, "Q463"],
    [811, "Q463"],
  ])("%i without %s lacks a value that no software left out", (number, q) => {
    const [, older] = both(number, { [q]: 1 });
    expect(
      said(older)
        .filter(({ code }) => code === "missing")
        .map(placeOf),
    ).toEqual([q]);
  });

  test("a parameter that is there without a value is missing, as on the control", () => {
    const [whole] = both(862, LATER);
    expect(said(whole.replace(/Q510=\S+/, "Q510=")).map((i) => `${i.code} ${placeOf(i) ?? ""}`)).toContain(
      "missing Q510",
    );
  });

  test("are reported once, however many there are", () => {
    const [, older] = both(861, LATER);
    const [, call = ""] = /(\d+ CYCL DEF 861[\s\S]*?CYCL CALL\n)/.exec(older) ?? [];
    expect(said(older.replace(call, call + call)).filter(({ code }) => code === "listOfOlderSoftware")).toHaveLength(1);
  });
});

import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../src/cycles/index.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { exampleJob } from "../src/program/job/job.ts";
import { parse } from "../src/nc/parse.ts";
import { issuesOf } from "../src/nc/program.ts";
import { printAsInManual, printJob } from "../src/program/job/print-job.ts";

const programs = import.meta.glob<string>("./programs/cycle-*.h", { query: "?raw", import: "default", eager: true });

/** A page's text with its misprints corrected, without block numbers. */
const comparable = (text: string) =>
  text
    .replaceAll("Q493+50", "Q493=+50")
    .replaceAll("Q499 =", "Q499=")
    .split("\n")
    .map((line) => line.replace(/^\d+( +)/, "#$1"));

/** One printed page has one space before M303, two others two: we print two. */
const positioning = (lines: string[]) =>
  lines.map((line) => (/M303/.test(line) ? line.replace(/FMAX +M/, "FMAX M") : line));

describe("the printed examples, from their example values", () => {
  test.each([
    [812, "tnc640", "fr", "cycle-812-tnc640-fr"],
    [820, "tnc640", "fr", "cycle-820-tnc640-fr"],
    [820, "tnc7", "en", "cycle-820-tnc7-en"],
    [852, "tnc640", "fr", "cycle-852-tnc640-fr"],
  ] as const)("%i %s %s, character for character", (number, layout, ncLanguage, file) => {
    const cycle = cycleByNumber(number);
    const printed = programs[`./programs/${file}.h`];
    if (!cycle || printed === undefined) throw new Error(`${number}: no cycle or no example`);
    const job = { ...exampleJob(cycle), layout, ncLanguage };
    // The French pages omit ` ~`: they show a view, and the file has the mark.
    const text = layout === "tnc640" ? printAsInManual(job, ncLabels(ncLanguage)) : printJob(job, ncLabels(ncLanguage));
    const ours = positioning(comparable(text));
    const page = positioning(comparable(printed.trimEnd()));
    const call = page.indexOf("# CYCL CALL");
    const start = ours.indexOf(page[0] ?? "");
    expect(ours.slice(start, start + call + 1)).toEqual(page.slice(0, call + 1));
    const rest = page.slice(call + 1);
    const behind = ours.indexOf(rest[0] ?? "");
    expect(ours.slice(behind, behind + rest.length)).toEqual(rest);
    expect(text).toMatchSnapshot();
    const made = printJob(job, ncLabels(ncLanguage));
    expect(made).toMatchSnapshot();
    expect(issuesOf(parse(made))).toEqual([]);
    expect(parse(made).blocks.map((b) => b.statement)).toEqual(parse(text).blocks.map((b) => b.statement));
  });
});

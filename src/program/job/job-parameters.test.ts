import { describe, expect, test } from "vitest";
import { catalogue } from "../../cycles/index.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { parse } from "../../nc/parse.ts";
import { parametersIn } from "../values/expression.ts";
import { exampleJob, type SetJob } from "./job.ts";
import { knownParameters, usedParameters } from "./job-parameters.ts";
import { printJob } from "./print-job.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const cycle = catalogue.find((c) => c.params["Q493"]);
if (!cycle) throw new Error("no cycle ends at a diameter");
const example = exampleJob(cycle);
const job = (draft: Record<string, string>, parameters: Record<string, string> = {}): SetJob => ({
  ...example,
  parameters,
  drafts: { [cycle.number]: { ...example.drafts[cycle.number], ...draft } },
});
const lines = (of: SetJob) => printJob(of, ncLabels("en")).split("\n");
const pathOf = (of: SetJob) => run(parse(printJob(of, ncLabels("en"))), { tools: shippedTools, rapid: 10_000 });

test.each<[string, readonly string[]]>([
  ["Q5", ["Q5"]],
  ["q5/2+QL12", ["Q5", "QL12"]],
  ["-qr3", ["QR3"]],
  ["25", []],
  ["", []],
  ["FAUTO", []],
  ["Q12345", []],
  ["3Q5", []],
])("parameters in %j", (text, names) => expect(parametersIn(text)).toEqual(names));

describe("Q parameters of a job", () => {
  test("those in the prompts are listed by number, each once", () =>
    expect(usedParameters(job({ Q493: "q20", Q494: "-Q5", Q463: "Q5/2" }))).toEqual(["Q5", "Q20"]));

  test("values are read as typed; invalid ones are unknown", () =>
    expect(knownParameters(job({}, { Q5: "25,5", Q6: "10/4", Q7: "", Q8: "ten" }))).toEqual({ Q5: 25.5, Q6: 2.5 }));

  test("the program sets them in front of the cycle, and the cycle names them", () => {
    const text = lines(job({ Q493: "Q5", Q494: "-Q6" }, { Q5: "50", Q6: "55.5" }));
    const at = (part: string) => text.findIndex((line) => line.includes(part));
    expect(text[at("Q5 = ")]).toMatch(/^\d+ Q5 = 50$/);
    expect(text[at("Q6 = ")]).toMatch(/^\d+ Q6 = 55\.5$/);
    expect(at("Q493=+Q5")).toBeGreaterThan(at("Q6 = "));
    expect(text[at("Q494=")]).toContain("Q494=-Q6");
    expect(at("Q6 = ")).toBeLessThan(at("CYCL DEF"));
  });

  test("a sum is worked out with the value", () =>
    expect(lines(job({ Q493: "Q5/2+1" }, { Q5: "98" })).find((line) => line.includes("Q493="))).toContain("Q493=+50"));

  test("the path is that of the values", () => {
    const typed = pathOf(job({ Q493: "50", Q494: "-55" }));
    const named = pathOf(job({ Q493: "Q5", Q494: "-Q6" }, { Q5: "50", Q6: "55" }));
    expect(named.operations[0]?.plan.moves).toEqual(typed.operations[0]?.plan.moves);
    expect(named.issues).toEqual([]);
  });

  test("a missing value is no number 0: nothing is set, and the run says which one is missing", () => {
    const open = job({ Q493: "Q5" });
    expect(lines(open).some((line) => line.includes("Q5 ="))).toBe(false);
    expect(pathOf(open).issues.map((f) => f.issue.code)).toContain("parameterUnset");
  });

  test("a value that no prompt uses is not printed", () =>
    expect(lines(job({}, { Q5: "25" }))).toEqual(lines(job({}))));
});

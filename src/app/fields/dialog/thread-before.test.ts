import { expect, test } from "vitest";
import { catalogue } from "../../../cycles/index.ts";
import { valuesOfThread } from "../../../cycles/thread-values.ts";
import { ncLabels } from "../../../i18n/nc-labels.ts";
import { readThread } from "../../../kernel/thread/threads.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { printJob } from "../../../program/job/print-job.ts";
import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import { engine } from "../../calculation/engine.ts";
import { findingsOf } from "../../findings/findings.ts";

/** The diameter that the finding asks for, if a thread is cut on a shaft that is thinner by some mm. */
function toldFor(name: string, thinner: number): number | null {
  const thread = readThread(name);
  const cycle = catalogue.find((c) => c.thread && (thread?.taper ? c.thread.line : c.thread.diameters.length === 1));
  if (!thread || !cycle?.thread) throw new Error(`no cycle for ${name}`);
  const job = exampleJob(cycle);
  const draft = job.drafts[cycle.number] ?? {};
  const typed = Object.fromEntries(Object.entries(draft).map(([q, text]) => [q, Number(text)]));
  const fill = valuesOfThread(thread, cycle.thread, typed, { aim: "middle", nose: null });
  if (typeof fill === "string") throw new Error(fill);
  const texts = Object.fromEntries(Object.entries(fill.values).map(([q, value]) => [q, String(value)]));
  const changed = {
    ...job,
    drafts: { ...job.drafts, [cycle.number]: { ...draft, ...texts } },
    blank: { ...job.blank, outside: String(fill.before - thinner) },
    start: { ...job.start, x: String(fill.before + 20) },
  };
  const outcome = engine.update({
    version: 1,
    text: printJob(changed, ncLabels("en")),
    table: { tools: shippedTools, mills: [], refused: new Map() },
    rapid: 10_000,
    control: "TNC 640",
  });
  const found = findingsOf(null, outcome).find(({ issue }) => issue.code === "crestMissing");
  return found && "diameter" in found.issue.data ? Number(found.issue.data.diameter) - fill.before : null;
}

test.each(["M20×1.5", "G1/2", "W1/2", "Tr20x4", "S22x5", "Rd20", "1/4-20 UNC"])(
  "a shaft that is too thin for %s is told with the diameter before the thread",
  (name) => {
    expect(toldFor(name, 1)).toBeCloseTo(0, 2);
    expect(toldFor(name, 0)).toBeNull();
  },
);

test("a shaft that is too thin for the end of a taper is told", () => {
  expect(toldFor("1/2 NPT", 2)).not.toBeNull();
});

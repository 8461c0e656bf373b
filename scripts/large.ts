import { parse } from "../src/nc/parse.ts";
import { run } from "../src/program/run/run.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import { report } from "../src/report/report.ts";
import { verdictOf } from "../src/report/verdict.ts";
import { simulate } from "../src/sim/simulate.ts";
import { largePrograms } from "./large-programs.ts";

/** Processor time, ms, so that other load on the machine does not count. */
const cpu = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};

/**
 * `node scripts/run.mjs large NAME …`: processor times in ms and the peak memory in MB of each named program, one at a
 * time.
 */
export function main(names: readonly string[]): number {
  for (const name of names.length > 0 ? names : Object.keys(largePrograms)) {
    const text = largePrograms[name as keyof typeof largePrograms]();
    const at = [cpu()];
    const mark = () => at.push(cpu());
    const program = parse(text);
    mark();
    const made = run(program, { tools: shippedTools, rapid: 10_000 });
    mark();
    const simulation = simulate(made);
    mark();
    const mid = process.resourceUsage().maxRSS / 1024;
    const told = report({ file: name, run: made, simulation, milliseconds: { parse: 0, plan: 0, simulate: 0 } }, "en");
    const json = JSON.stringify(told).length;
    mark();
    const [parsed, ran, simulated, reported] = at.slice(1).map((t, i) => Math.round(t - (at[i] ?? 0)));
    console.log(
      JSON.stringify({
        name,
        parsed,
        ran,
        simulated,
        reported,
        mb: Math.round(mid),
        mbReport: Math.round(process.resourceUsage().maxRSS / 1024),
        text: text.length,
        blocks: program.blocks.length,
        steps: made.steps.length,
        plane: made.plane.length,
        operations: made.operations.length,
        issues: told.issues.length,
        findings: simulation.findings.length,
        passes: made.operations.reduce((n, o) => n + o.plan.passes, 0),
        verdict: verdictOf(made, simulation).verdict,
        checkpoints: simulation.checkpoints.length,
        json,
      }),
    );
  }
  return 0;
}

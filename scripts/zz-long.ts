import { parse } from "../src/nc/parse.ts";
import { grownProgram } from "./large-programs.ts";
import { betterWays } from "../src/report/better-ways/better-ways.ts";
import { variantsOf } from "../src/app/calculation/variants.ts";
import { conditionsOf } from "../tests/better-ways/way-laws.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
export async function main(args: readonly string[]): Promise<number> {
  const text = grownProgram(Number(args[0] ?? 211), Number(args[1] ?? 10000));
  const peer = { name: "long", text, tools: shippedTools, material: "c45" };
  const cpu0 = process.cpuUsage();
  const ms = () => (process.cpuUsage(cpu0).user / 1000).toFixed(0);
  const { attempt, trial } = variantsOf({ version: 0, text, table: { tools: shippedTools, refused: new Map() }, rapid: 10_000, control: "TNC 640" });
  console.log(ms(), "base");
  let [sims] = [0];
  const search = betterWays(parse(text), attempt, (t) => { const a = trial(t); return { run: a.run, simulated: () => { sims += 1; return a.simulated(); } }; }, conditionsOf(peer));
  for (;;) { const { done, value } = search.next(); if (done) { console.log(ms(), "sims", sims, "ways", value.length, value.slice(0,3).map(w => [w.subject, w.gains, w.before.seconds - w.after.seconds])); break; } if (value.tried < 4 || value.tried % 20 === 0) console.log(ms(), value); }
  return 0;
}

import fc from "fast-check";
import { arbitraryParts } from "../tests/planning/arbitrary-part.ts";
import { requestOf, planOf, searching, endOf, fixedSequence } from "../tests/planning/plan-laws.ts";
import { nodesOf } from "../src/planning/plan-node.ts";
export async function main(args: readonly string[]): Promise<number> {
  const [seed, n, ...which] = args.map(Number);
  const all = fc.sample(arbitraryParts, { numRuns: n ?? 12, seed: seed ?? 101 });
  for (const i of which) {
    const { part, features } = all[i]!;
    console.log(i, features.join(), JSON.stringify(part.blank), part.partsOff, part.unmachinedBehind);
    if (process.env.DUMP) console.log(JSON.stringify(part));
    const request = requestOf(part)!;
    const plan = planOf(request);
    const s = searching(request);
    for (const [name, node] of [["plan", endOf(plan, s)], ["fixed", fixedSequence(request, s)]] as const) {
      console.log(name, node.cost, node.seconds, node.left, [...node.threads]);
      let before = 0;
      for (const x of nodesOf(node)) { console.log("   ", x.tried!.action.key, "cost", (x.cost - before).toFixed(1), "s", x.tried!.seconds.toFixed(1), "cut", x.tried!.cut.toFixed(3)); before = x.cost; }
    }
    console.log(JSON.stringify(plan.judged.reasons), plan.residue.map(r => [r.region?.area, r.site, r.why]));
    if (process.env.TEXT) console.log(plan.text);
  }
  return 0;
}

import { variantsOf } from "../../src/app/calculation/variants.ts";
import { parse } from "../../src/nc/parse.ts";
import type { Block, Program } from "../../src/nc/program.ts";
import { operationsOf } from "../../src/program/edits/operations.ts";
import { run } from "../../src/program/run/run.ts";
import { usualTable } from "../../src/program/tools/cutting-table.ts";
import { betterWays, type BetterWay } from "../../src/report/better-ways/better-ways.ts";
import { measureOf } from "../../src/report/better-ways/measure.ts";
import type { Attempt, Conditions } from "../../src/report/better-ways/situation.ts";
import { verdictOf } from "../../src/report/verdict.ts";
import { areaOf } from "../../src/kernel/area/area.ts";
import { difference } from "../../src/kernel/area/clip.ts";
import { withoutSlivers } from "../../src/kernel/area/real-area.ts";
import { simulate } from "../../src/sim/simulate.ts";
import { traceStock } from "../../src/sim/tracing.ts";
import type { PeerProgram } from "./peer-programs.ts";

/** The circumstances of a search in a program; c45 where its task states no material. */
export function conditionsOf({ tools, material }: PeerProgram): Conditions {
  const found = usualTable.materials.find(({ id }) => id === (material ?? "c45"));
  if (!found) throw new Error(`no material ${material}`);
  return { tools, material: found, isStated: material !== null, power: usualTable.power, ncLanguage: "en" };
}

/** A program from scratch. */
export const attemptWith =
  (tools: Conditions["tools"]) =>
  (text: string): Attempt => {
    const made = run(parse(text), { tools, rapid: 10_000, tracing: traceStock });
    return { run: made, simulation: simulate(made) };
  };

/** All ways of a program, and the number of changes that were tried. */
export function waysOf(peer: PeerProgram): { readonly ways: readonly BetterWay[]; readonly tried: number } {
  const request = {
    version: 0,
    text: peer.text,
    table: { tools: peer.tools, refused: new Map() },
    rapid: 10_000,
    control: "TNC 640",
  } as const;
  const { attempt, trial } = variantsOf(request);
  const search = betterWays(parse(peer.text), attempt, trial, conditionsOf(peer));
  for (let tried = 0; ; tried += 1) {
    const { done, value } = search.next();
    if (done) return { ways: value, tried };
  }
}

const bare = ({ raw }: Block): string => raw.replace(/^[ \t]*\/?[ \t]*\d+[ \t]/, "").trimEnd();

/** Blocks of a way that lie outside its operations and their tool sections, and are not as they were. */
function changedBeside(before: Program, after: Program, units: readonly number[]): readonly string[] {
  const all = operationsOf(before);
  const now = after.blocks.map(bare);
  const kept = [
    before.blocks.slice(0, all.from),
    ...all.units.flatMap((unit, i) => (units.includes(i) ? [] : [before.blocks.slice(unit.from, unit.to)])),
    before.blocks.slice(Math.max(all.from, ...all.sections.map(({ to }) => to))),
  ].map((blocks) => blocks.map(bare));
  let at = 0;
  return kept.flatMap((blocks) => {
    const found = now.findIndex((_, i) => i >= at && blocks.every((text, k) => now[i + k] === text));
    if (found < 0) return [`changed: ${blocks.find((text) => !now.includes(text)) ?? blocks[0] ?? ""}`];
    at = found + blocks.length;
    return [];
  });
}

/** Material that a part has and another lacks, mm². */
const more = (a: Attempt, b: Attempt): number =>
  areaOf(withoutSlivers(difference(a.simulation.final, b.simulation.final)));

/** What a taken way breaks of what it promises; empty where it keeps its word. */
export function brokenByWay(peer: PeerProgram, way: BetterWay): readonly string[] {
  const { text, tools } = peer;
  const attempt = attemptWith(tools);
  const [was, is] = [attempt(text), attempt(way.text)];
  const [verdict, before] = [verdictOf(is.run, is.simulation).verdict, verdictOf(was.run, was.simulation).verdict];
  const left = more(is, was);
  return [
    ...(JSON.stringify(measureOf(is, conditionsOf(peer).material)) === JSON.stringify(way.after)
      ? []
      : ["another measure"]),
    ...(verdict === before || way.gains.includes("verdict") ? [] : [`verdict ${before}, then ${verdict}`]),
    ...(left > 0.05 ? [`leaves ${left.toFixed(3)} mm² more`] : []),
    ...(is.simulation.proof.gouge > was.simulation.proof.gouge ? ["gouge"] : []),
    ...(is.simulation.findings.length > was.simulation.findings.length ? ["a finding more"] : []),
    ...changedBeside(parse(text), parse(way.text), way.subject.units),
  ];
}

/** Ways taken one after the other, the best first, until none is left or there have been too many. */
export function* takenInTurn(peer: PeerProgram, most: number): Generator<BetterWay> {
  let { text } = peer;
  for (let taken = 0; taken < most; taken += 1) {
    const [best] = waysOf({ ...peer, text }).ways;
    if (!best) return;
    yield best;
    ({ text } = best);
  }
}

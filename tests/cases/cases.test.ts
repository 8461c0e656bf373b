import { describe, expect, test } from "vitest";
import { verified } from "../../scripts/verify.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import type { Report } from "../../src/report/report.ts";
import type { ReportMove } from "../../src/report/report-moves.ts";
import { over, readTools } from "../../src/program/tools/read-tools.ts";
import { SEVERITY, type Expected } from "./expectation.ts";
import { expected as others } from "./expected.ts";
import { expectedCauses } from "./expected-causes.ts";
import { running } from "./expected-running.ts";

const expected = { ...others, ...running, ...expectedCauses };
/** The shipped tools with those of a row. */
function tableOf({ tools }: Expected) {
  const read = readTools(JSON.stringify({ tools: tools ?? [] }));
  if ("problem" in read) throw new Error(read.problem);
  return over({ tools: shippedTools }, read);
}
const programs = import.meta.glob<string>("./*.h", { query: "?raw", import: "default", eager: true });
const nameOf = (path: string) => path.replace(/^\.\/|\.h$/g, "");
/** Longer than the lead-in of a finishing cut, diameter, mm. */
const LEAD = 4.1;
const near = (a: number | undefined, b: number) => Math.abs((a ?? NaN) - b) < 0.005;

/** The differences between a report and its expectation, in words. */
function differences(r: Report, e: Expected): string[] {
  const out: string[] = [];
  const wrong = (when: boolean, what: string) => void (when && out.push(what));
  const { proof, issues } = r;
  const errors = issues.filter((i) => i.severity === "error");
  for (const [code, count] of Object.entries(e.has ?? {})) {
    const found = issues.filter((i) => i.code === code);
    wrong(found.length === 0 || (count !== true && found.length !== count), `${found.length} × ${code}`);
    wrong(
      found.some((i) => i.severity !== SEVERITY[code]),
      `${code} is not ${SEVERITY[code]}`,
    );
  }
  for (const code of e.hasNot ?? [])
    wrong(
      issues.some((i) => i.code === code),
      `reports ${code}`,
    );
  for (const code of e.infos ?? []) {
    const found = issues.filter((i) => i.code === code);
    wrong(
      found.length === 0 || found.some((i) => i.severity !== "info"),
      `${code} as ${found.map((i) => i.severity).join()}`,
    );
  }
  const warnings = issues.filter((i) => i.severity === "warning");
  wrong(
    e.mostWarnings !== undefined && warnings.length > e.mostWarnings,
    `warnings ${warnings.map((i) => i.code).join()}`,
  );
  wrong(e.mostErrors !== undefined && errors.length > e.mostErrors, `errors ${errors.map((i) => i.code).join()}`);
  wrong(
    e.errorAt !== undefined && !errors.some((i) => e.errorAt?.includes(i.at ?? "")),
    `no error at ${e.errorAt?.join()}`,
  );
  wrong(e.gouge !== undefined && e.gouge !== proof.gouge > 0, `gouge ${proof.gouge}`);
  wrong(
    e.rapidInStock !== undefined && e.rapidInStock !== proof.rapidInStock > 0,
    `rapid in stock ${proof.rapidInStock}`,
  );
  wrong(
    e.verdict !== undefined && e.verdict !== (proof as { verdict?: string }).verdict,
    `verdict ${(proof as { verdict?: string }).verdict}`,
  );
  const of = (reason: string) => proof.residual.reduce((sum, p) => (p.reason === reason ? sum + p.area : sum), 0);
  const left = proof.residual.reduce((sum, p) => sum + p.area, 0);
  wrong(e.left !== undefined && left > e.left, `${left} mm² stay`);
  wrong(e.reason !== undefined && of(e.reason) === 0, `nothing stays for ${e.reason}`);
  for (const [reason, most] of Object.entries(e.noReason ?? {}))
    wrong(of(reason) > most, `${of(reason)} mm² stay for ${reason}`);
  const unproved = (proof as { unproved?: readonly { what: string }[] }).unproved ?? [];
  wrong(e.unproved === false && unproved.length > 0, `not proved: ${unproved.map((u) => u.what).join()}`);
  const pips = proof.residual.filter((p) => p.ring.some(([, radius]) => radius < 0.3));
  wrong(e.cleanAtAxis === true && pips.length > 0, `${pips.length} places on the axis stay`);
  const named = (name: string) =>
    issues.flatMap((i) =>
      Object.entries(i.data ?? {}).flatMap(([key, value]) => (key === name ? [Number(value)] : [])),
    );
  const offers = named("nearest"),
    limits = named("max").map((max) => Number(max.toFixed(5)));
  wrong(e.offersNoNegative === true && offers.some((offer) => offer < 0), `offers ${offers.join()}`);
  wrong(e.offers !== undefined && e.offers.join() !== offers.join(), `offers ${offers.join()}`);
  wrong(e.limits !== undefined && e.limits.join() !== limits.join(), `limits ${limits.join()}`);
  wrong(e.holder !== undefined && e.holder !== proof.holder, `holder ${proof.holder}`);
  const nearest = Math.min(...r.operations.flatMap((o) => o.moves.map((m) => m.x)));
  wrong(e.notNearer !== undefined && !(nearest >= e.notNearer - 0.001), `comes to X${nearest}`);
  return [...out, ...ofMotion(r, e)];
}

/** Differences of the moves. */
function ofMotion(r: Report, e: Expected): string[] {
  const out: string[] = [];
  const wrong = (when: boolean, what: string) => void (when && out.push(what));
  const cut = (r.operations[0]?.moves ?? []).map((m, i, all) => ({
    ...m,
    before: all[i - 1] ?? ({ ...r.operations[0]?.start, kind: "rapid" } as ReportMove),
  }));
  const feeds = cut.filter((m) => m.kind !== "rapid");
  if (e.alike) {
    const ran = r.operations.map(({ start, moves }) =>
      moves.map((m) => `${m.kind} ${(m.x ?? 0).toFixed(4)} ${((m.z ?? 0) - start.z).toFixed(4)}`).join(),
    );
    wrong(new Set(ran).size !== 1, `operations of ${r.operations.map((o) => o.moves.length).join()} moves differ`);
    wrong(
      r.operations.some(({ moves }) => moves.at(-1)?.kind !== "rapid"),
      "comes back at feed",
    );
  }
  if (e.path) {
    const ends = r.moves.slice(0, e.path.length);
    wrong(
      ends.length < e.path.length || e.path.some(([x, z], i) => !near(ends[i]?.x, x) || !near(ends[i]?.z, z)),
      `goes to ${JSON.stringify(ends.map((m) => [m.x, m.z]))}`,
    );
  }
  for (const [block, feed] of Object.entries(e.feeds ?? {})) {
    const found = r.moves.filter((m) => m.block === Number(block));
    wrong(!found.some((m) => near(m.feed, feed)), `block ${block} feeds ${found.map((m) => m.feed).join()}`);
  }
  if (e.lastLevel !== undefined) {
    const levels = feeds
      .filter((m) => m.phase === "rough" && near(m.x, m.before.x) && Math.abs((m.z ?? 0) - (m.before.z ?? 0)) > 10)
      .map((m) => m.x);
    wrong(!near(Math.min(...levels), e.lastLevel), `last level at ${Math.min(...levels)}`);
  }
  wrong(
    e.lowestZ !== undefined && !near(Math.min(...cut.map((m) => m.z ?? Infinity)), e.lowestZ),
    `lowest Z ${Math.min(...cut.map((m) => m.z ?? Infinity))}`,
  );
  if (e.finishAlongZ) {
    const { z, beyond } = e.finishAlongZ;
    const finish = feeds.filter((m) => m.phase === "finish");
    const along = finish.filter((m) => near(m.z, z) && near(m.before.z, z) && Math.abs(m.x - m.before.x) > LEAD);
    wrong(along.length > 0, `finishes along Z${z}`);
    wrong(
      beyond !== undefined && finish.some((m) => ((m.z ?? z) - z) * beyond.side > beyond.most),
      `finishes beyond Z${z}`,
    );
  }
  for (const [block, [x, z]] of Object.entries(e.arcInXZ ?? {})) {
    const arc = r.moves.find((m) => m.block === Number(block) && m.kind === "arc");
    wrong(!arc || !near(arc.cx, x) || !near(arc.cz, z), `block ${block}: ${JSON.stringify(arc)}`);
  }
  wrong(
    e.inOrder === true && r.moves.some((m, i) => m.block < (r.moves[i - 1]?.block ?? 0)),
    `blocks ${r.moves.map((m) => m.block).join()}`,
  );
  return out;
}

describe("programs that showed a fault", () => {
  test("each has its row, and each row its program", () => {
    expect(Object.keys(programs).map(nameOf).sort()).toEqual(Object.keys(expected).sort());
  });
  for (const [name, e] of Object.entries(expected))
    test.skipIf(e.pending)(`${name}: ${e.says}`, () => {
      const text = programs[`./${name}.h`] ?? "";
      expect(
        differences(verified(`${name}.h`, text, e.tools ? tableOf(e) : { tools: shippedTools, refused: new Map() }), e),
      ).toEqual([]);
    });
});

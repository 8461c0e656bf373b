import { expect, test } from "vitest";
import { verified } from "../scripts/verify.ts";
import { STOCK_FAULTS } from "../src/sim/simulation.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";

/*
 * Programs with the expected proof in their first line: `code@block`, `-code`, `verdict=…`, `holder=…`,
 * `deepest=depth/allowed` (within 0.02 mm), `residual=reason`, `-residual=reason`, and `tools=…`: tools in this order
 * among those proposed for the largest region.
 */
const programs = Object.entries(
  import.meta.glob<string>("./proof/*.h", { query: "?raw", import: "default", eager: true }),
);

function checkExpectation(report: ReturnType<typeof verified>, word: string): void {
  const { proof } = report;
  const [key = "", value = ""] = word.split("=");
  const reasons = proof.residual.map((r) => r.reason);
  if (key === "verdict") return expect(proof.verdict).toBe(value);
  if (key === "holder") return expect(proof.holder).toBe(value);
  if (key === "residual") return expect(reasons).toContain(value);
  if (key === "-residual") return expect(reasons).not.toContain(value);
  if (key === "deepest") {
    const [depth, allowed] = value.split("/").map(Number);
    expect(Math.abs((proof.deepest?.depth ?? NaN) - (depth ?? NaN))).toBeLessThan(0.02);
    return expect(proof.deepest?.allowed).toBe(allowed);
  }
  if (key === "tools") {
    const largest = [...proof.residual].sort((a, b) => b.area - a.area)[0]?.tools ?? [];
    const named = value.split(",").map(Number);
    return expect(largest.filter((t) => named.includes(t))).toEqual(named);
  }
  const said = report.issues.flatMap((i) => [i.code, `${i.code}@${i.block ?? ""}`]);
  if (key.startsWith("-")) return expect(said).not.toContain(key.slice(1));
  expect(said).toContain(key);
}

test.each(programs)("%s", (path, text) => {
  const words = (/^; expect: (.*)$/m.exec(text)?.[1] ?? "").split(" ");
  const report = verified(path, text, { tools: shippedTools, refused: new Map() });
  expect(words.length).toBeGreaterThan(0);
  for (const word of words) checkExpectation(report, word);
});

test("the verdict that the report gives is that of its reasons", () => {
  for (const [path, text] of programs) {
    const { proof } = verified(path, text, { tools: shippedTools, refused: new Map() });
    const kinds = new Set(proof.reasons.map((r) => r.kind));
    const isFault = (["error", ...STOCK_FAULTS] as const).some((k) => kinds.has(k));
    const isGap = (["unproved", "milling", "nothingCut", "noOperation"] as const).some((k) => kinds.has(k));
    expect(proof.verdict).toBe(isFault ? "faults" : isGap ? "incomplete" : "proved");
    expect(kinds.has("holderUnknown") || kinds.has("curvatureUnknown")).toBe(proof.holder === "unknown");
  }
});

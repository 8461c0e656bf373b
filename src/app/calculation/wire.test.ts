import { expect, test } from "vitest";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { packPlane, unpackPlane } from "./wire.ts";

const programs = import.meta.glob<string>("../../../tests/programs/**/*.h", {
  query: "?raw",
  import: "default",
  eager: true,
});

test("motions of milling programs arrive unchanged", () => {
  const milled = Object.values(programs)
    .map(
      (text) =>
        run(parse(text), { tools: shippedTools, mills: [], refused: new Map(), rapid: 10_000, control: "TNC7" }).plane,
    )
    .filter((plane) => plane.length > 0);
  const steps = milled.flat();
  expect(new Set(steps.map((s) => s.kind))).toEqual(new Set(["rapid", "feed", "arc"]));
  expect(steps.some((s) => s.to.z === null)).toBe(true);
  for (const plane of milled) expect(unpackPlane(packPlane(plane))).toEqual(plane);
});

import { expect, test } from "vitest";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import type { Simulation } from "../../sim/simulation.ts";
import { engine, makersAgain } from "./engine.ts";
import { openWork } from "./open-work.ts";
import type { Outcome } from "./outcome.ts";
import { proofDelta, simulationOf } from "./proof-delta.ts";

const programs = import.meta.glob<string>("../../examples/*.h", { query: "?raw", import: "default", eager: true });
const flange = programs["../../examples/flange.h"] ?? "";
const requestOf = (text: string, version: number) => ({
  version,
  text,
  table: { tools: shippedTools, mills: [], refused: new Map() },
  rapid: 8700,
  control: "TNC7" as const,
});

/** Changes values of the last, the first and the middle cycle, and undoes the first change. */
const texts = [
  flange,
  flange.replace(/Q460=\+\d+(?![\s\S]*Q460=)/, "$&.37"),
  flange.replace(/Q463=\+[\d.]+/, "Q463=+1.37"),
  flange.replace("END PGM", "; nothing\n$&"),
  flange,
];

test("the transferred part and what the page has make the whole simulation again", () => {
  const by = makersAgain();
  let last: Outcome | null = null;
  const shown: { simulation: Simulation }[] = [];
  const kept = texts.map((text, i) => {
    const made: Outcome = engine.update(requestOf(text, i), undefined, by);
    const sent = structuredClone(proofDelta(made.simulation, last?.simulation.checkpoints ?? []));
    shown.push({ simulation: simulationOf(sent, structuredClone(made.run), shown.at(-1) ?? null) });
    last = made;
    return sent.kept;
  });
  expect(shown.map(({ simulation }) => simulation)).toEqual(
    texts.map((text, i) => engine.update(requestOf(text, i)).simulation),
  );
  const marks = shown.map(({ simulation }) => simulation.checkpoints.length);
  expect(kept[0]).toBe(0);
  expect(kept[1]).toBeGreaterThan((marks[1] ?? 0) / 2);
  expect(kept[2]).toBeLessThan(marks[2] ?? 0);
});

test("nothing is left out that the page does not have", () => {
  const { simulation } = engine.update(requestOf(flange, 3));
  const sent = proofDelta(simulation, []);
  expect(sent.kept).toBe(0);
  expect(simulationOf(sent, simulation, null)).toEqual(simulation);
});

test("checkpoints are left out only if the page has that very answer", () => {
  const work = openWork();
  const kept = [null, 1, 7, 3].map((has, i) => work.proved(requestOf(flange, i + 1), has).kept > 0);
  expect(kept).toEqual([false, true, false, true]);
});

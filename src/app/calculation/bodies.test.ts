import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import type { ShownBodies } from "../../view/solid/shown-bodies.ts";
import { buffersOf, turnedBodies, type BodiesGiven, type BodiesWanted } from "./bodies.ts";
import { engine } from "./engine.ts";

const outcome = engine.update({
  version: 1,
  text: readFileSync("tests/programs/cycle-831.h", "utf8"),
  name: "V",
  files: [],
  table: { tools: shippedTools, mills: [], refused: new Map() },
  rapid: 8000,
  control: "TNC 640",
});
const first = outcome.run.steps.findIndex(({ move }) => move.kind === "thread");
const at = (step: number, fraction: number, more: Partial<BodiesWanted> = {}): BodiesWanted => ({
  position: { step, fraction },
  size: 60,
  look: "a",
  hasLast: true,
  turning: { chords: 32, quarterCut: true, hand: 1, within: 0.02, most: 20_000 },
  ...more,
});
const made = (given: BodiesGiven): ShownBodies => {
  if (given === "same") throw new Error("nothing was made");
  return given;
};

test("bodies are made again only if stock or look have changed, or if the page has none", () => {
  made(turnedBodies(outcome, at(0, 0, { hasLast: false })));
  expect(turnedBodies(outcome, at(0, 0))).toBe("same");
  // Nothing is cut before the first pass.
  expect(turnedBodies(outcome, at(0, 0.7))).toBe("same");
  expect(turnedBodies(outcome, at(0, 0.7, { look: "b" }))).not.toBe("same");
  expect(turnedBodies(outcome, at(0, 0.7, { look: "b", hasLast: false }))).not.toBe("same");
  expect(turnedBodies(outcome, at(first + 9, 0.5, { look: "b" }))).not.toBe("same");
});

test("each buffer is transferred once, and never one that is shared", () => {
  const cut = made(turnedBodies(outcome, at(outcome.run.steps.length, 0)));
  expect(cut.notes.textures).toContain("thread");
  expect(cut.notes.hasRings).toBe(false);
  const [buffers, others] = [buffersOf(cut), buffersOf(made(turnedBodies(outcome, at(first + 9, 0.5))))];
  expect(buffers.length).toBeGreaterThan(3);
  expect(new Set([...buffers, ...others]).size).toBe(buffers.length + others.length);
  expect(buffers.every(({ byteLength }) => byteLength > 0)).toBe(true);
});

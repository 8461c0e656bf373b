import fc from "fast-check";
import { expect, test } from "vitest";
import { shippedTools } from "../../program/shipped-tools.ts";
import { engine } from "./engine.ts";
import { planned, planner } from "./plan.ts";

const programs = import.meta.glob<string>(["../../../tests/programs/**/*.h", "../../examples/*.h"], {
  query: "?raw",
  import: "default",
  eager: true,
});

/** A name of the list by its end. */
const program = (name: string): string => Object.entries(programs).find(([path]) => path.endsWith(name))?.[1] ?? "";

const requestOf = (text: string) => ({
  version: 3,
  text,
  table: { tools: shippedTools, mills: [], refused: new Map() },
  rapid: 8700,
  control: "TNC7" as const,
});

test.each(
  Object.keys(programs).filter((path, i) => i % 5 === 2 || path.includes("examples")).map(
    (path) => [path.replace(/.*(programs|examples)\//, "")]
  ),
)("page and worker make the same run of %s", (name) => {
  const request = requestOf(program(name));
  const { simulation, ...made } = structuredClone(engine.update(request));
  expect(planned(request)).toEqual({ ...made, simulation: null });
  expect(simulation.steps).toEqual(made.run.steps);
  expect(simulation.blank).toEqual(made.run.blank);
});

/** A number of a program becomes another one. */
function changed(text: string, which: number, by: number): string {
  const places = [...text.matchAll(/(?<=(?:Q\d+=|[XZD])[+-]?)\d+(?:\.\d+)?/g)];
  const place = places[which % Math.max(1, places.length)];
  if (!place) return text;
  return `${text.slice(0, place.index)}${Math.abs(Number(place[0]) + by).toFixed(3)}${text.slice(place.index + place[0].length)}`;
}

test.each(["flange.h", "shaft.h", "turn-blank.h"])("planned bit by bit a changed %s is what it is when it is planned anew", (name) => {
  fc.assert(
    fc.property(fc.array(fc.tuple(fc.nat(997), fc.integer({ min: -3000, max: 3000 })), { minLength: 2, maxLength: 4 }), (changes) => {
      const plan = planner();
      let text = program(name);
      plan(requestOf(text));
      for (const [which, by] of changes) {
        text = changed(text, which, by / 917);
        expect(plan(requestOf(text))).toEqual(planned(requestOf(text)));
      }
    }),
    { numRuns: 8 },
  );
}, 60_000);

test("what a change leaves as it is is not planned again", () => {
  const plan = planner();
  const text = program("turn-blank.h");
  const before = plan(requestOf(text)).run.operations;
  const last = text.lastIndexOf("Q483=");
  const after = plan(requestOf(`${text.slice(0, last)}Q483=+0.31${text.slice(last).replace(/^Q483=\S+/, "")}`)).run.operations;
  expect(after.map(({ plan: { moves } }, i) => moves === before[i]?.plan.moves)).toEqual(before.map((_, i) => i < before.length - 1));
});

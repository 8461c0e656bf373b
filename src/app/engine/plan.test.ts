import { expect, test } from "vitest";
import { shippedTools } from "../../program/shipped-tools.ts";
import { engine } from "./engine.ts";
import { planned } from "./plan.ts";

const programs = import.meta.glob<string>(["../../../tests/programs/**/*.h", "../../examples/*.h"], {
  query: "?raw",
  import: "default",
  eager: true,
});

/** A name of the list by its end. */
const program = (name: string): string => Object.entries(programs).find(([path]) => path.endsWith(name))?.[1] ?? "";

test.each(
  Object.keys(programs).filter((path, i) => i % 5 === 2 || path.includes("examples")).map(
    (path) => [path.replace(/.*(programs|examples)\//, "")]
  ),
)("page and worker make the same run of %s", (name) => {
  const request = {
    version: 3,
    text: program(name),
    table: { tools: shippedTools, mills: [], refused: new Map() },
    rapid: 8700,
    control: "TNC7" as const,
  };
  const { simulation, ...made } = structuredClone(engine.update(request));
  expect(planned(request)).toEqual({ ...made, simulation: null });
  expect(simulation.steps).toEqual(made.run.steps);
  expect(simulation.blank).toEqual(made.run.blank);
});

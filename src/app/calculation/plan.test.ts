import fc from "fast-check";
import { expect, test } from "vitest";
import { EXAMPLE_MACHINES } from "../../program/machine/example-machines.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { engine } from "./engine.ts";
import { planned, planner } from "./plan.ts";

const programs = import.meta.glob<string>(["../../../tests/programs/**/*.h", "../../examples/*.h"], {
  query: "?raw",
  import: "default",
  eager: true,
});

/** A program of the list by the end of its path. */
const program = (name: string): string => Object.entries(programs).find(([path]) => path.endsWith(name))?.[1] ?? "";

const requestOf = (text: string) => ({
  version: 3,
  text,
  table: { tools: shippedTools, mills: [], refused: new Map() },
  rapid: 8700,
  machine: EXAMPLE_MACHINES.large,
  control: "TNC7" as const,
});

test.each(
  Object.keys(programs)
    .filter((path, i) => i % 5 === 2 || path.includes("examples"))
    .map((path) => [path.replace(/.*(programs|examples)\//, "")]),
)("page and worker make the same run of %s", (name) => {
  const request = requestOf(program(name));
  const { simulation, ...made } = structuredClone(engine.update(request));
  expect(planned(request)).toEqual({ ...made, simulation: null });
  expect(simulation.steps).toEqual(made.run.steps);
  expect(simulation.blank).toEqual(made.run.blank);
});

/** Changes one number of a program. */
function changed(text: string, which: number, by: number): string {
  const places = [...text.matchAll(/(?<=(?:Q\d+=|[XZD])[+-]?)\d+(?:\.\d+)?/g)];
  const place = places[which % Math.max(1, places.length)];
  if (!place) return text;
  return `${text.slice(0, place.index)}${Math.abs(Number(place[0]) + by).toFixed(3)}${text.slice(place.index + place[0].length)}`;
}

/** Removes a line of a program, or inserts lines before it. */
function otherLines(text: string, which: number, ...added: readonly string[]): string {
  const lines = text.split("\n");
  lines.splice(2 + (which % Math.max(1, lines.length - 4)), added.length === 0 ? 1 : 0, ...added);
  return lines.join("\n");
}

/** The text after one more change; the last of `before` is the present one. */
function edited(before: readonly string[], [kind, which, by]: readonly [string, number, number]): string {
  const text = before.at(-1) ?? "";
  if (kind === "undo") return before[Math.max(0, before.length - 2 - (which % 3))] ?? text;
  if (kind === "drop") return otherLines(text, which);
  if (kind === "note") return otherLines(text, which, `; ${by}`);
  if (kind === "move") return otherLines(text, which, `L Z${by < 0 ? "-" : "+"}${Math.abs(by / 917).toFixed(3)} F0.21`);
  if (kind === "shift") return otherLines(text, which, "TRANS DATUM AXIS Z-0");
  return changed(text, which, by / 917);
}

const edits = fc.tuple(
  fc.constantFrom("number", "number", "number", "undo", "drop", "note", "move", "shift"),
  fc.nat(997),
  fc.integer({ min: -3000, max: 3000 }),
);

test.each(["flange.h", "shaft.h", "turn-blank.h", "turn-traced.h", "turn-datum.h", "shoulder-inch.h"])(
  "planned bit by bit a changed %s is what it is when it is planned anew",
  (name) => {
    fc.assert(
      fc.property(fc.array(edits, { minLength: 2, maxLength: 6 }), (changes) => {
        const plan = planner();
        const texts = [program(name)];
        plan(requestOf(program(name)));
        for (const change of changes) {
          texts.push(edited(texts, change));
          // Each request of the page arrives at the worker as a copy.
          const request = structuredClone(requestOf(texts.at(-1) ?? ""));
          expect(plan(request)).toEqual(planned(request));
        }
      }),
      { numRuns: 8 },
    );
  },
  60_000,
);

/** All example programs and those of the tests, right and wrong ones: labels, jumps, calls, free contours, milling. */
const all = Object.values(programs);

/** Types another digit in any block: numbers, labels, words of any kind. */
function typed(text: string, which: number, digit: number): string {
  const places = [...text.matchAll(/(?<=\D)\d+/g)];
  const place = places[which % Math.max(1, places.length)];
  if (!place) return text;
  const end = place.index + place[0].length;
  return digit < 3 ? text.slice(0, end - 1) + text.slice(end) : `${text.slice(0, end)}${digit}${text.slice(end)}`;
}

test("typed digit by digit, any program gets the same plan as from scratch", () => {
  const digits = fc.array(fc.tuple(fc.nat(9973), fc.nat(9), fc.boolean(), fc.nat(3)), { minLength: 2, maxLength: 5 });
  fc.assert(
    fc.property(fc.constantFrom(...all), digits, (text, changes) => {
      const plan = planner();
      const texts = [text];
      plan(requestOf(text));
      for (const [which, digit, isUndone, bits] of changes) {
        texts.push(isUndone ? (texts.at(-2) ?? text) : typed(texts.at(-1) ?? text, which, digit));
        const request = requestOf(texts.at(-1) ?? "");
        // While idle a part of any state may have been planned before.
        for (let bit = 0; bit < bits; bit += 1) plan.part(requestOf(texts.at(bit % texts.length) ?? ""), () => false);
        expect(plan(request)).toEqual(planned(request));
      }
    }),
    { numRuns: 60 },
  );
}, 60_000);

test("planned bit by bit, any program gets the same plan as in one piece, and a long one takes many bits", () => {
  const bitsOf = (text: string) => {
    const plan = planner(),
      request = requestOf(text);
    for (let bits = 1; ; bits += 1) {
      const made = plan.part(request, () => false);
      if (!made) continue;
      expect(made).toEqual(planned(request));
      expect(plan(request)).toEqual(made);
      return bits;
    }
  };
  const bits = all.map(bitsOf);
  expect(bits.filter((count) => count > 3).length).toBeGreaterThan(10);
  expect(bitsOf(program("shaft.h"))).toBeGreaterThan(8);
  // A change in between is planned correctly.
  const plan = planner(),
    text = program("shaft.h");
  for (let bit = 0; bit < 5; bit += 1) expect(plan.part(requestOf(text), () => false)).toBeNull();
  const other = requestOf(changed(text, 97, 0.313));
  expect(plan(other)).toEqual(planned(other));
}, 60_000);

test("unchanged operations are not planned again", () => {
  const plan = planner();
  const text = program("turn-blank.h");
  const before = plan(requestOf(text)).run.operations;
  const last = text.lastIndexOf("Q483=");
  const after = plan(requestOf(`${text.slice(0, last)}Q483=+0.31${text.slice(last).replace(/^Q483=\S+/, "")}`)).run
    .operations;
  expect(after.map(({ plan: { moves } }, i) => moves === before[i]?.plan.moves)).toEqual(
    before.map((_, i) => i < before.length - 1),
  );
});

test("an unchanged operation keeps its identical steps, also after an undone change", () => {
  const plan = planner();
  const text = program("flange.h");
  const other = text.replace(/Q460=\+\d+(?![\s\S]*Q460=)/, "$&.37");
  const [before, between, again] = [text, other, text].map((each) => plan(structuredClone(requestOf(each))).run);
  const keptBy = (run: typeof before) =>
    before?.operations.map(({ firstStep, lastStep }) =>
      before.steps.slice(firstStep, lastStep + 1).every((s, i) => s === run?.steps[firstStep + i]),
    );
  expect(keptBy(between)).toEqual(before?.operations.map((_, i, all) => i < all.length - 1));
  expect(keptBy(again)).toEqual(before?.operations.map(() => true));
  expect(before?.operations.length).toBeGreaterThan(3);
});

/** The program with a different oversize in one of its cycles. */
const otherOversize = (text: string, which: number, digits: string): string => {
  let count = -1;
  return text.replace(/Q484=\+[\d.]+/g, (given) => ((count += 1) === which ? `Q484=+0.${digits}` : given));
};

test.each([1, 4, 7])("operations before a change of operation %i are not run again", (which) => {
  const plan = planner();
  const text = program("flange.h");
  const before = plan(requestOf(text)).run.operations;
  const after = plan(requestOf(otherOversize(text, which, "13"))).run.operations;
  expect(after.map((operation, i) => operation === before[i])).toEqual(before.map((_, i) => i < which));
});

test("a finding of a contour at the end moves to its new line when a block before it loses one", () => {
  const plan = planner();
  const text = program("flange.h").replace(/^74 L X\+20(\r?\n)/m, "74 L X+20$1CHF 1.3$1");
  const before = plan(requestOf(text));
  const shorter = text.replace(/\S*Q509=(?![\s\S]*Q509=).*\r?\n/, "");
  const after = plan(requestOf(shorter));
  expect(after).toEqual(planned(requestOf(shorter)));
  const lineOf = ({ run }: typeof before) =>
    run.issues.find(({ issue }) => issue.code === "cornerElementAlone")?.line ?? 0;
  expect(lineOf(after)).toBe(lineOf(before) - 1);
});

test("steps that were not run again for a long time are still cached", () => {
  const plan = planner();
  const text = program("flange.h");
  const { steps, operations } = plan(requestOf(text)).run;
  for (let i = 0; i < 40; i += 1) plan(requestOf(otherOversize(text, 5, `1${i}`)));
  const again = plan(requestOf(otherOversize(text, 0, "17"))).run;
  const known = (at: number) =>
    again.steps.slice(again.operations[at]?.firstStep, (again.operations[at]?.lastStep ?? 0) + 1);
  expect(again.operations[0]).not.toEqual(operations[0]);
  for (const at of [1, 2])
    expect(known(at).every((step, i) => step === steps[(operations[at]?.firstStep ?? 0) + i])).toBe(true);
});

test("a changed tool is another tool, and a copy of a tool is the same", () => {
  const plan = planner();
  const request = requestOf(program("flange.h"));
  const first = plan(structuredClone(request)).run.operations[0];
  expect(plan(structuredClone(request)).run.operations[0]?.tool).toBe(first?.tool);
  const tools = shippedTools.map((tool) => ({ ...tool, RS: (tool.RS + 0.013) as typeof tool.RS }));
  const next = { ...request, table: { ...request.table, tools } };
  const other = plan(next);
  expect(other).toEqual(planned(next));
  expect(other.run.operations[0]?.tool.RS).toBeCloseTo((first?.tool.RS ?? 0) + 0.013, 9);
});

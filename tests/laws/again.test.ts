import fc from "fast-check";
import { expect, test } from "vitest";
import { AnswerCache } from "../../src/kernel/answer-cache.ts";
import { parse } from "../../src/nc/parse.ts";
import { incrementalParser } from "../../src/nc/reread.ts";
import { run } from "../../src/program/run/run.ts";
import { incrementalRunner } from "../../src/program/run/incremental-run.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { simulate, incrementalSimulator } from "../../src/sim/simulate.ts";
import type { Simulation } from "../../src/sim/simulation.ts";
import { traceStock } from "../../src/sim/tracing.ts";
import { movingPrograms } from "./moving-programs.ts";

/*
 * A program that changes repeatedly, read, run and proved incrementally: the result must equal that of the program
 * alone.
 */

const programs = import.meta.glob<string>(["../../src/examples/*.h", "../programs/**/*.h"], {
  query: "?raw",
  import: "default",
  eager: true,
});
const textOf = (name: string): string => Object.entries(programs).find(([path]) => path.endsWith(name))?.[1] ?? "";

interface State {
  readonly text: string;
  readonly nose: number;
}

const shop = (nose: number) => ({
  tools: shippedTools.map((tool, i) =>
    i === 0 && "RS" in tool ? { ...tool, RS: (tool.RS + nose) as typeof tool.RS } : { ...tool },
  ),
  rapid: 10_000,
});

/** Replaces a number in a program; `of`: the pattern before it. */
function otherNumber({ text, ...rest }: State, which: number, by: number, of = "(?:Q\\d+=|[XZLD])[+-]?"): State {
  const places = [...text.matchAll(new RegExp(String.raw`(?<=${of})\d+(?:\.\d+)?`, "g"))];
  const place = places[which % Math.max(1, places.length)];
  if (!place) return { text, ...rest };
  const value = Math.abs(Number(place[0]) + by).toFixed(3);
  return { text: text.slice(0, place.index) + value + text.slice(place.index + place[0].length), ...rest };
}

/** Replaces one digit of a program: of a label, a repetition, a parameter, a tool, a coordinate. */
function otherDigit({ text, ...rest }: State, which: number, by: number): State {
  const places = [...text.matchAll(/(?<=\D)\d/g)];
  const at = places[which % Math.max(1, places.length)]?.index ?? 0;
  const digit = (Number(text[at]) + (by < 0 ? 9 : 1)) % 10;
  return { text: `${text.slice(0, at)}${digit}${text.slice(at + 1)}`, ...rest };
}

/** Replaces a label by another of the program, where it is set or where it is called. */
function otherLabel({ text, ...rest }: State, which: number, by: number): State {
  const places = [...text.matchAll(/(?<=LBL )[1-9]\d*/g)];
  const [place, other] = [places[which % places.length], places[Math.floor(Math.abs(by) * 97) % places.length]];
  if (!place || !other) return { text, ...rest };
  return { ...rest, text: text.slice(0, place.index) + other[0] + text.slice(place.index + place[0].length) };
}

/** Inverts the condition of a jump. */
function otherWay({ text, ...rest }: State, which: number): State {
  const places = [...text.matchAll(/FN 9: IF \S+ EQU|FN 10: IF \S+ NE/g)];
  const place = places[which % Math.max(1, places.length)];
  if (!place) return { text, ...rest };
  const jump = place[0].startsWith("FN 9")
    ? place[0].replace("FN 9", "FN 10").replace("EQU", "NE")
    : place[0].replace("FN 10", "FN 9").replace(/NE$/, "EQU");
  return { ...rest, text: text.slice(0, place.index) + jump + text.slice(place.index + place[0].length) };
}

const lines =
  (change: (all: string[], at: number) => void) =>
  (state: State, which: number): State => {
    const all = state.text.split("\n");
    change(all, 2 + (which % Math.max(1, all.length - 4)));
    return { ...state, text: all.join("\n") };
  };
const noted = lines((all, at) => void all.splice(at, 0, "; a note"));
const moved = lines((all, at) => void all.splice(at, 0, "L Z+3.217 F0.21"));
const dropped = lines((all, at) => void all.splice(at, 1));
const stated = lines((all, at) => void all.splice(at, 0, "BLK FORM CYLINDER Z D77.3 L121 DIST+1"));

const ended = ({ text, ...rest }: State, by: number): State => ({
  ...rest,
  text: text.replace(/(?=\d* ?END PGM)/, `L X+${(Math.abs(by) * 20).toFixed(3)} Z-1.3 F0.2\n`),
});

const kinds = [
  "number",
  "number",
  "number",
  "digit",
  "digit",
  "digit",
  "again",
  "again",
  "again",
  "undo",
  "undo",
  "element",
  "element",
  "label",
  "way",
  "way",
  "note",
  "move",
  "drop",
  "end",
  "tool",
  "blank",
] as const;
const edits = fc.tuple(
  fc.constantFrom(...kinds),
  fc.nat(9973),
  fc.integer({ min: -4000, max: 4000 }).map((n) => n / 913),
);

/** The state after one more change; the last of `before` is the current one. */
function edited(before: readonly State[], [kind, which, by]: readonly [string, number, number]): State {
  const state = before.at(-1) as State;
  if (kind === "undo") return before[Math.max(0, before.length - 2 - (which % 4))] ?? state;
  if (kind === "end") return ended(state, by);
  if (kind === "note") return noted(state, which);
  if (kind === "move") return moved(state, which);
  if (kind === "drop") return dropped(state, which);
  if (kind === "blank") return stated(state, which);
  if (kind === "tool") return { ...state, nose: Math.abs(by) / 9 };
  if (kind === "element") return otherNumber(state, which, by / 4, "FL.* [XZ][+-]?");
  if (kind === "label") return otherLabel(state, which, by);
  if (kind === "way") return otherWay(state, which);
  if (kind === "digit") return otherDigit(state, which, by);
  return otherNumber(state, which, by);
}

const ran = ({ text, nose }: State) => run(parse(text), { ...shop(nose), tracing: traceStock });

/** Runs one state after another incrementally. */
function running(): typeof ran {
  const [memory, read, runs] = [new AnswerCache(), incrementalParser(), incrementalRunner()];
  return ({ text, nose }) => {
    memory.runEnded();
    return runs(read(text), { ...shop(nose), tracing: traceStock, memory }, []);
  };
}

/** Edits a text step by step: each state must run and be proved as it is alone. */
function holdsFor(text: string, changes: readonly (readonly [string, number, number])[]): void {
  const [proved, runs] = [incrementalSimulator(), running()];
  const states: State[] = [{ text, nose: 0 }];
  proved(runs({ text, nose: 0 }));
  let last: (typeof changes)[number] = ["number", 0, 1];
  for (const change of changes) {
    // The last changed place changes again.
    const [kind, , by] = change;
    last = kind === "again" ? [last[0], last[1], by] : change;
    const state = edited(states, last);
    states.push(state);
    const [made, alone] = [runs(state), ran(state)];
    expect(made).toStrictEqual(alone);
    expect(proved(made)).toStrictEqual(simulate(alone));
  }
}

test("a changed program with calls, jumps, shifts and parameters is run and proved as from scratch", () => {
  fc.assert(fc.property(movingPrograms, fc.array(edits, { minLength: 4, maxLength: 8 }), holdsFor), {
    numRuns: Number(process.env["LAW_CASES"] ?? 10) * 4,
  });
});

test.each([
  ["flange.h", 6],
  ["shaft.h", 3],
  ["shoulder-812.h", 12],
  ["turn-blank.h", 8],
] as const)("what is proved again of a changed %s is what is proved of it alone", (name, numRuns) => {
  const text = textOf(name);
  expect(text).not.toBe("");
  fc.assert(
    fc.property(fc.array(edits, { minLength: 2, maxLength: 5 }), (changes) => {
      holdsFor(text, changes);
    }),
    { numRuns },
  );
});

/** The number of marks that two simulations share: identical arrays, not recomputed ones. */
const kept = (a: Simulation, b: Simulation): number =>
  b.checkpoints.filter((mark, i) => mark.stock === a.checkpoints[i]?.stock).length;

test("a changed end reuses the stock before it", () => {
  const text = textOf("shaft.h");
  const proved = incrementalSimulator();
  const before = proved(ran({ text, nose: 0 }));
  const threads = [...text.matchAll(/CYCL DEF 831[\s\S]*?Q460=\+([\d.]+)/g)];
  const last = threads.at(-1);
  expect(last).toBeDefined();
  const at = (last?.index ?? 0) + (last?.[0].length ?? 0);
  const state = { text: `${text.slice(0, at)}.4${text.slice(at)}`, nose: 0 };
  const after = proved(ran(state));
  expect(after).toEqual(simulate(ran(state)));
  const lastOperation = ran(state).operations.at(-1)?.firstStep ?? 0;
  expect(kept(before, after)).toBeGreaterThanOrEqual(
    before.checkpoints.filter(({ step }) => step <= lastOperation).length,
  );
});

test("a proof is reused when a state returns, and when no move changes", () => {
  // Roughing alone leaves its oversize.
  const text = textOf("flange.h").replaceAll(/Q215=\+?0/g, "Q215=+1");
  const [proved, runs] = [incrementalSimulator(), running()];
  const simulationOf = (each: string) => proved(runs({ text: each, nose: 0 }));
  const before = simulationOf(text);
  const noted = simulationOf(text.replace("END PGM", "; a note\n$&"));
  expect(kept(before, noted)).toBe(before.checkpoints.length);
  // The first cycle changes: everything after it is cut again.
  const other = simulationOf(text.replace(/Q463=\+?[\d.]+/, "Q463=+1.37"));
  expect(kept(before, other)).toBeLessThan(before.checkpoints.length / 2);
  const again = simulationOf(text);
  expect(kept(before, again)).toBe(before.checkpoints.length);
  expect(again).toEqual(before);
  expect(again.proof.residual[0]?.ring).toBe(before.proof.residual[0]?.ring);
  expect(before.proof.residual.length).toBeGreaterThan(0);
});

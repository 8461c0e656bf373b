import { expect, test } from "vitest";
import { AnswerCache } from "./answer-cache.ts";

test("a question is answered once, with the same object", () => {
  const answers = new AnswerCache();
  const make = () => ({});
  expect(answers.cached("a", make)).toBe(answers.cached("a", make));
  expect(answers.cached("b", make)).not.toBe(answers.cached("a", make));
});

test("the least recently used answers are dropped, but none that one run has used", () => {
  const answers = new AnswerCache(0);
  let made = 0;
  const runs = (...questions: readonly string[]): number => {
    made = 0;
    for (const question of questions) answers.cached(question, () => (made += 1));
    answers.runEnded();
    return made;
  };
  expect(runs("a", "b", "c")).toBe(3);
  expect(runs("a", "b", "c")).toBe(0);
  // The cache keeps twice as much as the largest run uses.
  expect(runs("d")).toBe(1);
  expect(runs("a", "b", "c")).toBe(0);
  for (const other of ["e", "f", "g", "h", "i", "j"]) runs(other);
  expect(runs("j", "i", "h")).toBe(0);
  expect(runs("a")).toBe(1);
});

test("equal values are the same object with the same name, and −0 is not 0", () => {
  const answers = new AnswerCache();
  const value = { at: [0, 1.5], name: "T1" };
  expect(answers.canonical(value)).toBe(value);
  expect(answers.canonical({ at: [0, 1.5], name: "T1" })).toBe(value);
  expect(answers.nameOf({ at: [0, 1.5], name: "T1" })).toBe(answers.nameOf(value));
  expect(answers.canonical({ at: [-0, 1.5], name: "T1" })).not.toBe(value);
  expect(answers.serialized([0])).not.toBe(answers.serialized([-0]));
});

test("a label belongs to one object", () => {
  const answers = new AnswerCache();
  const [a, b] = [{}, {}];
  expect(answers.labelOf(a)).toBe(answers.labelOf(a));
  expect(answers.labelOf(a)).not.toBe(answers.labelOf(b));
});

test("a long list is replaced by its name in a question", () => {
  const answers = new AnswerCache();
  const long = (last: number) => Array.from({ length: 60 }, (_, i) => (i === 59 ? last : i));
  expect(answers.serialized({ long: long(1) })).toBe(answers.serialized({ long: long(1) }));
  expect(answers.serialized({ long: long(1) })).not.toBe(answers.serialized({ long: long(2) }));
  expect(answers.serialized({ long: long(1) }).length).toBeLessThan(20);
});

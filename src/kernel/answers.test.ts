import { expect, test } from "vitest";
import { Answers } from "./answers.ts";

test("a question is answered once, with the same object", () => {
  const answers = new Answers();
  const make = () => ({});
  expect(answers.once("a", make)).toBe(answers.once("a", make));
  expect(answers.once("b", make)).not.toBe(answers.once("a", make));
});

test("what was asked for longest ago is forgotten when answers take too much memory", () => {
  const answers = new Answers(1000);
  let made = 0;
  const ask = (question: string) =>
    answers.once(
      question,
      () => (made += 1),
      () => 2,
    );
  for (const question of ["a", "b", "c"]) ask(question);
  expect(made).toBe(3);
  ask("a");
  ask("d");
  expect(made).toBe(4);
  ask("a");
  expect(made).toBe(4);
  ask("b");
  expect(made).toBe(5);
});

test("an answer that is larger than the memory is kept until the next one", () => {
  const answers = new Answers(100);
  const make = () => ({});
  const large = answers.once("large", make, () => 1000);
  expect(answers.once("large", make, () => 1000)).toBe(large);
});

test("equal values are the same object with the same name, and −0 is not 0", () => {
  const answers = new Answers();
  const value = { at: [0, 1.5], name: "T1" };
  expect(answers.same(value)).toBe(value);
  expect(answers.same({ at: [0, 1.5], name: "T1" })).toBe(value);
  expect(answers.nameOf({ at: [0, 1.5], name: "T1" })).toBe(answers.nameOf(value));
  expect(answers.same({ at: [-0, 1.5], name: "T1" })).not.toBe(value);
  expect(answers.written([0])).not.toBe(answers.written([-0]));
});

test("a label belongs to one object", () => {
  const answers = new Answers();
  const [a, b] = [{}, {}];
  expect(answers.labelOf(a)).toBe(answers.labelOf(a));
  expect(answers.labelOf(a)).not.toBe(answers.labelOf(b));
});

test("a long list stands by its name in a question", () => {
  const answers = new Answers();
  const long = (last: number) => Array.from({ length: 60 }, (_, i) => (i === 59 ? last : i));
  expect(answers.written({ long: long(1) })).toBe(answers.written({ long: long(1) }));
  expect(answers.written({ long: long(1) })).not.toBe(answers.written({ long: long(2) }));
  expect(answers.written({ long: long(1) }).length).toBeLessThan(20);
});

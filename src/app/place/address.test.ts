import fc from "fast-check";
import { expect, test } from "vitest";
import { isShareLink, parseAddress, printAddress, type Address } from "./address.ts";

const name = fc.string({ minLength: 1, unit: "grapheme" });
const places: fc.Arbitrary<Address> = fc.oneof(
  fc.record({ page: fc.constant("start" as const), which: fc.boolean() }),
  fc.constant({ page: "works" as const }),
  fc.record({ page: fc.constant("sheet" as const), work: name }),
  fc.record({
    page: fc.constant("work" as const),
    work: fc.oneof(name, fc.constantFrom("which", "..", "a/b", "#p=x", "100%")),
    section: fc.constantFrom(
      "prompts" as const,
      "setup" as const,
      "contour" as const,
      "findings" as const,
      "program" as const,
      "text" as const,
      "block" as const,
      "structure" as const,
    ),
    which: fc.boolean(),
  }),
  fc.integer({ min: 0, max: 32_767 }).map((n) => ({ page: "tools" as const, number: n / 10, milling: false })),
  fc.boolean().map((milling) => ({ page: "tools" as const, number: null, milling })),
  fc.constant({ page: "course" as const, lesson: null, at: 1 }),
  fc.record({
    page: fc.constant("course" as const),
    lesson: name,
    at: fc.oneof(fc.integer({ min: 1, max: 99 }), fc.constant("tasks" as const)),
  }),
  fc.record({ page: fc.constant("own" as const), row: fc.option(name) }),
  fc.record({ page: fc.constant("guide" as const), path: fc.tuple(fc.constantFrom("guide", "glossary"), name, name) }),
);

test("every place can be restored from its address", () => {
  fc.assert(
    fc.property(places, (address) => {
      expect(parseAddress(printAddress(address))).toEqual(address);
    }),
  );
});

test.each([
  ["#/", { page: "start", which: false }],
  ["#/which", { page: "start", which: true }],
  ["#/work/7f3a/contour", { page: "work", work: "7f3a", section: "contour", which: false }],
  ["#/work/7f3a", { page: "work", work: "7f3a", section: "prompts", which: false }],
  ["#/work/7f3a/sheet", { page: "sheet", work: "7f3a" }],
  ["#/tools/5", { page: "tools", number: 5, milling: false }],
  ["#/tools/milling/", { page: "tools", number: null, milling: true }],
  ["#/guide/812/Q463", { page: "guide", path: ["guide", "812", "Q463"] }],
  ["#/glossary/", { page: "guide", path: ["glossary"] }],
  ["#/works", { page: "works" }],
  ["#/works/", { page: "works" }],
  ["#/course", { page: "course", lesson: null, at: 1 }],
  ["#/course/tool", { page: "course", lesson: "tool", at: 1 }],
  ["#/course/tool/4", { page: "course", lesson: "tool", at: 4 }],
  ["#/course/tool/tasks/", { page: "course", lesson: "tool", at: "tasks" }],
  ["#/own", { page: "own", row: null }],
])("%s is read", (hash, address) => expect(parseAddress(hash)).toEqual(address));

test.each([
  "",
  "#",
  "#p=80",
  "#w=80",
  "#h1=80",
  "#prompts",
  "#/nowhere",
  "#/work",
  "#/work/a/kitchen",
  "#/work/a/setup/contour",
  "#/tools/x",
  "#/tools/5/6",
  "#/own/a/b",
  "#/which/a",
  "#/course/tool/0",
  "#/course/tool/007",
  "#/course/tool/end",
  "#/course/tool/1/2",
  "#/works/a",
  "#/work/%",
])("%j is no place", (hash) => expect(parseAddress(hash)).toBeNull());

test.each(["#/work/%E0%A4%A", "#/work/7f3a/%", "#/%/works", "#work/7f3a", ""])("%s is no address", (hash) =>
  expect(parseAddress(hash)).toBeNull(),
);

test.each([
  ["#p=a", true],
  ["#w=a", true],
  ["#h1=a", true],
  ["#t12=a", true],
  ["#s3=a", true],
  ["#r1=a", true],
  ["#h=a", false],
  ["#x1=a", false],
  ["#/work/p=a", false],
])("%s is a share link: %s", (hash, isLink) => expect(isShareLink(hash)).toBe(isLink));

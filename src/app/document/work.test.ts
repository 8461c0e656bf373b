import { expect, test } from "vitest";
import { fileOf, filesOf, textsOf, withFile, withMain, withoutFile, withText, type ProgramWork } from "./work.ts";

const file = (name: string, text = name) => ({ name, text, encoding: "utf-8" as const });
const work: ProgramWork = { ...file("MAIN.h"), files: [file("Cut.h"), file("points.tab")], skipMarked: true };
const names = (program: ProgramWork) => textsOf(program).map(({ name, text }) => `${name}=${text}`);

test("a text is changed by the key of its file, in the main program and in others", () => {
  expect(names(withText(work, "MAIN.H", "a"))).toEqual(["MAIN.h=a", "Cut.h=Cut.h", "points.tab=points.tab"]);
  expect(names(withText(work, "CUT.H", "b"))).toEqual(["MAIN.h=MAIN.h", "Cut.h=b", "points.tab=points.tab"]);
  expect(names(withText(work, "OTHER.H", "c"))).toEqual(names(work));
  expect(fileOf(work, "CUT.H")?.text).toBe("Cut.h");
  expect(fileOf(work, "OTHER.H")).toBeUndefined();
});

test("a file is added, and replaces one of the same name", () => {
  expect(names(withFile(work, file("new.h")))).toEqual([...names(work), "new.h=new.h"]);
  expect(names(withFile(work, file("CUT.H", "2")))).toEqual(["MAIN.h=MAIN.h", "CUT.H=2", "points.tab=points.tab"]);
  expect(names(withFile(work, file("main.H", "2")))).toEqual(["main.H=2", "Cut.h=Cut.h", "points.tab=points.tab"]);
  expect(withFile(work, file("main.H", "2")).skipMarked).toBe(true);
});

test("a file is removed; a work without files equals one that never had any", () => {
  expect(names(withoutFile(work, "CUT.H"))).toEqual(["MAIN.h=MAIN.h", "points.tab=points.tab"]);
  expect(withoutFile({ ...file("A.h"), files: [file("B.h")] }, "B.H")).toEqual(file("A.h"));
  expect(filesOf(file("A.h"))).toBe(filesOf(file("B.h")));
});

test("another file becomes the main program, and the former one takes its place", () => {
  const other = withMain(work, "CUT.H");
  expect(names(other)).toEqual(["Cut.h=Cut.h", "MAIN.h=MAIN.h", "points.tab=points.tab"]);
  expect(other.skipMarked).toBe(true);
  expect(withMain(other, "MAIN.H")).toEqual(work);
  expect(withMain(work, "OTHER.H")).toBe(work);
});

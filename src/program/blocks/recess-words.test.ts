import { expect, test } from "vitest";
import { GROOVE_WORDS } from "../../kernel/contour/groove.ts";
import { UNDERCUT_FORMS, UNDERCUT_WORDS } from "../../kernel/contour/undercut.ts";
import { klartext } from "../../nc/blocks/klartext.ts";
import type { Statement } from "../../nc/statement.ts";
import { formWord } from "./recess-words.ts";

/** Words that the form of a block requires, in its order. */
const asked = (statement: Statement): readonly string[] =>
  klartext.fields(statement).flatMap(({ name }) => (typeof name === "string" ? [] : [name.word]));

test("a recess requires the words that the kernel uses", () => {
  expect(asked({ kind: "groove", form: "RADIAL", words: [] })).toEqual(GROOVE_WORDS);
});

test.each(UNDERCUT_FORMS)("an undercut %s requires the words that the kernel uses", (form) => {
  expect(asked({ kind: "undercut", form: formWord(form), words: [] })).toEqual(UNDERCUT_WORDS[form]);
});

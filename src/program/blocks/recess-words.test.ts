import { expect, test } from "vitest";
import { GROOVE_WORDS } from "../../kernel/contour/groove.ts";
import { UNDERCUT_FORMS, UNDERCUT_WORDS } from "../../kernel/contour/undercut.ts";
import { klartext } from "../../nc/blocks/klartext.ts";
import type { Statement } from "../../nc/statement.ts";
import { formWord } from "./recess-words.ts";

/** The words that the form of a block asks for, in its order. */
const asked = (statement: Statement): readonly string[] =>
  klartext.fields(statement).flatMap(({ name }) => (typeof name === "string" ? [] : [name.word]));

test("a recess is asked for the words that the kernel makes it of", () => {
  expect(asked({ kind: "groove", form: "RADIAL", words: [] })).toEqual(GROOVE_WORDS);
});

test.each(UNDERCUT_FORMS)("an undercut %s is asked for the words that the kernel makes it of", (form) => {
  expect(asked({ kind: "undercut", form: formWord(form), words: [] })).toEqual(UNDERCUT_WORDS[form]);
});

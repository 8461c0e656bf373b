import { readdirSync, readFileSync } from "node:fs";
import ts from "typescript";
import { describe, expect, test } from "vitest";
import { LANGUAGES, type Language } from "../src/i18n/languages.ts";
import { loadTexts } from "../src/i18n/parts.ts";
import { typeset } from "../src/i18n/fr/typography/typeset.ts";
import { BANNED } from "./banned-words.ts";
import { projectPath, sources } from "./sources.ts";

/** A text with its source. A placeholder reads {}. */
interface Text {
  readonly from: string;
  readonly text: string;
}

/** The text of an expression, or null. */
function textOf(node: ts.Node): string | null {
  if (ts.isStringLiteral(node) || ts.isNoSubstitutionTemplateLiteral(node)) return node.text;
  if (ts.isTemplateExpression(node))
    return node.head.text + node.templateSpans.map(({ literal }) => `{}${literal.text}`).join("");
  if (!ts.isBinaryExpression(node) || node.operatorToken.kind !== ts.SyntaxKind.PlusToken) return null;
  const [left, right] = [textOf(node.left), textOf(node.right)];
  return left === null && right === null ? null : `${left ?? "{}"}${right ?? "{}"}`;
}

/** The texts in a source file: its literals, without module names and keys. */
function textsOf(path: string, source: string): readonly Text[] {
  const found: Text[] = [];
  const visit = (node: ts.Node): void => {
    if (ts.isImportDeclaration(node) || ts.isTypeNode(node)) return;
    const text = textOf(node);
    if (text !== null && !(ts.isPropertyAssignment(node.parent) && node.parent.name === node))
      found.push({ from: path, text });
    // A template contains texts in its values; a joined text is one.
    if (text === null || ts.isTemplateExpression(node)) ts.forEachChild(node, visit);
  };
  visit(ts.createSourceFile(path, source, ts.ScriptTarget.Latest, true));
  return found;
}

/** All strings in a value, with their places. */
const stringsIn = (value: unknown, from: string): readonly Text[] =>
  typeof value === "string"
    ? [{ from, text: value }]
    : typeof value === "object" && value !== null
      ? Object.entries(value).flatMap(([key, inner]: [string, unknown]) => stringsIn(inner, `${from}/${key}`))
      : [];

const screens = (language: Language): readonly Text[] =>
  sources(`src/i18n/${language}`).flatMap(({ path, text }) => textsOf(path, text));

/** The texts of lessons and tasks. */
const lessons = (language: Language): readonly Text[] =>
  ["src/course/lessons", "src/course/tasks"].flatMap((folder) =>
    readdirSync(projectPath(folder))
      .filter((name) => name.endsWith(".json"))
      .flatMap((name) => {
        const { words } = JSON.parse(readFileSync(projectPath(`${folder}/${name}`), "utf8")) as {
          readonly words: Readonly<Record<Language, unknown>>;
        };
        return stringsIn(words[language], name);
      }),
  );

/** Banned words in texts, with the better words. */
const faults = (language: Language, texts: readonly Text[]): readonly string[] =>
  texts.flatMap(({ from, text }) =>
    BANNED[language].flatMap(([pattern, better]) => {
      const found = pattern.exec(language === "fr" ? typeset(text) : text);
      return found ? [`${from}: "${found[0]}" in "${text}", better: ${better}`] : [];
    }),
  );

test("a planted banned word is found", () => {
  const planted = textsOf(
    "en.ts",
    'const t = { "hand on": "Share", a: "Hand on", b: (n) => `Take ${n}`, c: "Mend " + "it" };',
  );
  expect(faults("en", planted)).toEqual([
    'en.ts: "Hand on" in "Hand on", better: share',
    'en.ts: "Take {}" in "Take {}", better: use, remove',
    'en.ts: "Mend" in "Mend it", better: fix',
  ]);
  expect(faults("de", [{ from: "de", text: "3 Befunde" }])).toHaveLength(1);
  expect(faults("fr", [{ from: "fr", text: "Quel contour? Aucun" }])).toHaveLength(1);
  expect(faults("fr", [{ from: "fr", text: "Quel contour ? Aucun : « X » ; fin !" }])).toEqual([]);
  expect(faults("zh", [{ from: "zh", text: "所有工作" }])).toHaveLength(1);
});

describe.each(LANGUAGES)("the words in %s", (language) => {
  test("better words are not banned themselves", () => {
    expect(
      faults(
        language,
        BANNED[language].map(([, text]) => ({ from: "better", text })),
      ),
    ).toEqual([]);
  });

  test("the screens contain no banned word", () => {
    const texts = screens(language);
    expect(texts.length).toBeGreaterThan(1000);
    expect(faults(language, texts)).toEqual([]);
  });

  test("the lessons contain no banned word", () => {
    const texts = lessons(language);
    expect(texts.length).toBeGreaterThan(300);
    expect(faults(language, texts)).toEqual([]);
  });

  test("the glossary explains the words of the screens", async () => {
    expect(faults(language, stringsIn(await loadTexts(language, "glossary"), "glossary"))).toEqual([]);
  });
});

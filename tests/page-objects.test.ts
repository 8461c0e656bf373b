import { mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import ts from "typescript";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import type * as Pages from "../e2e/pages/index.ts";
import { pageObjects } from "../scripts/bundle.mjs";

/** A shop's test project: the two files of the build and Playwright, nothing of this checkout. */
let folder = "";
let made: Awaited<ReturnType<typeof pageObjects>>;

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "shop-"));
  made = await pageObjects();
  writeFileSync(join(folder, "playwright.mjs"), made.code);
  for (const [name, code] of Object.entries(made.languages)) writeFileSync(join(folder, name), code);
  writeFileSync(join(folder, "playwright.d.mts"), made.types);
  symlinkSync(resolve("node_modules"), join(folder, "node_modules"));
});
afterAll(() => rmSync(folder, { recursive: true }));

/** Compiler errors of each test of the shop, and of the types that it uses, with the strictest options. */
function complaints(texts: readonly string[]): readonly string[] {
  const paths = texts.map((text, i) => {
    const path = join(folder, `shop${i}.spec.mts`);
    writeFileSync(path, text);
    return path;
  });
  const program = ts.createProgram(paths, {
    strict: true,
    noEmit: true,
    target: ts.ScriptTarget.ES2022,
    module: ts.ModuleKind.NodeNext,
    moduleResolution: ts.ModuleResolutionKind.NodeNext,
    exactOptionalPropertyTypes: true,
    noUncheckedIndexedAccess: true,
    types: ["node"],
    typeRoots: [resolve("node_modules/@types")],
  });
  return [join(folder, "playwright.d.mts"), ...paths].map((path) => {
    const file = program.getSourceFile(path);
    const found = [...program.getSyntacticDiagnostics(file), ...program.getSemanticDiagnostics(file)];
    return found.map(({ messageText }) => ts.flattenDiagnosticMessageText(messageText, " ")).join("; ");
  });
}
const test812 = (line: string) => `
import { expect, test } from "@playwright/test";
import { Turnwise, type Options } from "./playwright.mjs";
const options: Options = { language: "de", heldClock: "2026-11-21T08:00", seed: 7 };
test("a shoulder", async ({ page }) => {
  const turnwise = await Turnwise.open(page, options);
  ${line}
});`;

const guide = readFileSync("docs/automation.md", "utf8");
/** The examples that are printed there, and their journeys. */
const printed = [...guide.matchAll(/^```ts\n(import [^]*?)^```$/gm)].map(([, text = ""]) => text);
const journeys = readFileSync("e2e/documented.spec.ts", "utf8");
/** The documented page objects, as tests name them. */
const documented = [...guide.matchAll(/^\| `(\w+)` \|/gm)].map(([, name]) => name);

describe("the page objects as a module", () => {
  test("import Playwright and nothing else, and carry no catalogue", () => {
    expect([...made.code.matchAll(/^import .*from "(.*)"/gm)].map(([, from]) => from)).toEqual(["@playwright/test"]);
    expect(made.code).not.toMatch(/\brequire\(|\bzod\b/);
    expect([...made.types.matchAll(/from "(.*)"/g)].map(([, from]) => from)).toEqual(["@playwright/test"]);
  });
  test("type-check a test project that has only Playwright, and refuse unknown members", () => {
    const right = `await turnwise.dialog.set("Q463", "2,4");
  await turnwise.show("setup");
  await expect(turnwise.effect.cell("passes")).toHaveText("6");
  const title: string = turnwise.t.cycles.of[812].name + turnwise.t.params.startZ.prompt;
  expect(await turnwise.program.copy()).toContain(title);`;
    const wrong = [
      ['await turnwise.effect.cell("passess").click();', '"passess"'],
      ["await turnwise.dialog.sett();", "'sett'"],
      ['await Turnwise.open(page, { language: "it" });', '"it"'],
      ["turnwise.t.page.undoo;", "'undoo'"],
      ["const n: number = turnwise.t.page.undo;", "'number'"],
    ] as const;
    const [types, said, ...rest] = complaints([right, ...wrong.map(([line]) => line)].map(test812));
    expect([types, said]).toEqual(["", ""]);
    for (const [i, [line, named]] of wrong.entries()) expect(rest[i], line).toContain(named);
  });
  test("are the objects that the documentation lists, each with its members", async () => {
    const { Turnwise } = (await import(join(folder, "playwright.mjs"))) as typeof Pages;
    const turnwise = Turnwise.at({} as never);
    const classOf = (part: object) => part.constructor.name;
    const parts = Object.entries(turnwise).filter(([, part]) => typeof part === "object" && classOf(part) !== "Object");
    expect(documented.toSorted()).toEqual(parts.map(([name]) => name).toSorted());
    for (const [name, part] of parts) expect(made.types, name).toContain(`export declare class ${classOf(part)} `);
    for (const declared of made.types.matchAll(/((?:\/\*\*(?:(?!\*\/)[^])*\*\/)?)\s*export declare class (\w+)/g))
      expect(declared[1], declared[2]).not.toBe("");
  });
  test("the printed examples are journeys that run, and type-check as they are printed", () => {
    expect(printed).toHaveLength(2);
    for (const example of printed) expect(journeys).toContain(example.slice(example.indexOf("test(")).trim());
    expect(complaints(printed.map((text) => text.replace("./turnwise/", "./"))).join("")).toBe("");
  });
  test("fetch a language when it is asked for, and name it when it is missing", async () => {
    // A module of its own: other tests load languages into theirs.
    const { Turnwise } = (await import(`${join(folder, "playwright.mjs")}?fresh`)) as typeof Pages;
    expect(Object.keys(made.languages)).toEqual(["playwright-de.mjs", "playwright-fr.mjs", "playwright-zh.mjs"]);
    expect(made.code).not.toContain("Schruppen");
    expect(() => Turnwise.at({} as never, "fr")).toThrow('Turnwise.load("fr")');
  });
  test("ask in the words of each language", async () => {
    const { Turnwise } = (await import(join(folder, "playwright.mjs"))) as typeof Pages;
    for (const language of ["de", "fr", "zh"] as const) await Turnwise.load(language);
    const asked = (["en", "de", "fr", "zh"] as const).map((language) =>
      Turnwise.at({} as never, language).dialog.promptOf(812, "Q463"),
    );
    expect(new Set(asked).size).toBe(4);
    expect(asked).not.toContain("");
    expect(Turnwise.at({} as never).start.cycles).toContain(852);
  });
});

import { describe, expect, test } from "vitest";
import { code, projectFolder, sources } from "./sources.ts";

/** What a layer may import: names of layers and packages; `types` lists those of which only types may come. */
interface Rule {
  readonly values: readonly string[];
  readonly types?: readonly string[];
}
const RULES: Record<string, Rule> = {
  kernel: { values: ["clipper2-ts"] },
  nc: { values: [] },
  cycles: { values: ["kernel", "zod"] },
  program: { values: ["kernel", "cycles", "nc", "zod"] },
  sim: { values: ["kernel"] },
  view: { values: ["kernel", "sim"], types: ["cycles"] },
  report: { values: ["kernel", "cycles", "nc", "program", "sim", "i18n"] },
  i18n: { values: [], types: ["kernel", "cycles", "nc", "program"] },
  examples: { values: [] },
};
const layerOf = (path: string) => path.split("/")[1] ?? "";
const all = sources("src");
const layered = all.filter((s) => layerOf(s.path) in RULES);

describe("who may import whom", () => {
  test.each(layered.map((s) => [s.path, s] as const))("%s", (_, source) => {
    const here = layerOf(source.path);
    const rule = RULES[here] ?? { values: [] };
    const wrong = source.imports.filter(({ target, relative, typesOnly }) => {
      const to = relative ? layerOf(target) : target;
      const allowed = [here, ...rule.values, ...(typesOnly ? (rule.types ?? []) : [])];
      return !allowed.includes(to);
    });
    expect(wrong).toEqual([]);
  });

  test("every layer has its rule", () => {
    const layers = new Set(all.map((s) => layerOf(s.path)).filter((l) => !l.includes(".")));
    expect([...layers].filter((l) => l !== "app" && !(l in RULES))).toEqual([]);
  });

  test("the imports are read at all", () => {
    const names = all.flatMap((s) => s.imports.map((i) => i.target));
    expect(names).toContain("zod");
    expect(names).toContain("src/kernel/units.ts");
  });
});

describe("what one file keeps to itself", () => {
  test("only kernel/clip.ts imports the polygon engine", () => {
    expect(all.filter((s) => s.imports.some((i) => i.target.startsWith("clipper"))).map((s) => s.path)).toEqual(["src/kernel/clip.ts"]);
  });

  test("only kernel/units.ts halves or doubles an X", () => {
    const halved = /\b(?:[xX]|d|diameter\w*|\w*Diameter|Q4[89][13])\s*[*/]\s*2\b|\b2\s*\*\s*(?:[xX]|\w+\.r|r|radius)\b/;
    const found = all
      .filter((s) => s.path !== "src/kernel/units.ts" && ["kernel", "cycles", "program", "sim", "nc"].includes(layerOf(s.path)))
      .flatMap((s) => code(s.text).split("\n").filter((line) => halved.test(line)).map((line) => `${s.path}: ${line.trim()}`));
    expect(found).toEqual([]);
  });

  test("no cycle number outside the catalogue, the texts and the help picture", () => {
    const numbers = projectFolder("src/cycles").flatMap((name) => /^c(\d+)\.ts$/.exec(name)?.[1] ?? []);
    expect(numbers.length).toBeGreaterThan(2);
    const pattern = new RegExp(`(?<![\\d.])(?:${numbers.join("|")})(?![\\d.])`);
    const found = all
      .filter((s) => !["cycles", "i18n"].includes(layerOf(s.path)) && !s.path.startsWith("src/view/help/"))
      .flatMap((s) => s.text.split("\n").filter((line) => pattern.test(line)).map((line) => `${s.path}: ${line.trim()}`));
    expect(found).toEqual([]);
  });
});

describe("what is nowhere", () => {
  const bans: [string, RegExp, (path: string) => boolean][] = [
    ["eval of any kind", /\beval\s*\(|new Function\s*\(/, () => true],
    ["default exports", /^export default\b/m, () => true],
    ["star exports", /^export \*/m, () => true],
    ["React below app", /from "react/, (p) => layerOf(p) !== "app"],
    ["clock or chance below app", /\bDate\b|Math\.random|performance\.now/, (p) => layerOf(p) !== "app"],
    ["vague file names", /^$/, (p) => /(?:^|\/)(?:utils?|helpers?|common|misc|manager)\.tsx?$/.test(p)],
  ];
  test.each(bans)("%s", (name, pattern, where) => {
    const found = all.filter((s) => where(s.path) && (name === "vague file names" || pattern.test(code(s.text))));
    expect(found.map((s) => s.path)).toEqual([]);
  });
});

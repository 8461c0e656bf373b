import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { code, projectFolder, projectPath, sources } from "./sources.ts";

/**
 * The allowed imports of a layer: names of layers and packages; `types` lists those from which only types are allowed.
 */
interface Rule {
  readonly values: readonly string[];
  readonly types?: readonly string[];
}
const RULES: Record<string, Rule> = {
  kernel: { values: ["clipper2-ts"] },
  nc: { values: [] },
  "control-file": { values: [] },
  cycles: { values: ["kernel", "zod"] },
  program: { values: ["kernel", "cycles", "nc", "zod"] },
  sim: { values: ["kernel"] },
  // Of three only the triangulation, which cannot draw: the build keeps the rest out of the worker.
  view: { values: ["kernel", "sim", "three"], types: ["cycles"] },
  report: { values: ["kernel", "cycles", "nc", "program", "sim", "i18n"] },
  planning: { values: ["kernel", "cycles", "nc", "program", "sim", "report", "zod"], types: ["i18n"] },
  course: { values: ["kernel", "cycles", "nc", "program", "sim", "report", "i18n", "planning", "zod"] },
  i18n: { values: ["nc"], types: ["kernel", "cycles", "program", "planning"] },
  examples: { values: [] },
};
const layerOf = (path: string) => path.split("/")[1] ?? "";
/** The layers of the page. */
const PAGE = ["app", "features", "shell"];
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
    expect([...layers].filter((l) => !PAGE.includes(l) && !(l in RULES))).toEqual([]);
  });

  test("the imports are read at all", () => {
    const names = all.flatMap((s) => s.imports.map((i) => i.target));
    expect(names).toContain("zod");
    expect(names).toContain("src/kernel/units.ts");
  });
});

/**
 * A name of a place across the axis or of a diameter. Radii of arcs, noses and cutters are lengths and may be doubled.
 */
const ACROSS = String.raw`\b(?:[xXrR]|(?<!\.)radius|diameter|[a-z]\w*Diameter|outside|bore|Q4[89][13])\b`;
const TWO = String.raw`(?:2(?:\.0*)?|0?\.50*)(?![\d.])`;
/** Twice or half of it, in either order, bracketed or not; as a sum with itself. */
const DOUBLED = new RegExp(
  [
    String.raw`(?:${ACROSS}|\bd\b)\)*\s*(?:\*(?!\*)|/)\s*${TWO}`,
    String.raw`(?<![\w.*])${TWO}\s*\*\s*\(*(?:\w+(?:\[\w+\])?[!?]?\.)*${ACROSS}`,
    String.raw`([\w.]*\.[xr]) \+ \1\b`,
  ].join("|"),
);
/** A number cast to a radius or a diameter without its functions, or the factor between them derived from a 1. */
const FORCED = /\bas (?:Radius|Diameter)\b|\bto(?:Radius|Diameter)\(\s*(?:radius|diameter)\(\s*[\d.]*[1-9]/;
const MEAN = /\([^()]*\+[^()]*\)\s*\/\s*2\b/g;
/** Whether a line converts between radius and diameter. Pictures also have an x, in pixels. */
const converts = (line: string, layer: string) =>
  FORCED.test(line) || (layer !== "view" && DOUBLED.test(line.replaceAll(MEAN, "")));

describe("what one file keeps to itself", () => {
  test("only kernel/clip.ts imports the polygon engine", () => {
    expect(all.filter((s) => s.imports.some((i) => i.target.startsWith("clipper"))).map((s) => s.path)).toEqual([
      "src/kernel/area/clip.ts",
    ]);
  });

  test("only app/parts.ts makes components that are fetched later, which must not fail by not coming", () => {
    const makes = all.filter((s) => /\blazy\b[^;]*from "react"|\bReact\.lazy\b/.test(code(s.text))).map((s) => s.path);
    expect(makes).toEqual(["src/app/base/parts.ts"]);
  });

  test.each([
    ["NumberInput", "fields/number/NumberInput", /data-number"/],
    ["Message", "base/Message", /className=\S*field-message\b(?!s)/],
  ])("only %s makes what it stands for", (_, file, pattern) => {
    const found = all.filter(
      (s) => s.path.endsWith(".tsx") && !s.path.endsWith(".test.tsx") && pattern.test(code(s.text)),
    );
    expect(found.map((s) => s.path)).toEqual([`src/app/${file}.tsx`]);
  });

  test("only app/base/storage.ts and app/base/database.ts ask the browser to keep anything", () => {
    const page = all.filter((s) => PAGE.includes(layerOf(s.path)) && !/\.test\.tsx?$|\/fake-device\.ts$/.test(s.path));
    const asks = page.filter(
      (s) => /\b(?:localStorage|sessionStorage|indexedDB)\b/.test(code(s.text)) || /"idb-keyval"/.test(s.text),
    );
    expect(asks.map((s) => s.path).sort()).toEqual(["src/app/base/database.ts", "src/app/base/storage.ts"]);
    // Each stored item is declared once, under its own key.
    const keys = page
      .flatMap((s) => [
        ...s.text.matchAll(/\b(?:stored(?:Text|Data)(?:<.*>)?|database)\("([\w-]+)"|\brecord\(\{\s*key: "([\w-]+)"/g),
      ])
      .map(([, key, ofRecord]) => key ?? ofRecord);
    expect(new Set(keys).size).toBe(keys.length);
    expect(keys.length).toBeGreaterThan(18);
  });

  test("only program/files/bounded.ts parses JSON, within its bounds", () => {
    const parses = all.filter((s) => !/\.test\.tsx?$/.test(s.path) && /\bJSON\.parse\b/.test(code(s.text)));
    expect(parses.map((s) => s.path)).toEqual(["src/program/files/bounded.ts"]);
  });

  test("every record goes into archives", () => {
    const records = all.flatMap((s) =>
      [...s.text.matchAll(/^export const (\w+) = record\(/gm)].map(([, name = ""]) => name),
    );
    const parts = all.find((s) => s.path === "src/app/records/parts.ts")?.text ?? "";
    expect(records.length).toBeGreaterThan(5);
    expect(records.filter((name) => !parts.includes(`ofRecord(${name},`))).toEqual([]);
  });

  test("only kernel/units.ts halves or doubles an X", () => {
    const found = all
      .filter((s) => s.path !== "src/kernel/units.ts")
      .flatMap((s) =>
        code(s.text)
          .split("\n")
          .filter((line) => converts(line, layerOf(s.path)))
          .map((line) => `${s.path}: ${line.trim()}`),
      );
    expect(found).toEqual([]);
  });

  test.each([
    "const x = 2 * p.r;",
    "const x = p.r * 2;",
    "(setting.start.r * 2) as Diameter",
    "start.x / 2",
    "v.Q491 / 2",
    "radius*2.0",
    "d / 2",
    "0.5 * diameter",
    "outerDiameter * .5",
    "move.to.r + move.to.r",
    "value as Diameter",
    "n as Radius",
    "at.r / toDiameter(radius(1))",
    "toRadius(diameter(1.0)) * x",
    "points[0]!.r * 2",
    "(p.r) * 2",
    "2 * (p.r - q.r)",
    "(p.r - q.r) * 2",
  ])("%s goes round that and is found", (line) => expect(converts(line, "cycles")).toBe(true));

  test.each([
    "(a.r + b.r) / 2",
    "const mean = (from.x + to.x)/2;",
    "x ** 2",
    "dr * dr",
    "r * 20",
    "s.r / 2.5",
    "depth / 2",
    "p.r + q.r",
    "index * 2",
    "toDiameter(p.r)",
    "2 * Math.PI * r",
    "2 * noseRadius(tool)",
    "toRadius(diameter(0))",
  ])("%s is no conversion", (line) => expect(converts(line, "cycles")).toBe(false));

  test("view draws what is planned: it divides no infeed itself and reads nothing from the spelling of an id", () => {
    const view = all.filter((s) => layerOf(s.path) === "view");
    const dividing = /^src\/kernel\/strategy\/(?:infeed|levels|leveled|recess)/;
    expect(view.filter((s) => s.imports.some((i) => dividing.test(i.target))).map((s) => s.path)).toEqual([]);
    expect(
      view.filter((s) => /\.(?:startsWith|endsWith)\(|\.text [!=]==/.test(code(s.text))).map((s) => s.path),
    ).toEqual([]);
  });

  test("no cycle number outside the catalogue, the texts, the help picture and what links are packed with", () => {
    const numbers = projectFolder("src/cycles").flatMap((name) => /^c(\d+)\.ts$/.exec(name)?.[1] ?? []);
    expect(numbers.length).toBeGreaterThan(2);
    // A quoted number is a typed value.
    const pattern = new RegExp(`(?<![\\d."])(?:${numbers.join("|")})(?![\\d."])`);
    const found = all
      .filter((s) => !["cycles", "i18n"].includes(layerOf(s.path)) && !s.path.startsWith("src/view/help/"))
      .filter((s) => !s.path.endsWith("-dictionary.ts"))
      .flatMap((s) =>
        s.text
          .split("\n")
          .filter((line) => pattern.test(line))
          .map((line) => `${s.path}: ${line.trim()}`),
      );
    expect(found).toEqual([]);
  });
});

describe("what the start page waits for", () => {
  const files = new Map(all.map((s) => [s.path, s]));
  const reached = new Map<string, string>();
  const visit = (path: string, from: string) => {
    if (reached.has(path)) return;
    reached.set(path, from);
    for (const { target, typesOnly, lazy } of files.get(path)?.imports ?? [])
      if (!typesOnly && !lazy) visit(target, path);
  };
  visit("src/shell/main.tsx", "");

  test.each([
    "react-aria-components",
    "@codemirror/view",
    "src/program/drawing/formats.ts",
    "clipper2-ts",
    "src/cycles/index.ts",
    "src/program/job/job.ts",
    "src/i18n/index.ts",
    "src/i18n/en/workplace.ts",
    "src/app/document/reading.ts",
    "src/app/calculation/client.ts",
  ])("not %s", (name) => expect(reached.get(name)).toBe(undefined));

  test("nothing of the catalogue, no strategy, no text of a dialog", () => {
    const late = /^src\/(?:cycles|sim|report|kernel\/strategy|i18n\/\w+)\//;
    expect([...reached].filter(([path]) => late.test(path))).toEqual([]);
    expect([...reached.keys()].filter((path) => /\buseTexts\(\)/.test(files.get(path)?.text ?? ""))).toEqual([]);
  });

  test("its files are followed at all", () => {
    expect(reached.has("react")).toBe(true);
    expect(reached.has("src/features/start/StartPage.tsx")).toBe(true);
  });
});

test("the page does not fetch the grammar of files", () => {
  const users = all.filter((s) => s.imports.some((i) => i.target.startsWith("src/control-file/")));
  expect(users.filter((s) => layerOf(s.path) !== "control-file").map((s) => s.path)).toEqual([]);
});

describe("what is nowhere", () => {
  const bans: [string, RegExp, (path: string) => boolean][] = [
    ["eval of any kind", /\beval\s*\(|new Function\s*\(/, () => true],
    ["default exports", /^export default\b/m, () => true],
    ["star exports", /^export \*/m, () => true],
    ["React below app", /from "react/, (p) => !PAGE.includes(layerOf(p))],
    ["clock or chance below app", /\bDate\b(?!")|Math\.random|performance\.now/, (p) => !PAGE.includes(layerOf(p))],
    ["vague file names", /^$/, (p) => /(?:^|\/)(?:utils?|helpers?|common|misc|manager)\.tsx?$/.test(p)],
  ];
  test.each(bans)("%s", (name, pattern, where) => {
    const found = all.filter((s) => where(s.path) && (name === "vague file names" || pattern.test(code(s.text))));
    expect(found.map((s) => s.path)).toEqual([]);
  });
});

/**
 * The tolerance that decides whether two numbers agree is a constant with a name and a reason, here or in
 * kernel/tolerance.ts.
 */
test("no tolerance without a name", () => {
  const bare = (line: string) => /\de-\d/.test(line) && !/^(?:export )?const [A-Z_]+ = /.test(line);
  const found = all.flatMap(({ path, text }) =>
    code(text)
      .split("\n")
      .filter(bare)
      .map((line) => `${path}: ${line.trim()}`),
  );
  expect(found).toEqual([]);
});

/**
 * Style sheets use the conditions of app/media.ts; only its lathe and contour panels query their own width, by
 * container.
 */
test("breakpoints exist once", () => {
  const styles = readdirSync(projectPath("src"), { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(".css"))
    .map((name) => ({ path: `src/${name}`, text: readFileSync(projectPath(`src/${name}`), "utf8") }));
  expect(styles.length).toBeGreaterThan(5);
  const bare = styles.flatMap(({ path, text }) =>
    [...text.matchAll(/@media[^{]*?(?:width|height)[^{]*/g)].map(([query]) => `${path}: ${query}`),
  );
  const queries = all.filter(
    ({ path, text }) => path !== "src/app/base/media.ts" && /\((?:min|max)-(?:width|height):/.test(code(text)),
  );
  expect([...bare, ...queries.map(({ path }) => path)]).toEqual([]);
});

/** Files that import each other can only be understood together; types count too. */
test("no files import each other in a circle", () => {
  const targets = new Map(all.map((s) => [s.path, s.imports.filter((i) => i.relative).map((i) => i.target)]));
  const state = new Map<string, "open" | "done">();
  const circles: string[] = [];
  const visit = (path: string, way: readonly string[]): void => {
    if (state.get(path) === "open") circles.push([...way.slice(way.indexOf(path)), path].join(" → "));
    if (state.has(path)) return;
    state.set(path, "open");
    for (const target of targets.get(path) ?? []) visit(target, [...way, path]);
    state.set(path, "done");
  };
  for (const path of targets.keys()) visit(path, []);
  expect(circles).toEqual([]);
});

test("no exported name means two things in one layer, room or feature", () => {
  const owners = new Map<string, string[]>();
  for (const { path, text } of all.filter((s) => !s.path.startsWith("src/i18n/")))
    for (const [, name = ""] of text.matchAll(/^export (?:const|function|class|interface|type) (\w+)/gm)) {
      const within = path
        .split("/")
        .slice(1, ["app", "features"].includes(layerOf(path)) ? 3 : 2)
        .join("/");
      owners.set(`${within}: ${name}`, [...(owners.get(`${within}: ${name}`) ?? []), path]);
    }
  expect([...owners].filter(([, paths]) => paths.length > 1)).toEqual([]);
});

describe("packages", () => {
  /** Packages that are used by name or by another package, and never imported. */
  const unimported = new Set([
    "@types/node",
    "@types/react",
    "@types/react-dom",
    "@types/three",
    "@testing-library/dom",
    "axe-core",
    "jsdom",
    "oxfmt",
    "oxlint",
    "typescript-native",
  ]);
  const read = (path: string) => readFileSync(projectPath(path), "utf8");
  const manifest = JSON.parse(read("package.json")) as Record<
    "dependencies" | "devDependencies",
    Record<string, string>
  >;
  const files = ["src", "tests", "scripts", "e2e"].flatMap((folder) =>
    readdirSync(projectPath(folder), { recursive: true, encoding: "utf8" })
      .filter((name) => /\.(?:tsx?|css|mjs)$/.test(name))
      .map((name) => `${folder}/${name}`),
  );
  const text = [...files, "vite.config.ts", "playwright.config.ts"].map(read).join("\n");
  test.each(
    Object.keys({ ...manifest.dependencies, ...manifest.devDependencies }).filter((name) => !unimported.has(name)),
  )("%s is used", (name) =>
    expect(new RegExp(`(?:from|import|import\\(|url\\()\\s*["']${name}(?:/[^"']*)?["']`).test(text)).toBe(true),
  );
});

import { existsSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { describe, expect, test } from "vitest";
import { cycleSvg } from "../scripts/cycle-picture.ts";
import { cyclePage } from "../scripts/cycle-page.ts";
import { klartextPage } from "../scripts/klartext-page.ts";
import { machineJsonSchema, partJsonSchema } from "../scripts/json-schemas.ts";
import { catalogue } from "../src/cycles/index.ts";
import { projectFile, projectFolder, projectPath } from "./sources.ts";

describe("pages written from the catalogue", () => {
  test.each(catalogue.map((c) => [c.number, c] as const))(
    "the page of %i is what `npm run docs` writes",
    (number, cycle) => {
      expect(projectFile(`docs/cycles/${number}.md`)).toBe(cyclePage(cycle));
      const picture = cycleSvg(cycle);
      if (picture !== null) expect(projectFile(`docs/cycles/${number}.svg`)).toBe(picture);
    },
  );

  test("the page of all blocks is what `npm run docs` writes", () =>
    expect(projectFile("docs/klartext.md")).toBe(klartextPage()));

  test.each([
    ["machine", machineJsonSchema],
    ["part", partJsonSchema],
  ])("the schema of %s files is what `npm run docs` writes", (name, schema) =>
    expect(projectFile(`docs/${name}.schema.json`)).toBe(schema()),
  );

  test("there is no page without its cycle", () => {
    expect(projectFolder("docs/cycles").sort()).toEqual(
      catalogue.flatMap((c) => (c.acts ? [`${c.number}.md`] : [`${c.number}.md`, `${c.number}.svg`])).sort(),
    );
  });
});

describe("names in documents exist", () => {
  const documents = [
    "README.md",
    "CONTRIBUTING.md",
    "SECURITY.md",
    ...["docs", "docs/decisions"].flatMap((folder) =>
      projectFolder(folder)
        .filter((n) => n.endsWith(".md"))
        .map((n) => `${folder}/${n}`),
    ),
  ];
  const known = ["src", "tests", "e2e", "scripts"].flatMap((folder) =>
    readdirSync(projectPath(folder), { recursive: true, encoding: "utf8" }).map(
      (name) => `/${folder}/${name.replaceAll("\\", "/")}`,
    ),
  );
  test.each(documents)("%s", (path) => {
    const text = projectFile(path);
    const links = [...text.matchAll(/\]\(([^)#\s]+)[^)]*\)/g)]
      .map(([, to = ""]) => to)
      .filter((to) => !/^[a-z]+:/.test(to));
    const files = [...text.matchAll(/`((?:src|tests|e2e|scripts|docs)\/[\w./-]+)`/g)].map(([, to = ""]) => to);
    const missing = [...links.map((to) => join(dirname(path), to)), ...files].filter(
      (to) => !existsSync(projectPath(to)),
    );
    // A document may name a file by the end of its path.
    const short = [...text.matchAll(/`((?!dist\/)[\w.-]+\/[\w./-]+\.(?:tsx?|mjs|css))`/g)].map(([, to = ""]) => to);
    const lost = short.filter((to) => !known.some((each) => each.endsWith(`/${to}`)));
    expect([...missing, ...lost]).toEqual([]);
  });

  test("each function that the walks name is in its file", () => {
    const rows = [...projectFile("docs/walks.md").matchAll(/^\| `(src\/[^`]+)` \| (.*) \|$/gm)];
    const missing = rows.flatMap(([, file = "", what = ""]) => {
      const source = projectFile(file);
      const named = [...what.matchAll(/`([A-Za-z]+)`/g)].map(([, name = ""]) => name);
      return named.filter((name) => !new RegExp(`\\b${name}\\b`).test(source)).map((name) => `${name} in ${file}`);
    });
    expect(missing).toEqual([]);
    expect(rows.length).toBeGreaterThan(50);
  });

  test("the commands of the documents are scripts of package.json", () => {
    const { scripts } = JSON.parse(projectFile("package.json")) as { scripts: Record<string, string> };
    const named = documents.flatMap((path) =>
      [...projectFile(path).matchAll(/npm run (?:--silent )?([a-z0-9:]+)/g)].map(([, name = ""]) => name),
    );
    expect(named.filter((name) => !(name in scripts))).toEqual([]);
    const missing = Object.keys(scripts).filter((name) => !["start", "test"].includes(name) && !named.includes(name));
    expect(missing).toEqual([]);
  });

  test("every picture of `npm run pictures` is shown in a document", () => {
    const shown = documents.flatMap((path) =>
      [...projectFile(path).matchAll(/!\[[^\]]+\]\(([^)]+)\)/g)].map(([, to = ""]) => join(dirname(path), to)),
    );
    const pictures = projectFolder("docs/pictures").map((name) => `docs/pictures/${name}`);
    expect(pictures.filter((path) => !shown.includes(path))).toEqual([]);
    expect(pictures.length).toBeGreaterThan(3);
  });

  test("the newest version of the changelog is that of package.json", () => {
    const { version } = JSON.parse(projectFile("package.json")) as { version: string };
    expect(/^## (\d+\.\d+\.\d+)/m.exec(projectFile("CHANGELOG.md"))?.[1]).toBe(version);
  });
});

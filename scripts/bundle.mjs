import { execFile } from "node:child_process";
import { mkdirSync, readFileSync, renameSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { promisify } from "node:util";
import { root } from "./packages.mjs";

/** A file with all its imports as modules for Node, the first of them its own; `output`: how they are split. */
async function modulesOf(
  entry,
  { minify = false, plugins = [], external = [], output = { codeSplitting: false } } = {},
) {
  const { build } = await import("vite");
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const made = await build({
    root,
    configFile: false,
    logLevel: "error",
    publicDir: false,
    plugins,
    define: { "import.meta.env.VITE_VERSION": JSON.stringify(version) },
    ssr: { noExternal: true, external, target: "node" },
    build: {
      ssr: join(root, entry),
      write: false,
      target: "node20",
      minify,
      rolldownOptions: { output },
    },
  });
  return made.output.filter((file) => file.type === "chunk").sort((a, b) => Number(b.isEntry) - Number(a.isEntry));
}

/** The same as the text of one module. */
async function oneModule(entry, how) {
  const chunks = await modulesOf(entry, how);
  if (chunks.length !== 1) throw new Error(`${entry} became ${chunks.length} files`);
  return chunks[0].code;
}

/**
 * scripts/NAME.ts with all it imports as the text of one module, which plain Node runs without a checkout and without
 * packages.
 *
 * @param {string} name the script
 * @param {{ minify?: boolean }} [how]
 * @returns {Promise<string>}
 */
export async function bundle(name, how) {
  const { runnerImport } = await import("vite");
  const { module } = await runnerImport(join(root, "scripts/made-modules.ts"), {
    configFile: false,
    logLevel: "error",
  });
  return oneModule(`scripts/${name}.ts`, { external: ["@playwright/test"], plugins: Object.values(module), ...how });
}

const PROMPT_IDS = "/e2e/pages/prompt-ids.ts";

/** Replaces the catalogue with the table of prompt names that is made from it. */
const promptIds = {
  name: "prompt-ids",
  async load(id) {
    if (!id.endsWith(PROMPT_IDS)) return undefined;
    const { runnerImport } = await import("vite");
    const { module } = await runnerImport(join(root, PROMPT_IDS), { configFile: false, logLevel: "error" });
    return `export const promptIds = ${JSON.stringify(module.promptIds)};`;
  },
};

const KEPT_TYPES = join(root, "node_modules", ".cache", "turnwise", "page-types.json");

/** Size and time of a file. */
function stamp(path) {
  const { size, mtimeMs } = statSync(path);
  return `${size} ${mtimeMs}`;
}

/** The cached types, if none of their sources has changed: compiling them takes seconds. */
function keptTypes() {
  try {
    const { stamps, types } = JSON.parse(readFileSync(KEPT_TYPES, "utf8"));
    return stamps.every(([path, was]) => stamp(path) === was) ? types : null;
  } catch {
    return null;
  }
}

async function pageTypes() {
  const kept = keptTypes();
  if (kept !== null) return kept;
  const script = join(root, "scripts", "page-types.mjs");
  const { stdout } = await promisify(execFile)(process.execPath, [script], { maxBuffer: 10_000_000 });
  const { types, from } = JSON.parse(stdout);
  const stamps = [...from, script, join(root, "package-lock.json"), join(root, "tsconfig.base.json")].map((path) => [
    path,
    stamp(path),
  ]);
  mkdirSync(dirname(KEPT_TYPES), { recursive: true });
  const fresh = `${KEPT_TYPES}-${process.pid}`;
  writeFileSync(fresh, JSON.stringify({ stamps, types }));
  renameSync(fresh, KEPT_TYPES);
  return types;
}

const READ_WORDS = "/e2e/pages/read-words.ts";
const WORDS = "page-words:";
/** The language that the page objects have without another file. */
const BUILT_IN = "en";

/** Replaces the reading of texts with a module for each language. */
const wordFiles = {
  name: "word-files",
  resolveId: (id) => (id.startsWith(WORDS) ? id : undefined),
  async load(id) {
    if (!id.startsWith(WORDS) && !id.endsWith(READ_WORDS)) return undefined;
    const { runnerImport } = await import("vite");
    const imported = async (path) =>
      (await runnerImport(join(root, path), { configFile: false, logLevel: "error" })).module;
    if (id.startsWith(WORDS)) {
      const { filesOf } = await imported(READ_WORDS);
      const files = filesOf(id.slice(WORDS.length)).map(([name, path]) => [
        name,
        join(root, dirname(READ_WORDS), path),
      ]);
      // By name: a namespace object would need a runtime file that the languages share.
      const nameIn = (path) => /^export const (\w+)/m.exec(readFileSync(path, "utf8"))?.[1];
      const imports = files.map(
        ([, path], i) => `import { ${nameIn(path)} as part${i} } from ${JSON.stringify(path)};`,
      );
      const parts = files.map(([name], i) => `${JSON.stringify(name)}: part${i}`);
      return `${imports.join("\n")}\nexport const parts = { ${parts.join(", ")} };`;
    }
    const { LANGUAGES } = await imported("src/i18n/languages.ts");
    const loaders = LANGUAGES.filter((language) => language !== BUILT_IN).map(
      (language) => `${language}: () => import("${WORDS}${language}")`,
    );
    return [
      `import { parts as ${BUILT_IN} } from "${WORDS}${BUILT_IN}";`,
      `const loaders = { ${BUILT_IN}: async () => ({ parts: ${BUILT_IN} }), ${loaders.join(", ")} };`,
      "export const readWords = async (language) => (await loaders[language]()).parts;",
    ].join("\n");
  },
};

const PAGES_FILE = "playwright.mjs";

/**
 * The page objects of the journeys as a module that needs Playwright alone, its types, and one file for each language
 * besides English, which it fetches when that language is opened.
 *
 * @returns {Promise<{ code: string, types: string, languages: Readonly<Record<string, string>> }>}
 */
export async function pageObjects() {
  const [[main, ...others], types] = await Promise.all([
    modulesOf("e2e/pages/index.ts", {
      plugins: [promptIds, wordFiles],
      external: ["@playwright/test"],
      output: {
        entryFileNames: PAGES_FILE,
        chunkFileNames: ({ facadeModuleId }) =>
          PAGES_FILE.replace(".", `-${facadeModuleId?.split(WORDS)[1] ?? "shared"}.`),
      },
    }),
    pageTypes(),
  ]);
  return {
    code: main.code,
    types,
    languages: Object.fromEntries(others.map(({ fileName, code }) => [fileName, code])),
  };
}

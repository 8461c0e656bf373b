import { chmodSync, readFileSync, statSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";
import react from "@vitejs/plugin-react";
import { runnerImport, type Plugin } from "vite";
import { configDefaults, defineConfig } from "vitest/config";
import { bundle, pageObjects, type PageObjects } from "./scripts/bundle.mjs";
import { LongestFirst } from "./scripts/longest-first.ts";
import { courseIndex, cycleMenu, startPictures } from "./scripts/made-modules.ts";
import { offline } from "./scripts/offline.ts";
import { contentPolicy } from "./scripts/serve.mjs";
import { MEDIA } from "./src/app/base/media.ts";
import { LANGUAGES } from "./src/i18n/languages.ts";
import { REPLACING } from "./tests/replacing.ts";

/**
 * The static site (paths relative, so that it runs from any folder) and the tests. Where CI is set a missing golden is
 * an error and never written. A tree passes its tests or it does not: their shuffled order and the cases of the laws
 * come from a seed that stays the same. SEED=number is another order, LAW_SEED=number other cases; `npm run laws` looks
 * for cases that nobody has tried.
 */
const seed = Number(process.env["SEED"] ?? 1);
process.env["LAW_SEED"] ??= "1";
const exclude = [...configDefaults.exclude, "e2e/**"];

// The page says which version it is.
process.env["VITE_VERSION"] = (
  JSON.parse(readFileSync(new URL("package.json", import.meta.url), "utf8")) as { version: string }
).version;

/** Only in the build: the development server needs inline scripts and a web socket. */
const policyOfPage: Plugin = {
  name: "content-policy",
  apply: "build",
  transformIndexHtml: () => [
    {
      tag: "meta",
      attrs: { "http-equiv": "Content-Security-Policy", content: contentPolicy },
      injectTo: "head-prepend",
    },
  ],
};

/** What a root font size of 100 % is for: style sheets are written for it, in pixels. */
const ROOT_SIZE = 16;

/**
 * `(--name)` in a media query stands for the condition of that name. Lengths in pixels become shares of the root's
 * size, so that the page grows as a whole; hairlines stay what they are.
 */
const pageStyles: Plugin = {
  name: "page-styles",
  enforce: "pre",
  transform(code, id) {
    if (!/\.css(\?|$)/.test(id) || id.includes("node_modules")) return undefined;
    const grown = code.replaceAll(/(?<![\w.])(\d*\.?\d+)px\b/g, (written, n: string) =>
      Number(n) > 1 ? `${Number(n) / ROOT_SIZE}rem` : written,
    );
    return grown.replaceAll(/\(--([a-z]+)\)(?=[^;{}]*\{)/g, (written, name: string) => {
      const condition = Object.entries(MEDIA).find(([known]) => known === name)?.[1];
      if (condition === undefined) this.error(`${written} is no condition of src/app/base/media.ts`);
      return condition;
    });
  },
};

/** gallery.html and its styles: every golden and every cycle as drawings, of no weight for the page itself. */
const gallery: Plugin = {
  name: "gallery",
  apply: (_, { command, isSsrBuild }) => command === "build" && !isSsrBuild,
  async generateBundle() {
    const from = new URL("scripts/gallery.ts", import.meta.url).pathname;
    const { module } = await runnerImport<{ galleryFiles: () => Readonly<Record<string, string>> }>(from, {
      configFile: false,
      logLevel: "error",
    });
    for (const [fileName, source] of Object.entries(module.galleryFiles()))
      this.emitFile({ type: "asset", fileName, source });
  },
};

let making: Promise<[string, PageObjects]> | null = null;

/** What tests and scripts of a shop take from the site; the page never asks for it. */
const besides: Plugin = {
  name: "besides",
  apply: (_, { command, isSsrBuild }) => command === "build" && !isSsrBuild,
  // Made while the page is: the types of the page objects take the compiler as long as the page takes.
  buildStart() {
    making = Promise.all([bundle("standalone", { minify: true }), pageObjects()]);
    making.catch(() => undefined);
  },
  async generateBundle() {
    if (!making) return;
    const [verify, { code, types, languages }] = await making;
    this.emitFile({ type: "asset", fileName: "verify.mjs", source: `#!/usr/bin/env node\n${verify}` });
    this.emitFile({ type: "asset", fileName: "playwright.mjs", source: code });
    for (const [fileName, source] of Object.entries(languages)) this.emitFile({ type: "asset", fileName, source });
    this.emitFile({ type: "asset", fileName: "playwright.d.mts", source: types });
  },
  writeBundle({ dir = "dist" }) {
    chmodSync(join(dir, "verify.mjs"), 0o755);
  },
};

/** What the build knows of a module that it asks about. */
interface Modules {
  getModuleInfo(
    id: string,
  ): { readonly importedIds: readonly string[]; readonly dynamicallyImportedIds: readonly string[] } | null;
}

const module = (path: string) => new URL(path, import.meta.url).pathname;
/** Where the dialog of a cycle begins: everything that these cannot start without is fetched before it works. */
const WORK = ["src/shell/Workplace.tsx", "src/features/start/begin.ts"].map(module);
/**
 * What the first screen fetches by itself: what it shares with a dialog is a file of its own, and brings none along.
 */
const EARLY = [
  "src/features/course/CourseEntrance.tsx",
  "src/features/start/Hero.tsx",
  "src/app/records/keep-pictures.ts",
  "src/app/records/keep-steps.ts",
  "src/app/records/files/kept-handles.ts",
  "src/app/fields/keypad/NumberKeys.tsx",
  "src/app/base/styles/print.css",
].map(module);

/** The styles of the lathe view, which the start page asks for without the view. */
const LATHE = module("src/app/pictures/lathe/lathe.css");

/** Where the page begins, and the worker that calculates: both in one build, so that neither brings what the other has. */
const HTML = module("index.html"),
  WORKER = module("src/app/calculation/worker.ts");

/** The worker as a part of the page's build; otherwise it would be a build of its own, with a second kernel. */
const sharedWorker: Plugin = {
  name: "shared-worker",
  apply: (_, { command, isSsrBuild }) => command === "build" && !isSsrBuild,
  enforce: "pre",
  transform(code) {
    const wanted = 'new URL("./worker.ts", import.meta.url)';
    if (!code.includes(wanted)) return undefined;
    const emitted = this.emitFile({ type: "chunk", id: WORKER, name: "worker" });
    return code.replace(wanted, `import.meta.ROLLUP_FILE_URL_${emitted}`);
  },
  generateBundle(_, bundle) {
    const seen = new Set<string>();
    const check = (file: string): void => {
      const part = bundle[file];
      if (seen.has(file) || part?.type !== "chunk") return;
      seen.add(file);
      const drawing = part.moduleIds.find((id) => /\.(tsx|css)$|\/react-dom\/|\/three\/build\//.test(id));
      if (drawing) this.error(`${drawing} is in ${file}, which the worker loads, and it has no document`);
      [...part.imports, ...part.dynamicImports].forEach(check);
    };
    for (const [file, part] of Object.entries(bundle))
      if (part.type === "chunk" && part.facadeModuleId === WORKER) check(file);
    if (seen.size === 0) this.error("the worker is not in the build");
  },
};

/** Which file each module of this project is in, for the size check: the manifest does not name what shares a file. */
const whereabouts: Plugin = {
  name: "whereabouts",
  apply: (_, { command, isSsrBuild }) => command === "build" && !isSsrBuild,
  generateBundle(_, bundle) {
    const root = `${this.environment.config.root}/`;
    const files = Object.values(bundle).flatMap((part) =>
      part.type === "chunk" ? part.moduleIds.map((id) => [id.replace(root, "").replace("\0", ""), part.fileName]) : [],
    );
    this.emitFile({ type: "asset", fileName: ".vite/modules.json", source: JSON.stringify(Object.fromEntries(files)) });
  },
};

/** The modules that some cannot start without, however deep; with `later`, also those that they fetch when asked. */
function neededBy(begun: readonly string[], modules: Modules, later = false): ReadonlySet<string> {
  const found = new Set<string>();
  const visit = (id: string): void => {
    if (found.has(id)) return;
    found.add(id);
    const info = modules.getModuleInfo(id);
    info?.importedIds.forEach(visit);
    if (later) info?.dynamicallyImportedIds.forEach(visit);
  };
  begun.forEach(visit);
  return found;
}

/** In an order in which each takes none of the modules that a later one imports. */
const PARTS = ["base", "kernel", "engine", "first", "soon", "lathe", "work"] as const;
type Part = (typeof PARTS)[number];
type Known = Readonly<Record<"page" | "worker" | "workerLater" | "work" | "early", ReadonlySet<string>>>;
let known: Known | null = null;

/**
 * The file that a module belongs to. What the worker needs is in files of its own, by who else does: it must never get
 * what draws.
 */
function partOf(id: string, modules: Modules): Part | null {
  known ??= {
    page: neededBy([HTML], modules),
    worker: neededBy([WORKER], modules),
    workerLater: neededBy([WORKER], modules, true),
    work: neededBy(WORK, modules),
    early: neededBy(EARLY, modules),
  };
  const { page, worker, workerLater, work, early } = known;
  if (id === WORKER || WORK.includes(id)) return null;
  if (workerLater.has(id) && (page.has(id) || early.has(id))) return "base";
  if (workerLater.has(id) && work.has(id)) return "kernel";
  if (worker.has(id)) return "engine";
  if (page.has(id)) return "first";
  if (early.has(id)) return "soon";
  if (id === LATHE) return "lathe";
  if (work.has(id)) return "work";
  return null;
}

const TEXTS = new RegExp(String.raw`/src/i18n/(${LANGUAGES.join("|")})/([\w-]+)\.ts$`);
/** Texts that the start page asks for by itself, with its menu; and those of a dialog or with modules of their own. */
const FIRST = ["", "first", "parts", "course"],
  AWAITED = ["workplace", "tables"];
/** Other texts that are shorter than this in English share one file of their language, bytes of source. */
const SHORT = 3600;

/**
 * What comes together: what the start page says in one language; later a lesson with its tasks, what a learner reads in
 * one language, and its short texts.
 */
function laterPartOf(id: string): string | null {
  const lesson = /\/src\/course\/(?:lessons\/|tasks\/l)(\d\d)-[^/]*\.json$/.exec(id)?.[1];
  if (lesson !== undefined) return `lesson-${lesson}`;
  const [, language, area = ""] = TEXTS.exec(id) ?? /virtual:cycle-menu\/(\w+)$/.exec(id) ?? [];
  if (language !== undefined && FIRST.includes(area)) return `first-${language}`;
  if (language === undefined || AWAITED.includes(area)) return null;
  if (/^course-(?!teach)/.test(area)) return `course-${language}`;
  return statSync(module(`src/i18n/en/${area}.ts`)).size < SHORT ? `texts-${language}` : null;
}

export default defineConfig({
  base: "./",
  plugins: [
    react(),
    sharedWorker,
    whereabouts,
    policyOfPage,
    pageStyles,
    cycleMenu,
    startPictures,
    courseIndex,
    gallery,
    besides,
    offline(),
  ],
  worker: { format: "es" },
  build: {
    target: "es2023",
    sourcemap: false,
    manifest: true,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 900,
    // The worker has no document to preload into, and fetches the readers of drawings too.
    modulePreload: {
      resolveDependencies: (file, parts, { hostId }) => (/\/worker-/.test(hostId) || /\/read-/.test(file) ? [] : parts),
    },
    // All that the start page waits for is one file: one request, and 2 kB less than the same in nine. So is what a
    // dialog waits for.
    rolldownOptions: {
      output: {
        codeSplitting: {
          groups: [
            ...PARTS.map((part, i) => ({
              name: (id: string, modules: Modules) => (partOf(id, modules) === part ? part : null),
              debugName: part,
              priority: PARTS.length - i,
            })),
            // Shared by all texts of a language: not a part of any of them.
            { name: "typography", test: /\/i18n\/\w+\/typography\//, priority: 0.5 },
            { name: laterPartOf, debugName: "later", priority: 0 },
          ],
        },
      },
    },
  },
  server: { host: "127.0.0.1", port: 5173 },
  preview: { host: "127.0.0.1", port: 4173 },
  test: {
    sequence: { shuffle: { files: false, tests: true }, seed, sequencer: LongestFirst },
    // All cores: one is left free otherwise, which of two is half.
    maxWorkers: availableParallelism(),
    // For what never ends; a slow machine may take long.
    testTimeout: 600_000,
    hookTimeout: 600_000,
    projects: [
      {
        extends: true,
        test: {
          name: "pure",
          environment: "node",
          // No fresh process for each file, a third less work: a test leaves what it found.
          isolate: false,
          // Geometry makes many short-lived points: with more room for new objects, MB, the laws take 6 % less.
          execArgv: ["--max-semi-space-size=64"],
          globalSetup: "./tests/announce.ts",
          setupFiles: ["./tests/seed.ts"],
          exclude: [...exclude, ...REPLACING],
          include: ["src/**/*.test.ts", "tests/**/*.test.ts"],
        },
      },
      {
        extends: true,
        test: {
          name: "replacing",
          // A thread starts in less time than a process, and is as fresh.
          pool: "threads",
          environment: "node",
          setupFiles: ["./tests/seed.ts"],
          exclude,
          include: [...REPLACING],
        },
      },
      {
        extends: true,
        test: {
          name: "jsdom",
          // Threads that keep jsdom itself between files: half the work of loading it for each.
          pool: "vmThreads",
          environment: "jsdom",
          setupFiles: ["./tests/seed.ts", "./tests/jsdom.ts"],
          exclude,
          include: ["src/**/*.test.tsx"],
        },
      },
    ],
  },
});

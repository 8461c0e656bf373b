import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, sep } from "node:path";
import { build, type Plugin, type Rolldown } from "vite";
import { page as de } from "../src/i18n/de/page.ts";
import { page as en } from "../src/i18n/en/page.ts";
import { page as fr } from "../src/i18n/fr/page.ts";
import type { Language } from "../src/i18n/languages.ts";
import { page as zh } from "../src/i18n/zh/page.ts";

/** A file of the site as workbox takes it: `revision` is null where the name itself changes with what is in it. */
export interface KeptFile {
  readonly url: string;
  readonly revision: string | null;
  readonly integrity: string;
}

/** Scripts of Fontsource that no screen language and no name in western Europe needs; the system's own font stands in for them. */
const SPARE_FONT = /-(?:cyrillic|cyrillic-ext|greek-ext|vietnamese)-wght-/;

/** True for a file of the build that the page can ask for; what is run by Node, maps and packed copies stay with the server. */
export const isKept = (path: string): boolean =>
  /\.(?:html|js|css|svg|png|woff2|webmanifest)$/.test(path) && path !== "sw.js" && !/(?:^|\/)\./.test(path) && !SPARE_FONT.test(path);

/** The site in a folder as a list that tells every change of every file. */
export function keptFiles(folder: string): readonly KeptFile[] {
  const paths = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((e) => e.isFile()).map((e) =>
    join(e.parentPath, e.name).slice(folder.length + 1).split(sep).join("/")
  );
  return paths.filter(isKept).sort().map((url) => {
    const content = readFileSync(join(folder, url));
    const hash = createHash("sha384").update(content).digest("base64");
    return { url, revision: url.startsWith("assets/") ? null : hash.slice(0, 16), integrity: `sha384-${hash}` };
  });
}

/** The value of a colour of the light page. */
const colour = (name: string): string =>
  new RegExp(`--${name}: (#[0-9a-f]{6});`).exec(readFileSync(join("src", "app", "base", "styles", "tokens.css"), "utf8"))?.[1] ?? "";

const icon = (name: string, size: number, purpose: "any" | "maskable") => ({
  src: `icons/${name}-${size}.png`,
  sizes: `${size}x${size}`,
  type: "image/png",
  purpose,
});

/** What a home screen is told; every address in it is relative, so that the site may lie in any folder. */
export function webManifest(language: Language): object {
  const t = { en, de, fr, zh }[language];
  const way = (name: string, address: string) => ({ name, url: `./#/${address}`, icons: [icon("icon", 192, "any")] });
  return {
    id: "./",
    start_url: "./",
    scope: "./",
    lang: language,
    dir: "ltr",
    name: t.product,
    short_name: t.product,
    description: t.promise,
    display: "standalone",
    theme_color: colour("page"),
    background_color: colour("page"),
    categories: ["productivity", "utilities", "education"],
    icons: [
      { src: "icon.svg", sizes: "any", type: "image/svg+xml", purpose: "any" },
      icon("icon", 192, "any"),
      icon("icon", 512, "any"),
      icon("maskable", 192, "maskable"),
      icon("maskable", 512, "maskable"),
    ],
    shortcuts: [way(t.newProgram, "new"), way(t.start.which, "which"), way(t.tools.title, "tools")],
  };
}

/** The name of the manifest in a language. */
const manifestName = (language: Language): string => `manifest.${language}.webmanifest`;
const LANGUAGES: readonly Language[] = ["en", "de", "fr", "zh"];

/** The service worker as one script that holds the list of the site. */
async function serviceWorker(root: string, files: readonly KeptFile[]): Promise<string> {
  const made = await build({
    root,
    configFile: false,
    logLevel: "error",
    publicDir: false,
    define: { "process.env.NODE_ENV": JSON.stringify("production"), KEPT_FILES: JSON.stringify(files) },
    build: {
      write: false,
      target: "es2023",
      modulePreload: false,
      rolldownOptions: {
        input: join(root, "src", "features", "offline", "service-worker.ts"),
        output: { format: "iife", entryFileNames: "sw.js", codeSplitting: false },
      },
    },
  });
  const [{ output }] = (Array.isArray(made) ? made : [made]) as [Rolldown.RolldownOutput];
  return output[0].code;
}

/**
 * Makes the site installable and complete without a network: manifests, their link in the page, and the service worker with the list of
 * everything that the build wrote. The list is made last, of the files as they lie there.
 */
export function offline(): Plugin {
  let root = "";
  let folder = "";
  return {
    name: "offline",
    apply: (_, { command, isSsrBuild }) => command === "build" && !isSsrBuild,
    configResolved(config) {
      root = config.root;
      folder = join(config.root, config.build.outDir);
    },
    transformIndexHtml: () => [{ tag: "link", attrs: { rel: "manifest", href: `./${manifestName("en")}` }, injectTo: "head" }, {
      tag: "link",
      attrs: { rel: "apple-touch-icon", href: "./icons/apple-touch-icon.png" },
      injectTo: "head",
    }],
    generateBundle() {
      // The server in one file, for those who have nothing but the folder.
      this.emitFile({ type: "asset", fileName: "serve.mjs", source: readFileSync(join(root, "scripts", "serve.mjs"), "utf8") });
      for (const language of LANGUAGES) {
        const source = JSON.stringify(webManifest(language), null, 1);
        this.emitFile({ type: "asset", fileName: manifestName(language), source });
      }
    },
    closeBundle: {
      order: "post",
      sequential: true,
      async handler() {
        writeFileSync(join(folder, "sw.js"), await serviceWorker(root, keptFiles(folder)));
      },
    },
  };
}

import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, resolve, sep } from "node:path";
import { build, runnerImport, type Plugin, type Rolldown } from "vite";

/** A file of the site for workbox: `revision` is null where the file name contains a hash of the content. */
export interface KeptFile {
  readonly url: string;
  readonly revision: string | null;
  readonly integrity: string;
}

/**
 * True for a file of the build that the page can request; Node scripts, maps and compressed copies stay on the server.
 */
export const isKept = (path: string): boolean =>
  /\.(?:html|js|css|svg|png|woff2|webmanifest)$/.test(path) && path !== "sw.js" && !/(?:^|\/)\./.test(path);

/** The files of the site in a folder, each with a revision for its content. */
export function keptFiles(folder: string): readonly KeptFile[] {
  const paths = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((e) => e.isFile())
    .map((e) =>
      join(e.parentPath, e.name)
        .slice(folder.length + 1)
        .split(sep)
        .join("/"),
    );
  return paths
    .filter(isKept)
    .sort()
    .map((url) => {
      const content = readFileSync(join(folder, url));
      const hash = createHash("sha384").update(content).digest("base64");
      return { url, revision: url.startsWith("assets/") ? null : hash.slice(0, 16), integrity: `sha384-${hash}` };
    });
}

/** The service worker as one script that contains the list of the site. */
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
 * Makes the site installable and complete without a network: manifests, their link in the page, and the service worker
 * with the list of all built files. The list is made last, from the written files.
 */
export function offline(): Plugin {
  let root = "";
  let folder = "";
  return {
    name: "offline",
    apply: (_, { command, isSsrBuild }) => command === "build" && !isSsrBuild,
    configResolved(config) {
      root = config.root;
      folder = resolve(config.root, config.build.outDir);
    },
    transformIndexHtml: () => [
      { tag: "link", attrs: { rel: "manifest", href: "./manifest.en.webmanifest" }, injectTo: "head" },
      {
        tag: "link",
        attrs: { rel: "apple-touch-icon", href: "./icons/apple-touch-icon.png" },
        injectTo: "head",
      },
    ],
    async generateBundle() {
      // The server in one file, for users who have only the folder.
      this.emitFile({
        type: "asset",
        fileName: "serve.mjs",
        source: readFileSync(join(root, "scripts", "serve.mjs"), "utf8"),
      });
      const from = join(root, "scripts", "web-manifest.ts");
      const { module } = await runnerImport<{ manifests: () => Readonly<Record<string, string>> }>(from, {
        configFile: false,
        logLevel: "error",
      });
      for (const [fileName, source] of Object.entries(module.manifests()))
        this.emitFile({ type: "asset", fileName, source });
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

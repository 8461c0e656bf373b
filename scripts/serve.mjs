#!/usr/bin/env node
/**
 * Serves the built page with nothing but Node: `node serve.mjs [--port 8080] [--host 127.0.0.1] [--under /turnwise/]
 * [--cert FILE --key FILE] [FOLDER]`. The build puts a copy beside the page, which serves its own folder.
 * docs/serving.md lists the headers of each file for other servers.
 */
import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { readFile, realpath, stat } from "node:fs/promises";
import { createServer } from "node:http";
import { createServer as createSecureServer } from "node:https";
import { dirname, extname, join, sep } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { promisify } from "node:util";
import { brotliCompress, gzip } from "node:zlib";

/**
 * Sources that the page may load: only its own files. No script and no style within the page runs. The page contains
 * the same policy.
 */
export const contentPolicy = [
  "default-src 'none'",
  "script-src 'self'",
  "worker-src 'self'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "font-src 'self'",
  "connect-src 'self'",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

/** Sent with every file. Only a header can say who may show the page in a frame. */
export const securityHeaders = {
  "Content-Security-Policy": `${contentPolicy}; frame-ancestors 'self'`,
  "X-Content-Type-Options": "nosniff",
  "Referrer-Policy": "no-referrer",
  "Permissions-Policy":
    "camera=(), microphone=(), geolocation=(), payment=(), usb=(), serial=(), hid=(), midi=(), " +
    "clipboard-read=(self), clipboard-write=(self), fullscreen=(self)",
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Resource-Policy": "same-origin",
};

/** Files in assets/ have a hash in their name; all others are revalidated each time. */
export const cacheRules = { assets: "public, max-age=31536000, immutable", others: "no-cache" };

/** Content types by file extension. */
export const types = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".jpg": "image/jpeg",
  ".woff2": "font/woff2",
  ".webmanifest": "application/manifest+json",
  ".json": "application/json",
  ".txt": "text/plain; charset=utf-8",
};
const PACKED = new Set([".html", ".js", ".mjs", ".css", ".svg", ".webmanifest", ".json", ".txt"]);

const packers = {
  br: promisify(brotliCompress),
  gzip: (content) => promisify(gzip)(content, { level: 9 }),
};

/** The best compression that a browser accepts. */
function packingFor(accepted = "") {
  const wanted = accepted
    .split(",")
    .map((each) => each.split(/;\s*q=/).map((part) => part.trim()))
    .filter(([, q = "1"]) => Number(q) > 0)
    .map(([name]) => name);
  return Object.keys(packers).find((name) => wanted.includes(name)) ?? null;
}

/** The file for a path, or null: nothing outside the folder and nothing hidden is ever served, in any spelling. */
async function fileOf(root, path) {
  let name;
  try {
    name = decodeURIComponent(path);
  } catch {
    return null;
  }
  const parts = name.split("/").filter((part) => part !== "");
  if (/[\\\0:]/.test(name) || parts.some((part) => part.startsWith("."))) return null;
  try {
    const found = await realpath(join(root, ...parts, name.endsWith("/") || name === "" ? "index.html" : ""));
    const about = await stat(found);
    return found.startsWith(root + sep) && about.isFile() ? { found, version: `${about.size}-${about.mtimeMs}` } : null;
  } catch {
    return null;
  }
}

/** Answers requests for the files of a folder, below a path that begins and ends with a slash. */
export function site(folder, under = "/") {
  const packed = new Map();

  /** The content of a file as sent, and its ETag; made once for all who ask at the same time. */
  function contentOf({ found, version }, packing) {
    const key = `${packing} ${found}`;
    const known = packed.get(key);
    if (known?.version === version) return known.made;
    const made = readFile(found).then(async (content) => ({
      body: packing ? await packers[packing](content) : content,
      mark: `"${createHash("sha256").update(content).digest("base64url").slice(0, 22)}${packing ? `-${packing}` : ""}"`,
    }));
    packed.set(key, { version, made });
    made.catch(() => packed.delete(key));
    return made;
  }

  return async function answer(request, response) {
    const end = (status, headers = {}, body = undefined) => {
      response.writeHead(status, { ...securityHeaders, ...headers });
      response.end(request.method === "HEAD" ? undefined : body);
    };
    const plain = { "Content-Type": types[".txt"], "Cache-Control": cacheRules.others };
    if (request.method !== "GET" && request.method !== "HEAD")
      return end(405, { ...plain, Allow: "GET, HEAD" }, "Only GET and HEAD.\n");
    const [path = "/", query] = (request.url ?? "/").split("?");
    if ((path === "/" && under !== "/") || `${path}/` === under)
      return end(307, { ...plain, Location: query === undefined ? under : `${under}?${query}` });
    const file = path.startsWith(under) ? await fileOf(await realpath(folder), path.slice(under.length)) : null;
    if (!file) return end(404, plain, "There is no such file.\n");
    const ending = extname(file.found).toLowerCase();
    const { body, mark } = await contentOf(
      file,
      PACKED.has(ending) ? packingFor(request.headers["accept-encoding"]) : null,
    );
    const packing = /-(br|gzip)"$/.exec(mark)?.[1];
    const headers = {
      "Content-Type": types[ending] ?? "application/octet-stream",
      "Cache-Control": path.startsWith(`${under}assets/`) ? cacheRules.assets : cacheRules.others,
      ETag: mark,
      ...(PACKED.has(ending) && { Vary: "Accept-Encoding" }),
    };
    if (request.headers["if-none-match"]?.split(",").some((each) => each.trim() === mark)) return end(304, headers);
    end(200, { ...headers, "Content-Length": body.length, ...(packing && { "Content-Encoding": packing }) }, body);
  };
}

/** A path with a slash at both ends. */
export const wholePath = (path) =>
  `/${path
    .split("/")
    .filter((part) => part !== "")
    .join("/")}/`.replace("//", "/");

function main(args) {
  const asked = { port: "8080", host: "127.0.0.1", under: "/", cert: "", key: "" };
  let folder = null;
  for (let i = 0; i < args.length; i += 1) {
    const name = args[i].replace(/^--/, "");
    if (!args[i].startsWith("--")) folder = args[i];
    else if (name in asked && args[i + 1] !== undefined) asked[name] = args[++i];
    else
      throw new Error(
        `${args[i]} is not understood. Known: ${Object.keys(asked)
          .map((known) => `--${known} …`)
          .join(" ")} FOLDER`,
      );
  }
  const beside = dirname(fileURLToPath(import.meta.url));
  const root = folder ?? (existsSync(join(beside, "index.html")) ? beside : join(beside, "..", "dist"));
  if (!existsSync(join(root, "index.html")))
    throw new Error(`There is no index.html in ${root}: build first, or name the folder.`);
  const under = wholePath(asked.under);
  const isSecure = asked.cert !== "" && asked.key !== "";
  const answer = site(root, under);
  const listener = (request, response) =>
    void answer(request, response).catch((error) => {
      console.error(error);
      response.destroy();
    });
  const server = isSecure
    ? createSecureServer({ cert: readFileSync(asked.cert), key: readFileSync(asked.key) }, listener)
    : createServer(listener);
  server.on("error", (error) => {
    console.error(error.message);
    process.exitCode = 1;
  });
  server.listen(Number(asked.port), asked.host, () => {
    const host = asked.host.includes(":") ? `[${asked.host}]` : asked.host;
    console.log(`Turnwise: ${isSecure ? "https" : "http"}://${host}:${server.address().port}${under}`);
  });
  for (const signal of ["SIGINT", "SIGTERM"]) process.on(signal, () => process.exit(0));
}

if (process.argv[1] && import.meta.url === pathToFileURL(await realpath(process.argv[1])).href) {
  try {
    main(process.argv.slice(2));
  } catch (error) {
    console.error(error.message);
    process.exitCode = 2;
  }
}

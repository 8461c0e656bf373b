import { spawn, spawnSync, type ChildProcess } from "node:child_process";
import { chmodSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { connect, createServer, type AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { cacheRules, securityHeaders } from "../scripts/serve.mjs";
import { projectFile, projectPath } from "./sources.ts";

/*
 * The recipes of docs/serving.md are run as they are written, each by its server on a port of this machine, with the
 * site under /turnwise/. A server that is not installed is skipped.
 */

const SCRIPT = `export const n = ${"0.37 + ".repeat(400)}1;`;
const recipe = (name: string) =>
  new RegExp(`\`\`\`${name}\\n([\\s\\S]*?)\`\`\``).exec(projectFile("docs/serving.md"))?.[1] ?? "";

let folder = "";
const site = () => join(folder, "turnwise", "dist");
const put = (path: string, text: string) => writeFileSync(join(site(), path), text);
const asWritten = (text: string) => text.replaceAll("/srv/turnwise", join(folder, "turnwise"));
const config = (name: string, text: string) => {
  writeFileSync(join(folder, name), text);
  return join(folder, name);
};
const isRoot = process.getuid?.() === 0;

/** Modules of Apache where Debian and its relatives have them. */
const APACHE = "/usr/lib/apache2/modules";

/** A command that serves the site in the foreground, with the recipe as its configuration. */
const SERVERS: Readonly<
  Record<
    string,
    { readonly binary: string; readonly needs: readonly string[]; readonly start: (port: number) => readonly string[] }
  >
> = {
  "serve.mjs": {
    binary: process.execPath,
    needs: [],
    start: (port) => [projectPath("scripts/serve.mjs"), "--port", String(port), "--under", "turnwise", site()],
  },
  nginx: {
    binary: "nginx",
    needs: ["/etc/nginx/mime.types"],
    start(port) {
      const [inHttp = "", inServer = ""] = asWritten(recipe("nginx")).split("# In the server block.");
      const paths = ["client_body", "proxy", "fastcgi", "uwsgi", "scgi"].map(
        (k) => `${k}_temp_path ${folder}/tmp-${k};`,
      );
      const main = `${isRoot ? "user root;" : ""} pid ${folder}/nginx.pid; error_log ${folder}/nginx.log; events {}`;
      const http = `include /etc/nginx/mime.types; access_log off; ${paths.join(" ")}\n${inHttp}`;
      const file = config("nginx.conf", `${main}\nhttp { ${http} server { listen 127.0.0.1:${port}; ${inServer} } }`);
      return ["-p", folder, "-c", file, "-g", "daemon off;"];
    },
  },
  apache: {
    binary: "apache2",
    needs: [`${APACHE}/mod_headers.so`, `${APACHE}/mod_mpm_event.so`, "/etc/mime.types"],
    start(port) {
      put(".htaccess", recipe("apache"));
      const modules = ["mpm_event", "authz_core", "alias", "dir", "mime", "filter", "deflate", "headers"].map(
        (name) => `LoadModule ${name}_module ${APACHE}/mod_${name}.so`,
      );
      const file = config(
        "apache.conf",
        [
          ...modules,
          ...(isRoot ? ["User www-data", "Group www-data"] : []),
          `ServerRoot ${folder}\nServerName 127.0.0.1\nListen 127.0.0.1:${port}\nDefaultRuntimeDir ${folder}`,
          `PidFile ${folder}/apache.pid\nErrorLog ${folder}/apache.log\nTypesConfig /etc/mime.types`,
          `Alias /turnwise ${site()}\n<Directory ${site()}>\nAllowOverride All\nRequire all granted\nDirectoryIndex index.html\n</Directory>`,
          "",
        ].join("\n"),
      );
      return ["-f", file, "-DFOREGROUND"];
    },
  },
  caddy: {
    binary: "caddy",
    needs: [],
    start(port) {
      const text = asWritten(recipe("caddy")).replace("example.shop {", `http://127.0.0.1:${port} {`);
      return ["run", "--adapter", "caddyfile", "--config", config("Caddyfile", `{\nadmin off\n}\n${text}`)];
    },
  },
};

const isInstalled = (binary: string, needs: readonly string[]) =>
  spawnSync(binary, ["-v"], { stdio: "ignore" }).error === undefined && needs.every((path) => existsSync(path));

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "turnwise-recipes-"));
  chmodSync(folder, 0o755);
  for (const made of ["assets", ".vite"]) mkdirSync(join(site(), made), { recursive: true });
  put("index.html", "<!doctype html><p>the page</p>");
  put("sw.js", "self.n = 1;");
  put("verify.mjs", "export {};");
  put("manifest.en.webmanifest", "{}");
  put("assets/part-Zk3.js", SCRIPT);
  put("assets/font-a.woff2", "no font");
  put(".vite/manifest.json", "hidden");
  writeFileSync(join(folder, "turnwise", "secret.txt"), "secret");
  writeFileSync(join(folder, "turnwise", "dist-secret.txt"), "secret");
});
afterAll(() => rmSync(folder, { recursive: true }));

interface Answer {
  readonly status: number;
  readonly headers: Headers;
  readonly text: string;
}

/** A request as spelled, through a plain socket: clients tidy paths up. */
function ask(port: number, path: string, headers: Readonly<Record<string, string>> = {}): Promise<Answer> {
  return new Promise((done, fail) => {
    const parts: Buffer[] = [];
    const socket = connect(port, "127.0.0.1", () => {
      const more = Object.entries(headers).map(([name, value]) => `${name}: ${value}\r\n`);
      socket.write(`GET ${path} HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nConnection: close\r\n${more.join("")}\r\n`);
    });
    socket.on("data", (part) => parts.push(part)).on("error", fail);
    socket.on("close", () => {
      const [head = "", ...rest] = Buffer.concat(parts).toString("latin1").split("\r\n\r\n");
      const [first = "", ...lines] = head.split("\r\n");
      const found = new Headers(lines.map((line) => /^([^:]+): *(.*)$/.exec(line)?.slice(1, 3) as [string, string]));
      done({ status: Number(first.split(" ")[1]), headers: found, text: rest.join("\r\n\r\n") });
    });
  });
}

const freePort = () =>
  new Promise<number>((done) => {
    const asked = createServer().listen(0, "127.0.0.1", () => {
      const { port } = asked.address() as AddressInfo;
      asked.close(() => done(port));
    });
  });
const PAUSE = 50;

const all = Object.entries(SERVERS).map(([name, { binary, needs, start }]) => {
  const missing = !isInstalled(binary, needs);
  return [missing ? `${name} is not installed: its recipe is not run` : name, { binary, start, missing }] as const;
});

describe.each(all)("%s", (name, { binary, start, missing }) => {
  let server: ChildProcess | null = null;
  let port = 0;
  beforeAll(async () => {
    if (missing) return;
    port = await freePort();
    let said = "";
    const env = { ...process.env, HOME: folder, XDG_DATA_HOME: folder, XDG_CONFIG_HOME: folder };
    server = spawn(binary, start(port), { env, stdio: ["ignore", "pipe", "pipe"] });
    server.stderr?.on("data", (part: Buffer) => (said += part.toString()));
    for (;;) {
      if (server.exitCode !== null) throw new Error(`${name} has ended: ${said}`);
      if (
        await ask(port, "/turnwise/").then(
          () => true,
          () => false,
        )
      )
        return;
      await new Promise((done) => setTimeout(done, PAUSE));
    }
  });
  afterAll(async () => {
    const ended = new Promise((done) => (server && server.exitCode === null ? server.once("exit", done) : done(null)));
    server?.kill("SIGTERM");
    await ended;
  });

  test.skipIf(missing)("every file comes with its type, its cache rule and all headers", async () => {
    for (const [path, type, rule] of [
      ["", "text/html", cacheRules.others],
      ["index.html", "text/html", cacheRules.others],
      ["sw.js", "text/javascript", cacheRules.others],
      ["verify.mjs", "text/javascript", cacheRules.others],
      ["manifest.en.webmanifest", "application/manifest+json", cacheRules.others],
      ["assets/part-Zk3.js", "text/javascript", cacheRules.assets],
      ["assets/font-a.woff2", "font/woff2", cacheRules.assets],
    ] as const) {
      const { status, headers } = await ask(port, `/turnwise/${path}`);
      expect([
        path,
        status,
        headers.get("content-type")?.split(";")[0]?.replace("application/java", "text/java"),
        headers.get("cache-control"),
      ]).toEqual([path, 200, type, rule]);
      for (const [header, value] of Object.entries(securityHeaders))
        expect([path, headers.get(header)]).toEqual([path, value]);
    }
    expect((await ask(port, "/turnwise/?clock=manual")).text).toContain("the page");
    expect((await ask(port, "/turnwise")).headers.get("location")).toMatch(/\/turnwise\/$/);
  });

  test.skipIf(missing)(
    "texts are compressed, a changed file comes at once, an unchanged one is not sent again",
    async () => {
      const gzip = await ask(port, "/turnwise/assets/part-Zk3.js", { "Accept-Encoding": "gzip" });
      expect([gzip.headers.get("content-encoding"), gzip.text.length < SCRIPT.length / 3]).toEqual(["gzip", true]);
      for (const path of ["sw.js", "index.html"]) {
        const etag = (await ask(port, `/turnwise/${path}`)).headers.get("etag") ?? "";
        expect((await ask(port, `/turnwise/${path}`, { "If-None-Match": etag })).status).toBe(304);
        put(path, `newer than before: ${name}, ${path}`);
        const newer = await ask(port, `/turnwise/${path}`, { "If-None-Match": etag });
        expect([newer.status, newer.text.includes("newer than before"), newer.headers.get("cache-control")]).toEqual([
          200,
          true,
          cacheRules.others,
        ]);
        put(path, "<p>the page</p>");
      }
    },
  );

  test.skipIf(missing)("a missing file is 404, never the page, and is asked for again", async () => {
    for (const path of [
      "nowhere",
      "assets/part-old.js",
      "assets",
      "assets/",
      ".vite/manifest.json",
      ".htaccess",
      "a/.git/config",
    ]) {
      const { status, headers, text } = await ask(port, `/turnwise/${path}`);
      const isFolder = path === "assets" && status >= 300 && status < 400;
      expect([
        path,
        isFolder || status === 404 || status === 403,
        text.includes("the page"),
        text.includes("part-Zk3"),
      ]).toEqual([path, true, false, false]);
      expect([path, headers.get("cache-control")?.includes("immutable") ?? false]).toEqual([path, false]);
      expect([path, headers.get("x-content-type-options")]).toEqual([path, "nosniff"]);
    }
  });

  test.skipIf(missing)("nothing outside its folder is served, in any spelling", async () => {
    for (const path of [
      "/turnwise/../secret.txt",
      "/turnwise/%2e%2e/secret.txt",
      "/turnwise/%2e%2e%2fsecret.txt",
      "/turnwise/..%2fsecret.txt",
      "/turnwise/..%5csecret.txt",
      "/turnwise/..\\secret.txt",
      "/turnwise/%252e%252e%252fsecret.txt",
      "/turnwise/%c0%ae%c0%ae/secret.txt",
      "/turnwise/assets/../../secret.txt",
      "/turnwise/assets/..%2f..%2fsecret.txt",
      "/turnwise../secret.txt",
      "/turnwise/../dist-secret.txt",
      "/turnwise/index.html%00.txt",
      "/turnwise/%E0%A4%A",
      "/turnwise/%",
      "//turnwise/../../secret.txt",
      `http://127.0.0.1:${port}/turnwise/../secret.txt`,
      "file:///etc/passwd",
    ]) {
      const { status, text } = await ask(port, path);
      expect([path, text.includes("secret"), text.includes("root:"), status === 200]).toEqual([
        path,
        false,
        false,
        false,
      ]);
    }
    expect((await ask(port, "/turnwise/")).status).toBe(200);
  });
});

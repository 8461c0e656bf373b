import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createServer, request, type IncomingMessage, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { cacheRules, contentPolicy, securityHeaders, site, types, wholePath } from "../scripts/serve.mjs";
import { projectFile } from "./sources.ts";

const SCRIPT = `export const n = ${"0.37 + ".repeat(90)}1;`;
let folder = "";
let server: Server;
beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "turnwise-served-"));
  const put = (path: string, text: string) => writeFileSync(join(folder, "site", path), text);
  for (const made of ["site/assets", "site/.vite"]) mkdirSync(join(folder, made), { recursive: true });
  put("index.html", "<p>here</p>");
  put("sw.js", "self.n = 1;");
  put("assets/part-Zk3.js", SCRIPT);
  put("assets/font-a.woff2", "no font");
  put(".vite/manifest.json", "{}");
  writeFileSync(join(folder, "secret.txt"), "secret");
  symlinkSync(join(folder, "secret.txt"), join(folder, "site", "way-out.txt"));
  const answer = site(join(folder, "site"), "/shop/");
  server = createServer((asked, response) => void answer(asked, response));
  await new Promise<void>((done) => server.listen(0, "127.0.0.1", done));
});
afterAll(() => {
  server.close();
  rmSync(folder, { recursive: true });
});

/** Requests a path exactly as spelled. */
function ask(
  path: string,
  headers: Record<string, string> = {},
  method = "GET",
): Promise<IncomingMessage & { readonly body: Buffer }> {
  return new Promise((done, fail) => {
    const { port } = server.address() as AddressInfo;
    request({ host: "127.0.0.1", port, path, method, headers }, (response) => {
      const parts: Buffer[] = [];
      response.on("data", (part: Buffer) => parts.push(part));
      response.on("end", () => done(Object.assign(response, { body: Buffer.concat(parts) })));
    })
      .on("error", fail)
      .end();
  });
}

test("a file comes with its type, its rule and every header", async () => {
  for (const [path, type, rule] of [
    ["/shop/", ".html", cacheRules.others],
    ["/shop/?clock=manual", ".html", cacheRules.others],
    ["/shop/sw.js", ".js", cacheRules.others],
    ["/shop/assets/part-Zk3.js", ".js", cacheRules.assets],
    ["/shop/assets/font-a.woff2", ".woff2", cacheRules.assets],
  ] as const) {
    const { statusCode, headers } = await ask(path);
    expect([path, statusCode, headers["content-type"], headers["cache-control"]]).toEqual([
      path,
      200,
      types[type],
      rule,
    ]);
    for (const [name, value] of Object.entries(securityHeaders)) expect(headers[name.toLowerCase()]).toBe(value);
  }
});

test.each([
  "/shop/../secret.txt",
  "/shop/%2e%2e/secret.txt",
  "/shop/..%2fsecret.txt",
  "/shop/..%5csecret.txt",
  "/shop/assets/..%2f..%2fsecret.txt",
  "/shop/way-out.txt",
  "/shop/.vite/manifest.json",
  "/shop/assets",
  "/shop/assets/",
  "/shop/%00",
  "/shop/%E0%A4%A",
  "/secret.txt",
  "/shopping/index.html",
])("%s is not there", async (path) => {
  const { statusCode, headers, body } = await ask(path);
  expect([statusCode, headers["cache-control"]]).toEqual([404, cacheRules.others]);
  expect(body.toString()).not.toContain("secret");
});

test("a request outside the folder is redirected to the page, with its query", async () => {
  expect((await ask("/")).headers.location).toBe("/shop/");
  expect((await ask("/shop?clock=manual")).headers.location).toBe("/shop/?clock=manual");
});

test("texts are compressed as the browser accepts, fonts are not", async () => {
  const path = "/shop/assets/part-Zk3.js";
  const brotli = await ask(path, { "accept-encoding": "gzip, deflate, br;q=0.9" });
  expect([brotli.headers["content-encoding"], brotliDecompressSync(brotli.body).toString()]).toEqual(["br", SCRIPT]);
  const gzip = await ask(path, { "accept-encoding": "gzip, br;q=0" });
  expect([gzip.headers["content-encoding"], gunzipSync(gzip.body).toString()]).toEqual(["gzip", SCRIPT]);
  const plain = await ask(path);
  expect([plain.headers["content-encoding"], plain.body.toString()]).toEqual([undefined, SCRIPT]);
  expect(new Set([brotli, gzip, plain].map(({ headers }) => headers.etag)).size).toBe(3);
  expect((await ask("/shop/assets/font-a.woff2", { "accept-encoding": "br" })).headers["content-encoding"]).toBe(
    undefined,
  );
});

test("an unchanged file is not sent again", async () => {
  const { etag = "" } = (await ask("/shop/sw.js")).headers;
  const again = await ask("/shop/sw.js", { "if-none-match": `"other", ${etag}` });
  expect([again.statusCode, again.body.length]).toEqual([304, 0]);
  writeFileSync(join(folder, "site", "sw.js"), "self.n = 2.75;");
  const changed = await ask("/shop/sw.js", { "if-none-match": etag });
  expect([changed.statusCode, changed.body.toString()]).toEqual([200, "self.n = 2.75;"]);
});

test("only GET and HEAD", async () => {
  expect((await ask("/shop/", {}, "POST")).statusCode).toBe(405);
  const head = await ask("/shop/", {}, "HEAD");
  expect([head.statusCode, head.headers["content-length"], head.body.length]).toEqual([200, "11", 0]);
});

test.each([
  ["", "/"],
  ["/", "/"],
  ["turnwise", "/turnwise/"],
  ["/a/b", "/a/b/"],
  ["//a//", "/a/"],
])("%j is the path %s", (given, path) => expect(wholePath(given)).toBe(path));

describe("docs/serving.md says what the code sends", () => {
  const page = projectFile("docs/serving.md");
  const recipes = [...page.matchAll(/```(nginx|apache|caddy|xml)\n([\s\S]*?)```/g)].map(
    ([, name = "", text = ""]) => [name, text] as const,
  );
  const said = (name: string, value: string): Readonly<Record<string, string>> => ({
    nginx: `add_header ${name} "${value}" always;`,
    apache: `Header always set ${name} "${value}"`,
    caddy: `header ${name} "${value}"`,
    xml: `<add name="${name}" value="${value}" />`,
  });

  test.each(recipes)("%s", (server, text) => {
    for (const [name, value] of Object.entries(securityHeaders)) expect(text).toContain(said(name, value)[server]);
    for (const rule of Object.values(cacheRules)) expect(text).toContain(rule);
    expect(text.match(/-Policy/g)?.length).toBe(
      Object.keys(securityHeaders).filter((name) => name.endsWith("-Policy")).length,
    );
    for (const ending of [".webmanifest", ".mjs", ".woff2"])
      if (server !== "caddy") expect(text).toContain(types[ending]?.split(";")[0]);
  });

  test("for four servers, and in its table", () => {
    expect(recipes.map(([name]) => name)).toEqual(["nginx", "apache", "caddy", "xml"]);
    for (const [name, value] of Object.entries(securityHeaders))
      expect(page).toContain(value.length > 40 ? `| \`${name}\` | see below |` : `| \`${name}\` | \`${value}\` |`);
  });

  test("the page contains the same policy, except directives that only a server can send", () => {
    expect(securityHeaders["Content-Security-Policy"]).toBe(`${contentPolicy}; frame-ancestors 'self'`);
  });
});

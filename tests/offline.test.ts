import { createHash } from "node:crypto";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, expect, test } from "vitest";
import { isKept, keptFiles } from "../scripts/offline.ts";
import { webManifest } from "../scripts/web-manifest.ts";
import { parseAddress } from "../src/app/place/address.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { projectFile, projectPath } from "./sources.ts";

let folder = "";
const put = (path: string, text: string) => {
  mkdirSync(join(folder, path, ".."), { recursive: true });
  writeFileSync(join(folder, path), text);
};
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), "turnwise-site-"));
});
afterEach(() => rmSync(folder, { recursive: true }));

test.each([
  "index.html",
  "gallery.html",
  "manifest.zh.webmanifest",
  "icons/maskable-192.png",
  "assets/worker-DVUzD9Yi.js",
  "assets/inter-latin-ext-wght-normal-x.woff2",
])("%s is kept", (path) => expect(isKept(path)).toBe(true));

test.each([
  "sw.js",
  "verify.mjs",
  "serve.mjs",
  ".vite/manifest.json",
  ".htaccess",
  "assets/.hidden.js",
  "assets/index-x.js.map",
  "assets/index-x.js.br",
])("%s is not kept", (path) => expect(isKept(path)).toBe(false));

test("the list names each file with its content; a changed one is another entry", () => {
  put("index.html", "<p>eins</p>");
  put("assets/part-Zk3.js", "export const n = 0.37;");
  put("verify.mjs", "");
  const before = keptFiles(folder);
  expect(before.map(({ url }) => url)).toEqual(["assets/part-Zk3.js", "index.html"]);
  expect(before[0]).toEqual({
    url: "assets/part-Zk3.js",
    revision: null,
    integrity: `sha384-${createHash("sha384").update("export const n = 0.37;").digest("base64")}`,
  });
  put("index.html", "<p>zwei</p>");
  const [part, page] = keptFiles(folder);
  expect(part).toEqual(before[0]);
  expect(page?.revision).not.toBe(before[1]?.revision);
  expect(before[1]?.integrity).toContain(before[1]?.revision);
});

/** Width and height in the header of a PNG, pixels. */
function pngSize(src: string): readonly [number, number] {
  const png = readFileSync(projectPath(`public/${src}`));
  return [png.readUInt32BE(16), png.readUInt32BE(20)];
}

/** The same in the frame header of a JPEG. */
function jpegSize(src: string): readonly [number, number] {
  const jpeg = readFileSync(projectPath(`public/${src}`));
  let at = 2;
  while (!(jpeg[at + 1] === 0xc0 || jpeg[at + 1] === 0xc2)) at += 2 + jpeg.readUInt16BE(at + 2);
  return [jpeg.readUInt16BE(at + 7), jpeg.readUInt16BE(at + 5)];
}

interface Manifest {
  readonly [name: string]: unknown;
  readonly icons: readonly { readonly src: string; readonly sizes: string }[];
  readonly screenshots: readonly { readonly src: string; readonly sizes: string; readonly form_factor: string }[];
  readonly shortcuts: readonly { readonly name: string; readonly url: string }[];
}

test.each(LANGUAGES)(
  "the manifest in %s leads nowhere but into its own folder, and its pictures are there in the size they say",
  (language) => {
    const manifest = webManifest(language) as unknown as Manifest;
    expect(manifest["lang"]).toBe(language);
    const addresses = [
      manifest["id"],
      manifest["start_url"],
      manifest["scope"],
      ...manifest.shortcuts.map(({ url }) => url),
    ];
    for (const address of addresses) expect(address).toMatch(/^\.\/(?:#\/\w+)?$/);
    for (const { src, sizes } of manifest.icons) {
      expect(existsSync(projectPath(`public/${src}`))).toBe(true);
      if (!src.endsWith(".png")) continue;
      const width = Number(/^(\d+)x\1$/.exec(sizes)?.[1]);
      expect(pngSize(src)).toEqual([width, width]);
    }
    expect(new Set(manifest.shortcuts.map(({ name }) => name)).size).toBe(4);
    // The first is no place but a request: the shell opens its dialog.
    expect(manifest.shortcuts[0]?.url).toBe("./#/new");
    expect(manifest.shortcuts.slice(1).map(({ url }) => parseAddress(url.replace("./", "")))).toEqual([
      expect.objectContaining({ page: "start" }),
      expect.objectContaining({ page: "course", lesson: null }),
      expect.objectContaining({ page: "tools" }),
    ]);
    expect(manifest.screenshots.map(({ form_factor: form }) => form)).toEqual(["wide", "narrow"]);
    for (const { src, sizes } of manifest.screenshots) {
      expect(jpegSize(src).join("x")).toBe(sizes);
      expect(isKept(src)).toBe(false);
    }
  },
);

test("the colours of the browser's own parts are those of the page", () => {
  const tokens = [...projectFile("src/app/base/styles/tokens.css").matchAll(/--page: (#\w+);/g)].map(
    ([, colour]) => colour,
  );
  const page = [...projectFile("index.html").matchAll(/name="theme-color" content="(#\w+)"/g)].map(
    ([, colour]) => colour,
  );
  expect(page).toHaveLength(2);
  expect(page).toEqual([...new Set(tokens)]);
  expect((webManifest("en") as unknown as Manifest)["theme_color"]).toBe(page[0]);
});

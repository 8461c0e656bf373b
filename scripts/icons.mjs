/**
 * `node scripts/icons.mjs`: renders public/icon.svg as the icons of home screens, with the Chromium of the e2e tests.
 * The output in public/icons/ is committed: run the script when the drawing changes.
 */
import { createRequire } from "node:module";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { browserFlags, ensureBrowser } from "./browser.mjs";
import { root } from "./packages.mjs";

const drawing = readFileSync(join(root, "public", "icon.svg"), "utf8");
/** The icon without rounded corners and smaller, for systems that crop it: the middle 80 % is always visible. */
const whole = drawing
  .replace(/ rx="\d+"/, "")
  .replace(
    /(<rect[^>]*\/>)([\s\S]*)(<\/svg>)/,
    (_, ground, inside, end) =>
      `${ground}<g transform="translate(32 32) scale(.72) translate(-32 -32)">${inside}</g>${end}`,
  );

const PICTURES = [
  ["icon-192", 192, drawing],
  ["icon-512", 512, drawing],
  ["maskable-192", 192, whole],
  ["maskable-512", 512, whole],
  ["apple-touch-icon", 180, whole],
];

const folder = join(root, "public", "icons");
mkdirSync(folder, { recursive: true });
const { chromium } = createRequire(join(root, "package.json"))("@playwright/test");
const browser = await chromium.launch({ executablePath: ensureBrowser(), args: browserFlags });
for (const [name, size, svg] of PICTURES) {
  const page = await browser.newPage({ viewport: { width: size, height: size } });
  await page.setContent(`<style>*{margin:0}svg{display:block;width:100vw;height:100vh}</style>${svg}`);
  writeFileSync(join(folder, `${name}.png`), await page.screenshot({ omitBackground: true }));
  await page.close();
}
await browser.close();

/** Finds a Chromium for the end-to-end tests, or installs one. Uses nothing but Node itself. */
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { root } from "./packages.mjs";

const runs = (path) =>
  Boolean(path) && existsSync(path) && spawnSync(path, ["--version"], { stdio: "ignore" }).status === 0;

/** The Chromium that Playwright would download, whether or not it is there. */
function playwrightsOwn() {
  try {
    return createRequire(join(root, "package.json"))("@playwright/test").chromium.executablePath();
  } catch {
    return "";
  }
}

/** Without windows and menus: a journey takes a fifteenth less in it, but its pictures come at other times. */
const SHELL = "/usr/bin/chromium-headless-shell";
const WHOLE = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** Path of a working Chromium: the specified one, Playwright's own, or the system's; null without one. */
export const findBrowser = (system = [...WHOLE, SHELL]) =>
  [process.env.CHROMIUM_PATH, playwrightsOwn(), ...system].find(runs) ?? null;

/** The same for journeys. */
export const findLightBrowser = () => findBrowser([SHELL, ...WHOLE]);

/** Finds or installs a Chromium and returns its path. */
export function ensureBrowser() {
  const found = findLightBrowser();
  if (found) return found;
  const run = (command, args) =>
    spawnSync(command, args, {
      cwd: root,
      stdio: ["ignore", 2, 2],
      env: { ...process.env, DEBIAN_FRONTEND: "noninteractive" },
    }).status === 0;
  console.error("Installing Chromium …");
  if (process.getuid?.() === 0 && existsSync("/usr/bin/apt-get")) {
    const install = (browser) =>
      run("apt-get", ["install", "--no-install-recommends", "-y", browser, "fonts-dejavu-core"]);
    if (run("apt-get", ["update"])) void (install("chromium-headless-shell") || install("chromium"));
  }
  const system = findLightBrowser();
  if (system) return system;
  run(process.execPath, [join(root, "node_modules", "@playwright", "test", "cli.js"), "install", "chromium"]);
  const own = findLightBrowser();
  if (!own) throw new Error("No Chromium could be found or installed; name one in CHROMIUM_PATH.");
  return own;
}

/** `node scripts/browser.mjs` makes sure that there is one. */
if (process.argv[1] === fileURLToPath(import.meta.url)) ensureBrowser();

/**
 * Parts of Chromium that are disabled. The last two are lists below the address bar: each is an invisible page for
 * every open page and takes as much time as that page. The others are those that Playwright disables: Chromium takes
 * only the last of two such lists.
 */
const LEFT_OUT = [
  "AvoidUnnecessaryBeforeUnloadCheckSync",
  "DestroyProfileOnBrowserClose",
  "HttpsUpgrades",
  "HttpsFirstBalancedModeAutoEnable",
  "LensOverlay",
  "MediaRouter",
  "PaintHolding",
  "ThirdPartyStoragePartitioning",
  "AvoidCorsURLLoaderRestartOnRedirect",
  "OptimizationHints",
  "NetworkTimeServiceQuerying",
  "AimEnabled",
  "PreconnectToSearch",
  "WebUIOmniboxPopup",
  "WebUIOmniboxAimPopup",
];

/** Flags for Chromium to run as root, stay off the network and do nothing in the background. */
export const browserFlags = [
  "--no-sandbox",
  `--disable-features=${LEFT_OUT.join(",")}`,
  "--disable-gpu",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

/**
 * Makes sure that the packages of package-lock.json are installed. Runs before anything is installed, so it uses
 * nothing but Node itself.
 */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder of package.json. */
export const root = fileURLToPath(new URL("..", import.meta.url));

const lock = (path) => JSON.parse(readFileSync(join(root, path), "utf8")).packages;

/** True when every package of the lock file is installed in the same version, except binaries of other platforms. */
function installed() {
  const kept = join("node_modules", ".package-lock.json");
  if (!existsSync(join(root, kept))) return false;
  const present = lock(kept);
  return Object.entries(lock("package-lock.json")).every(
    ([name, wanted]) =>
      name === "" || (present[name] ? present[name].version === wanted.version : wanted.optional === true),
  );
}

/**
 * Installs with `npm ci` when node_modules is missing or stale. npm's output goes to standard error, so that standard
 * output stays clean for reports.
 */
export function ensurePackages() {
  const [major, minor] = process.versions.node.split(".").map(Number);
  if (major < 20 || (major === 20 && minor < 19))
    throw new Error(`Node 20.19 or newer is needed, this is ${process.version}.`);
  if (installed()) return;
  console.error("Installing packages (npm ci) …");
  const npm = process.platform === "win32" ? "npm.cmd" : "npm";
  const done = spawnSync(npm, ["ci", "--no-audit", "--no-fund", "--include=dev", "--loglevel=error"], {
    cwd: root,
    stdio: ["ignore", 2, 2],
    shell: process.platform === "win32",
  });
  if (done.status !== 0) throw new Error("npm ci failed.");
}

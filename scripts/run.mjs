/**
 * `node scripts/run.mjs NAME …`: runs scripts/NAME.ts on plain Node. The script is bundled once with all its imports
 * and cached in node_modules/.cache until a source file changes, so that it starts at once. It exports `main(args):
 * exit status`. Only the script's own output goes to standard output.
 */
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, renameSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { ensurePackages, root } from "./packages.mjs";

const [name = "", ...args] = process.argv.slice(2);

/** Every possible source file of a bundle, with its size and time. */
function fingerprint() {
  const hash = createHash("sha256");
  const walk = (folder) => {
    for (const entry of readdirSync(join(root, folder), { withFileTypes: true })) {
      const path = join(folder, entry.name);
      if (entry.isDirectory()) walk(path);
      else if (/\.(tsx?|json)$/.test(entry.name) && !/\.test\.tsx?$/.test(entry.name) && !folder.endsWith("found"))
        note(path);
    }
  };
  const note = (path) => {
    const { size, mtimeMs } = statSync(join(root, path));
    hash.update(`${path} ${size} ${mtimeMs}\n`);
  };
  for (const folder of [
    "src",
    "scripts",
    "tests/laws",
    "tests/planning",
    "tests/better-ways",
    "tests/judge",
    "tests/growth",
    "e2e/pages",
  ])
    walk(folder);
  for (const file of ["package.json", "package-lock.json", "scripts/run.mjs", "scripts/bundle.mjs"]) note(file);
  return hash.digest("hex").slice(0, 16);
}

async function bundled() {
  const cache = join(root, "node_modules", ".cache", "turnwise");
  const path = join(cache, `${name}-${fingerprint()}.mjs`);
  if (existsSync(path)) return path;
  mkdirSync(cache, { recursive: true });
  for (const old of readdirSync(cache)) {
    const stale = old.startsWith(`${name}-`) && Date.now() - statSync(join(cache, old)).mtimeMs > 3_600_000;
    if (stale) rmSync(join(cache, old), { recursive: true, force: true });
  }
  const { bundle } = await import("./bundle.mjs");
  const fresh = join(cache, `${name}-building-${process.pid}.mjs`);
  writeFileSync(fresh, await bundle(name));
  renameSync(fresh, path);
  return path;
}

try {
  ensurePackages();
  const { main } = await import(pathToFileURL(await bundled()).href);
  // npm runs scripts in the project folder; file names are relative to the folder of the caller.
  if (["verify", "contour", "plan"].includes(name) && process.env.INIT_CWD) process.chdir(process.env.INIT_CWD);
  process.exitCode = await main(args);
} catch (error) {
  console.error(`${name}: ${error instanceof Error ? error.message : String(error)}`);
  process.exitCode = 2;
}

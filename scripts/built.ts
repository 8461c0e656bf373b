import { spawnSync } from "node:child_process";
import { existsSync, readdirSync, statSync } from "node:fs";
import { join } from "node:path";

/** The newest modification time in a folder, or of a file. */
function newest(path: string): number {
  const about = statSync(path);
  if (!about.isDirectory()) return about.mtimeMs;
  return Math.max(0, ...readdirSync(path).map((name) => newest(join(path, name))));
}

const SOURCES = [
  "src",
  "public",
  "index.html",
  "package-lock.json",
  "vite.config.ts",
  "scripts/start-pictures.ts",
  "scripts/menu.ts",
];

/** The folder of the built page, rebuilt first if it is older than its sources. */
export function built(): string {
  const page = "dist/index.html";
  if (!existsSync(page) || statSync(page).mtimeMs < Math.max(...SOURCES.map(newest))) {
    console.error("The built page is older than its sources: building …");
    const { status } = spawnSync(process.execPath, ["node_modules/vite/bin/vite.js", "build", "--logLevel", "warn"], {
      stdio: ["ignore", 2, 2],
    });
    if (status !== 0) throw new Error("the build failed");
  }
  return "dist";
}

/**
 * `npm run monkey -- --presses=3000 --seed=7`: random presses over all screens of the built page (e2e/monkey.spec.ts),
 * with what they find as it happens. Without a seed it takes another one each time, and says which.
 */
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { ensureBrowser } from "./browser.mjs";
import { root } from "./packages.mjs";

const asked = (name, otherwise) =>
  process.argv.map((each) => new RegExp(`^--${name}=(\\d+)$`).exec(each)?.[1]).find(Boolean) ?? String(otherwise);
const MONKEY_PRESSES = asked("presses", 3000);
const MONKEY_SEED = asked("seed", Math.floor(Math.random() * 1e6));
console.log(`${MONKEY_PRESSES} presses, seed ${MONKEY_SEED}`);
const { status } = spawnSync(
  process.execPath,
  [join(root, "node_modules", "@playwright", "test", "cli.js"), "test", "monkey", "--project=desktop"],
  { cwd: root, stdio: "inherit", env: { ...process.env, CHROMIUM_PATH: ensureBrowser(), MONKEY_PRESSES, MONKEY_SEED } },
);
process.exitCode = status ?? 1;

/** `npm start`: installs what is missing, then serves the app and prints its address. */
import { spawn } from "node:child_process";
import { join } from "node:path";
import { ensurePackages, root } from "./packages.mjs";

ensurePackages();
const server = spawn(
  process.execPath,
  [join(root, "node_modules", "vite", "bin", "vite.js"), ...process.argv.slice(2)],
  {
    cwd: root,
    stdio: [process.stdin.isTTY ? "inherit" : "ignore", "inherit", "inherit"],
  },
);
for (const signal of ["SIGINT", "SIGTERM"]) process.on(signal, () => server.kill(signal));
server.on("exit", (code, signal) => process.exit(signal ? 0 : (code ?? 1)));

import { main } from "./verify.ts";

/** `verify` as a program of its own: the build makes dist/verify.mjs of this file and of all it imports. */
try {
  process.exitCode = main(process.argv.slice(2), "node verify.mjs");
} catch (error) {
  process.stderr.write(`verify: ${error instanceof Error ? error.message : String(error)}\n`);
  process.exitCode = 2;
}

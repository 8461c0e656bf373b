import { accessSync, constants, readFileSync, statSync } from "node:fs";
import { setFlagsFromString } from "node:v8";
import { parse } from "../src/nc/parse.ts";
import { print } from "../src/nc/program.ts";
import type { Control } from "../src/program/plane-types.ts";
import { over, readTools, type ShopTools } from "../src/program/read-tools.ts";
import { run } from "../src/program/run.ts";
import { shippedTools } from "../src/program/shipped-tools.ts";
import { hasErrors, report, type Report } from "../src/report/report.ts";
import { summary } from "../src/report/summary.ts";
import { simulate } from "../src/sim/simulate.ts";

/** Rapid rate of the times, mm/min. */
const RAPID = 10_000;

/** A command line that can not be carried out; its message is the one line on standard error. */
class Refusal extends Error {}

interface Command {
  readonly files: readonly string[];
  readonly tools: string | null;
  readonly json: boolean;
  readonly print: boolean;
  readonly control: Control;
}

const CONTROLS: Readonly<Record<string, Control>> = { tnc640: "TNC 640", tnc7: "TNC7" };

function command(args: readonly string[]): Command {
  const files: string[] = [];
  let [tools, json, printing]: [string | null, boolean, boolean] = [null, false, false];
  let control: Control = "TNC 640";
  for (let i = 0; i < args.length; i += 1) {
    const arg = args[i] ?? "";
    if (arg === "--json") json = true;
    else if (arg === "--print") printing = true;
    else if (arg === "--tools") {
      tools = args[i += 1] ?? null;
      if (tools === null) throw new Refusal("--tools needs a file");
    } else if (arg === "--control") {
      const named = CONTROLS[args[i += 1]?.toLowerCase() ?? ""];
      if (!named) throw new Refusal(`--control needs one of ${Object.keys(CONTROLS).join(", ")}`);
      control = named;
    } else if (arg.startsWith("--")) throw new Refusal(`unknown option ${arg}`);
    else files.push(arg);
  }
  if (files.length === 0)
    throw new Refusal(
      "usage: npm run --silent verify -- FILE.h [FILE.h …] [--tools TOOLS.json] [--control tnc640|tnc7] [--json | --print]",
    );
  return { files, tools, json, print: printing, control };
}

function bytes(path: string): Buffer {
  try {
    return readFileSync(path);
  } catch {
    throw new Refusal(`cannot read ${path}`);
  }
}

/** Refuses a file that can not be read before the first one is: a list of files is done as a whole or not at all. */
function readable(path: string): void {
  try {
    accessSync(path, constants.R_OK);
  } catch {
    throw new Refusal(`cannot read ${path}`);
  }
  if (statSync(path).isDirectory()) throw new Refusal(`cannot read ${path}`);
}

interface Decoded {
  readonly text: string;
  readonly encoding: "utf8" | "latin1";
}

/** Programs of older controls are not UTF-8: what can not be is read byte by byte. */
function decoded(data: Buffer): Decoded {
  try {
    return { text: new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(data), encoding: "utf8" };
  } catch {
    return { text: data.toString("latin1"), encoding: "latin1" };
  }
}

function toolsOf(path: string | null): ShopTools {
  if (path === null) return { tools: shippedTools, refused: new Map() };
  const read = readTools(decoded(bytes(path)).text);
  if ("problem" in read) throw new Refusal(`tools file ${path}: ${read.problem}`);
  return over(shippedTools, read);
}

/** Reads and runs a program. Its blocks are not kept: of a long one they would fill the memory that the report needs. */
function ran(text: string, shop: ShopTools, control: Control) {
  const started = performance.now();
  const program = parse(text);
  const read = performance.now();
  const done = run(program, { ...shop, rapid: RAPID, control });
  return { done, parsing: read - started, planning: performance.now() - read };
}

/** Reads, runs and simulates one program. */
export function verified(file: string, text: string, shop: ShopTools, control: Control = "TNC 640"): Report {
  const { done, parsing, planning } = ran(text, shop, control);
  const planned = performance.now();
  const simulation = simulate(done);
  const milliseconds = { parse: parsing, plan: planning, simulate: performance.now() - planned };
  return report({ file, run: done, simulation, milliseconds, tools: shop.tools }, "en");
}

/** `npm run --silent verify -- FILE.h …`: 0 no error, 1 an error in a program, 2 the command could not run. */
export function main(args: readonly string[]): number {
  // Whole folders of long programs go through one process: it tidies up before its memory has doubled.
  setFlagsFromString("--heap-growing-percent=30");
  try {
    const { files, tools, json, print: printing, control } = command(args);
    const shop = toolsOf(tools);
    for (const file of files) readable(file);
    let status = 0;
    for (const file of files) {
      const { text, encoding } = decoded(bytes(file));
      if (printing) {
        process.stdout.write(Buffer.from(print(parse(text)), encoding));
        continue;
      }
      const made = verified(file, text, shop, control);
      if (hasErrors(made)) status = 1;
      process.stdout.write(json ? `${JSON.stringify(made)}\n` : summary(made));
    }
    return status;
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    process.stderr.write(`verify: ${error.message}\n`);
    return 2;
  }
}

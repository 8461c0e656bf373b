import { accessSync, constants, readdirSync, readFileSync, statSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { setFlagsFromString } from "node:v8";
import type { LoadingControl } from "../src/control-file/refusal.ts";
import { refusals } from "../src/control-file/refusals.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { isIsoText } from "../src/nc/iso/lines.ts";
import type { IsoIssue } from "../src/nc/iso/issue.ts";
import { klartextOfIso, type KlartextOfIso } from "../src/nc/iso/read-iso.ts";
import { machineTexts } from "../src/i18n/en/machine.ts";
import { parse } from "../src/nc/parse.ts";
import { print } from "../src/nc/program.ts";
import { LAYOUTS } from "../src/nc/style.ts";
import { isoNames } from "../src/program/job/iso-names.ts";
import type { MachineData } from "../src/program/machine/machine-data.ts";
import { readMachine } from "../src/program/machine/machine-file.ts";
import { builtInTools } from "../src/program/iso-codes/usual-tools.ts";
import type { Control } from "../src/program/tools/plane-types.ts";
import { fileKey, type ProgramFile, type ProgramFiles } from "../src/program/state/program-files.ts";
import type { LengthUnit } from "../src/kernel/units.ts";
import { over, type ShopTools } from "../src/program/tools/read-tools.ts";
import { run } from "../src/program/run/run.ts";
import { hasErrors, report, type Report } from "../src/report/report.ts";
import { summary } from "../src/report/summary.ts";
import { simulate } from "../src/sim/simulate.ts";
import { traceStock } from "../src/sim/tracing.ts";
import { readShopTools, toolFormatNames } from "./shop-tools.ts";
import { LOADING_CONTROLS, refusalLines, type RefusedPlace, refusedPlaces } from "./refusal-words.ts";

/** Rapid rate for times without a machine file, mm/min. */
const RAPID = 10_000;

/** A command line that cannot be carried out; its message is the one line on standard error. */
class Refusal extends Error {}

/** Stands for standard input in place of a program file. */
const STDIN = "-";

const usage = (called: string): string =>
  `usage: ${called} FILE.h [FILE.h …] [--tools TOOLS] [--tools-unit mm|inch] [--machine MACHINE.json] [--control tnc640|tnc7] [--as tnc640|tnc7|iso] ` +
  "[--skip] [--json | --print]";

const help = (called: string): string =>
  `${usage(called)}

Runs turning programs in Klartext or DIN/ISO, cuts the stock along their paths and says what was found.

  FILE.h                   a program; ${STDIN} reads one from standard input. Programs that it calls are looked for in its folder
                           and among the other files.
  --tools TOOLS            tools of the shop; each replaces the built-in one of the same number. TOOLS.json of this app, or a file
                           of ${toolFormatNames}; what is proposed or not understood is named on standard error
  --tools-unit mm|inch     unit of lengths of a tools file that does not state it, mm if not said
  --machine MACHINE.json   what the machine can do (format turnwise-machine/1): rapids, accelerations, tool change and spindle go
                           into the times
  --control tnc640|tnc7    the control whose rules hold, tnc640 if not said
  --as tnc640|tnc7|iso     say as well what that control refuses when it loads the file, with block, column and line; iso
                           reads it as DIN/ISO
  --skip                   leave out blocks that are marked with /
  --json                   one JSON object a line and a program in place of a summary (format turnwise-report/1)
  --print                  write the program back as it was read, and run nothing
  --help, --version        this text; the version

Exit status: 0 no error, 1 an error in a program or a file that --as refuses, 2 the command could not run.
`;

interface Command {
  readonly files: readonly string[];
  readonly tools: string | null;
  /** Unit of lengths of a tools file that does not state it. */
  readonly toolsUnit: LengthUnit;
  readonly machine: string | null;
  readonly json: boolean;
  readonly print: boolean;
  readonly control: Control;
  /** The control that would load the file; null without `--as`. */
  readonly as: LoadingControl | null;
  readonly skip: boolean;
}

/** Answers to questions about the command itself; null where there are none. */
function answer(args: readonly string[], called: string): string | null {
  if (args.includes("--help") || args.includes("-h")) return help(called);
  return args.includes("--version") ? `Turnwise ${import.meta.env.VITE_VERSION}\n` : null;
}

const CONTROLS: Readonly<Record<string, Control>> = { tnc640: "TNC 640", tnc7: "TNC7" };

function command(args: readonly string[], called: string): Command {
  const files: string[] = [];
  let [tools, machine, json, printing, skip]: [string | null, string | null, boolean, boolean, boolean] = [
    null,
    null,
    false,
    false,
    false,
  ];
  let control: Control = "TNC 640";
  let toolsUnit: LengthUnit = "mm";
  let as: LoadingControl | null = null;
  for (let i = 0; i < args.length; i += 1) {
    const arg = args[i] ?? "";
    if (arg === "--json") json = true;
    else if (arg === "--print") printing = true;
    else if (arg === "--skip") skip = true;
    else if (arg === "--tools" || arg === "--machine") {
      const path = args[(i += 1)];
      if (path === undefined) throw new Refusal(`${arg} needs a file`);
      if (arg === "--tools") tools = path;
      else machine = path;
    } else if (arg === "--tools-unit") {
      const named = (["mm", "inch"] as const).find((unit) => unit === args[i + 1]?.toLowerCase());
      if (!named) throw new Refusal("--tools-unit needs one of mm, inch");
      toolsUnit = named;
      i += 1;
    } else if (arg === "--control") {
      const named = CONTROLS[args[(i += 1)]?.toLowerCase() ?? ""];
      if (!named) throw new Refusal(`--control needs one of ${Object.keys(CONTROLS).join(", ")}`);
      control = named;
    } else if (arg === "--as") {
      as = loadingControl(args[(i += 1)]);
    } else if (arg.startsWith("--")) throw new Refusal(`unknown option ${arg}`);
    else files.push(arg);
  }
  if (files.length === 0) throw new Refusal(usage(called));
  if (files.filter((file) => file === STDIN).length > 1) throw new Refusal(`${STDIN} can be read once`);
  return { files, tools, toolsUnit, machine, json, print: printing, control, as, skip };
}

function loadingControl(typed: string | undefined): LoadingControl {
  const names = Object.keys(LOADING_CONTROLS) as readonly LoadingControl[];
  const named = names.find((name) => name === typed?.toLowerCase());
  if (named === undefined) throw new Refusal(`--as needs one of ${names.join(", ")}`);
  return named;
}

function bytes(path: string): Buffer {
  try {
    return readFileSync(path === STDIN ? process.stdin.fd : path);
  } catch {
    throw new Refusal(`cannot read ${path}`);
  }
}

/**
 * Refuses an unreadable file before the first one is processed: a list of files is processed completely or not at all.
 */
function readable(path: string): void {
  if (path === STDIN) return;
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

/** Programs of older controls are not UTF-8: invalid text is read byte by byte. */
function decoded(data: Buffer): Decoded {
  try {
    return { text: new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(data), encoding: "utf8" };
  } catch {
    return { text: data.toString("latin1"), encoding: "latin1" };
  }
}

/** Tools of the shop over the built-in ones; what is doubtful about them goes to standard error. */
function toolsOf(path: string | null, unit: LengthUnit): ShopTools {
  if (path === null) return builtInTools.table;
  const read = readShopTools(basename(path), bytes(path), unit);
  if ("problem" in read) throw new Refusal(`tools file ${path}: ${read.problem}`);
  for (const note of read.notes) process.stderr.write(`verify: tools file ${path}: ${note}\n`);
  return over(builtInTools.table, read.tools);
}

function machineIn(path: string | null): MachineData | null {
  if (path === null) return null;
  const read = readMachine(decoded(bytes(path)).text);
  if ("machine" in read) return read.machine;
  const [{ kind, at, limit }] = read.problems;
  throw new Refusal(
    `machine file ${path}: ${machineTexts.problems[kind](at === "" ? "" : `${at}: `, String(limit ?? ""))}`,
  );
}

/** A program as Klartext, with the losses of a DIN/ISO translation. */
const asKlartext = (text: string): KlartextOfIso =>
  isIsoText(text) ? klartextOfIso(text, LAYOUTS.tnc7, isoNames(ncLabels("en"))) : { text, issues: [] };

/** Issues of a translation, without the blocks that were not understood: the Klartext reader reports those. */
const translationIssues = (issues: readonly IsoIssue[]): Report["issues"] =>
  issues.flatMap((i) => {
    const text =
      i.code === "isoPlaneLeftOut"
        ? `${i.data.word} outside of T and G30 is left out: the working plane is that of the tool call.`
        : i.code === "isoBlocksRecounted"
          ? "The block numbers do not rise or leave no room: blocks are counted from 0."
          : null;
    return text === null
      ? []
      : [{ code: i.code, severity: i.severity, ...(i.number !== null && { block: i.number }), data: i.data, text }];
  });

/** Options of a run. */
interface Setting {
  readonly control?: Control;
  readonly files?: ProgramFiles;
  readonly machine?: MachineData;
  /** Leave out the blocks that are marked with `/`. */
  readonly skipMarked?: boolean;
}

/**
 * Reads and runs a program. Its blocks are discarded: those of a long program would fill the memory that the report
 * needs.
 */
function ran(text: string, shop: ShopTools, setting: Setting) {
  const started = performance.now();
  const klartext = asKlartext(text);
  const program = parse(klartext.text);
  const read = performance.now();
  const done = run(program, { ...shop, rapid: RAPID, tracing: traceStock, ...setting });
  return {
    done,
    lost: translationIssues(klartext.issues),
    parsing: read - started,
    planning: performance.now() - read,
  };
}

/** Reads, runs and simulates one program. */
export function verified(file: string, text: string, shop: ShopTools, setting: Setting = {}): Report {
  const { done, lost, parsing, planning } = ran(text, shop, setting);
  const planned = performance.now();
  const simulation = simulate(done);
  const milliseconds = { parse: parsing, plan: planning, simulate: performance.now() - planned };
  const made = report({ file, run: done, simulation, milliseconds, tools: shop.tools }, "en");
  return lost.length > 0 ? { ...made, issues: [...lost, ...made.issues] } : made;
}

/** The names of a folder's files, by their comparison form; empty where the folder cannot be read. */
function namesIn(folder: string): ReadonlyMap<string, string> {
  try {
    return new Map(
      readdirSync(folder)
        .toSorted()
        .reverse()
        .map((name) => [fileKey(name), name]),
    );
  } catch {
    return new Map();
  }
}

/**
 * The files that a program can call: those in its folder, and those on the command line; each is read when it is
 * called.
 */
function companionFiles(path: string, given: ReadonlyMap<string, string>): ProgramFiles {
  const folder = dirname(path);
  const read = new Map<string, ProgramFile | null>();
  let names: ReadonlyMap<string, string> | null = null;
  const made = (key: string): ProgramFile | null => {
    names ??= namesIn(folder);
    const name = names.get(key);
    const place = name === undefined ? given.get(key) : join(folder, name);
    if (place === undefined) return null;
    try {
      return { name: basename(place), program: parse(asKlartext(decoded(readFileSync(place)).text).text) };
    } catch {
      return null;
    }
  };
  return {
    find: (key) => {
      const known = read.get(key);
      if (known !== undefined) return known;
      const found = made(key);
      read.set(key, found);
      return found;
    },
  };
}

/** The report of a file, with the control's refusals if `--as` asks for them. */
export interface FileReport extends Report {
  readonly refused?: readonly RefusedPlace[];
}

/** A report as written: one JSON object on a line, or a summary with the refusals below it. */
function written(
  made: Report,
  text: string,
  { as, json }: Pick<Command, "as" | "json">,
): { readonly text: string; readonly isFaulty: boolean } {
  const found = as === null ? [] : refusals(text, as);
  const isFaulty = hasErrors(made) || found.length > 0;
  if (!json) return { text: summary(made) + (as === null ? "" : refusalLines(made.file, as, found)), isFaulty };
  const whole: FileReport = as === null ? made : { ...made, refused: refusedPlaces(found) };
  return { text: `${JSON.stringify(whole)}\n`, isFaulty };
}

/**
 * `npm run --silent verify -- FILE.h …`: 0 no error, 1 an error in a program, 2 the command could not run. `called` is
 * the command as its user typed it.
 */
export function main(args: readonly string[], called = "npm run --silent verify --"): number {
  // One process reads whole folders of long programs: collect garbage before the heap has doubled.
  setFlagsFromString("--heap-growing-percent=30");
  try {
    const about = answer(args, called);
    if (about !== null) {
      process.stdout.write(about);
      return 0;
    }
    const asked = command(args, called);
    const { files, tools, toolsUnit, machine: machinePath, print: printing, control, skip } = asked;
    const [shop, machine] = [toolsOf(tools, toolsUnit), machineIn(machinePath)];
    for (const file of files) readable(file);
    const given = new Map(
      files
        .filter((file) => file !== STDIN)
        .toReversed()
        .map((file) => [fileKey(basename(file)), file]),
    );
    let status = 0;
    for (const file of files) {
      const { text, encoding } = decoded(bytes(file));
      if (printing) {
        process.stdout.write(Buffer.from(print(parse(text)), encoding));
        continue;
      }
      const made = verified(file, text, shop, {
        control,
        files: companionFiles(file, given),
        skipMarked: skip,
        ...(machine && { machine }),
      });
      const out = written(made, text, asked);
      if (out.isFaulty) status = 1;
      process.stdout.write(out.text);
    }
    return status;
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    process.stderr.write(`verify: ${error.message}\n`);
    return 2;
  }
}

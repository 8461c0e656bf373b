import { readFileSync } from "node:fs";
import { basename, extname } from "node:path";
import { noteText } from "../src/i18n/drawing-note.ts";
import { drawing as drawingWords } from "../src/i18n/en/drawing.ts";
import { ncLabels } from "../src/i18n/nc-labels.ts";
import { planTitles } from "../src/i18n/nc/plan-titles.ts";
import type { LengthUnit } from "../src/kernel/units.ts";
import { NC_LANGUAGES, type NcLanguage } from "../src/nc/nc-languages.ts";
import type { FinishedPart } from "../src/planning/part/finished-part.ts";
import { partOfDrawing } from "../src/planning/part/part-of-drawing.ts";
import { readPart } from "../src/planning/part/part-file.ts";
import { plannedPart } from "../src/planning/part/planned-part.ts";
import { planning } from "../src/planning/plan.ts";
import { USUAL_RULES } from "../src/planning/shop-rules.ts";
import type { WorkingPlan } from "../src/planning/working-plan.ts";
import { readDrawing } from "../src/program/drawing/formats.ts";
import type { BlankDraft } from "../src/program/job/job.ts";
import { readMachine } from "../src/program/machine/machine-file.ts";
import type { MachineData } from "../src/program/machine/machine-data.ts";
import { builtInTools } from "../src/program/iso-codes/usual-tools.ts";
import { over } from "../src/program/tools/read-tools.ts";
import { planLines, planTextsOf } from "./plan-words.ts";
import { readShopTools, toolFormatNames } from "./shop-tools.ts";

/** A command line that cannot be carried out; its message is the one line on standard error. */
class WrongUse extends Error {}

/** Stands for standard input in place of a part file. */
const STDIN = "-";
/** Rapid rate for times without a machine file, mm/min. */
const RAPID = 10_000;

const usage = (called: string): string =>
  `usage: ${called} PART.json|PART.dxf [--tools TOOLS] [--tools-unit mm|inch] [--machine MACHINE.json] [--unit mm|inch] ` +
  "[--material ID] [--blank SIZE] [--part-off] [--without-tool N …] [--without-cycle N …] [--clamping 1|2] [--language en|de|fr|zh]";

const help = (called: string): string =>
  `${usage(called)}

Plans the turning of a finished part and prints the program in Klartext. Every operation was tried in the real stock, and
the whole program is run and checked. The operations with their reasons and the next-best ways, the times and what is left
are on standard error.

  PART.json                the finished part (format turnwise-part/1); ${STDIN} reads one from standard input
  PART.dxf                 a drawing of it: DXF, STEP or SVG, outside and bore
  --tools TOOLS            tools of the shop; each replaces the built-in one of the same number. TOOLS.json of this app, or a
                           file of ${toolFormatNames}
  --tools-unit mm|inch     unit of lengths of a tools file that does not state it, mm if not said
  --machine MACHINE.json   what the machine can do (format turnwise-machine/1)
  --unit mm|inch           unit of the numbers of a drawing, in place of the one it names
  --material ID            material by its id in the cutting data, as c45
  --blank SIZE             cylinder in mm: 50x165 is ⌀ and length, 50x20x165 has a bore of ⌀20; 50x165+1.5 has 1.5 mm in front
                           of Z0
  --part-off               series from bar: the part is parted off
  --without-tool N         plans without this tool; may be repeated
  --without-cycle N        plans without this cycle; may be repeated
  --clamping 1|2           the clamping whose program is printed, 1 if not said; both are planned
  --language en|de|fr|zh   language of the program and of the plan, en if not said
  --help, --version        this text; the version

Exit status: 0 the program is verified and nothing is left, 1 it is not or something is left, 2 the command could not run.
`;

/** The clamping whose program is printed: a control loads a file with one program. */
const CLAMPINGS = ["1", "2"] as const;

interface Command {
  readonly file: string;
  readonly tools: string | null;
  readonly toolsUnit: LengthUnit;
  readonly machine: string | null;
  readonly unit: LengthUnit | undefined;
  readonly material: string | null;
  readonly blank: BlankDraft | null;
  readonly partsOff: boolean;
  readonly withoutTools: readonly number[];
  readonly withoutCycles: readonly number[];
  readonly clamping: (typeof CLAMPINGS)[number];
  readonly language: NcLanguage;
}

function oneOf<T extends string>(option: string, typed: string, names: readonly T[]): T {
  const found = names.find((name) => name === typed.toLowerCase());
  if (found === undefined) throw new WrongUse(`${option} needs one of ${names.join(", ")}, not ${typed}`);
  return found;
}

function number(option: string, typed: string): number {
  const value = typed.trim() === "" ? Number.NaN : Number(typed);
  if (!Number.isFinite(value)) throw new WrongUse(`${option} needs a number, not ${typed}`);
  return value;
}

/** `50x165`, `50x20x165`, `50x165+1.5`. */
function blankOf(typed: string): BlankDraft {
  const [, outside, second, third, allowance] =
    /^(\d+(?:\.\d+)?)x(\d+(?:\.\d+)?)(?:x(\d+(?:\.\d+)?))?(?:\+(\d+(?:\.\d+)?))?$/i.exec(typed) ?? [];
  if (outside === undefined || second === undefined)
    throw new WrongUse(`--blank needs ⌀ x length, as 50x165+1.5, not ${typed}`);
  return third === undefined
    ? { outside, bore: "", length: second, allowance: allowance ?? "" }
    : { outside, bore: second, length: third, allowance: allowance ?? "" };
}

function command(args: readonly string[], called: string): Command {
  const files: string[] = [];
  let made: Omit<Command, "file"> = {
    tools: null,
    toolsUnit: "mm",
    machine: null,
    unit: undefined,
    material: null,
    blank: null,
    partsOff: false,
    withoutTools: [],
    withoutCycles: [],
    clamping: "1",
    language: "en",
  };
  for (let i = 0; i < args.length; i += 1) {
    const arg = args[i] ?? "";
    if (arg === "--part-off") made = { ...made, partsOff: true };
    else if (!arg.startsWith("--")) files.push(arg);
    else made = { ...made, ...valued(arg, args[(i += 1)], made) };
  }
  const [file] = files;
  if (file === undefined) throw new WrongUse(usage(called));
  if (files.length > 1) throw new WrongUse(`one part at a time, not ${files.join(", ")}`);
  return { ...made, file };
}

/** An option with its value. */
function valued(option: string, typed: string | undefined, before: Omit<Command, "file">): Partial<Command> {
  const value = (): string => {
    if (typed === undefined) throw new WrongUse(`${option} needs a value`);
    return typed;
  };
  switch (option) {
    case "--tools":
      return { tools: value() };
    case "--tools-unit":
      return { toolsUnit: oneOf(option, value(), ["mm", "inch"]) };
    case "--machine":
      return { machine: value() };
    case "--unit":
      return { unit: oneOf<LengthUnit>(option, value(), ["mm", "inch"]) };
    case "--material":
      return { material: value() };
    case "--blank":
      return { blank: blankOf(value()) };
    case "--without-tool":
      return { withoutTools: [...before.withoutTools, number(option, value())] };
    case "--without-cycle":
      return { withoutCycles: [...before.withoutCycles, number(option, value())] };
    case "--clamping":
      return { clamping: oneOf(option, value(), CLAMPINGS) };
    case "--language":
      return { language: oneOf(option, value(), NC_LANGUAGES) };
    default:
      throw new WrongUse(`unknown option ${option}`);
  }
}

function bytes(path: string): Uint8Array {
  try {
    return new Uint8Array(readFileSync(path === STDIN ? process.stdin.fd : path));
  } catch {
    throw new WrongUse(`cannot read ${path}`);
  }
}

const say = (line: string) => process.stderr.write(`${line}\n`);
const textOf = (data: Uint8Array) => new TextDecoder().decode(data);

/** The tools of the shop, and the numbers of usual ones that its own files lack. */
function toolsOf({ tools: path, toolsUnit }: Command): typeof builtInTools {
  if (path === null) return builtInTools;
  const read = readShopTools(basename(path), bytes(path), toolsUnit);
  if ("problem" in read) throw new WrongUse(`tools file ${path}: ${read.problem}`);
  for (const note of read.notes) say(`tools file ${path}: ${note}`);
  const own = new Set([...read.tools.tools, ...(read.tools.mills ?? [])].map(({ T }) => T));
  return { table: over(builtInTools.table, read.tools), usual: builtInTools.usual.filter((T) => !own.has(T)) };
}

function machineOf({ machine: path }: Command): MachineData | null {
  if (path === null) return null;
  const read = readMachine(textOf(bytes(path)));
  if ("machine" in read) return read.machine;
  throw new WrongUse(`machine file ${path} is not usable: ${read.problems[0].at || read.problems[0].kind}`);
}

/** The part of a file; what was assumed or is wrong goes to standard error. Null where there is none. */
async function partOf({ file, unit }: Command): Promise<FinishedPart | null> {
  const data = bytes(file);
  const isPart =
    extname(file).toLowerCase() === ".json" || (file === STDIN && textOf(data).trimStart().startsWith("{"));
  if (isPart) {
    const { part, problems } = readPart(textOf(data));
    for (const { code, values } of problems.filter((p) => p.code !== "row"))
      say(`${file}: ${code} ${JSON.stringify(values)}`);
    return part;
  }
  const drawing = await readDrawing({ name: basename(file), bytes: data }, unit && { unit });
  const name = basename(file, extname(file)).toUpperCase();
  const { part, notes } = partOfDrawing(drawing, name);
  for (const note of notes) say(`${note.severity}: ${noteText("en", note, drawingWords)}`);
  return part;
}

/** Plans a part; null where its contour is not usable. */
function plan(asked: Command, file: FinishedPart): WorkingPlan | null {
  const given: FinishedPart = {
    ...file,
    ...(asked.material !== null && { material: asked.material }),
    ...(asked.blank && { blank: asked.blank }),
    ...(asked.partsOff && { partsOff: true }),
  };
  const { part, blank, clamping, problems } = plannedPart(given);
  for (const problem of problems)
    say(`${problem.severity}: ${problem.code} ${"values" in problem ? JSON.stringify(problem.values) : problem.row}`);
  if (!part) return null;
  const machine = machineOf(asked);
  const { table, usual } = toolsOf(asked);
  const search = planning({
    part,
    blank,
    clamping,
    usualTools: usual,
    shop: { ...table, rapid: RAPID, ...(machine && { machine }) },
    material: given.material,
    rules: { ...USUAL_RULES, ...given.rules },
    partsOff: given.partsOff,
    withoutCycles: asked.withoutCycles,
    withoutTools: asked.withoutTools,
    labels: ncLabels(asked.language),
    titles: planTitles(asked.language),
  });
  for (;;) {
    const next = search.next();
    if (next.done) return next.value;
  }
}

/**
 * `npm run --silent plan -- PART.json …`: 0 verified and nothing left, 1 not, 2 the command could not run. `called` is
 * the command as its user typed it.
 */
export async function main(args: readonly string[], called = "npm run --silent plan --"): Promise<number> {
  try {
    if (args.includes("--help") || args.includes("-h")) process.stdout.write(help(called));
    else if (args.includes("--version")) process.stdout.write(`Turnwise ${import.meta.env.VITE_VERSION}\n`);
    else {
      const asked = command(args, called);
      const part = await partOf(asked);
      const made = part && plan(asked, part);
      if (!made) return 1;
      const texts = await planTextsOf(asked.language);
      const clampings = [made, ...(made.second ? [made.second] : [])];
      clampings.forEach((one, i) => {
        if (clampings.length > 1) say(`${i === 0 ? texts.t.result.first : texts.t.result.second}:`);
        planLines(one, texts).forEach(say);
      });
      const printed = asked.clamping === "1" ? made : made.second;
      if (!printed) throw new WrongUse("there is no second clamping");
      process.stdout.write(printed.text);
      return clampings.every(({ isComplete }) => isComplete) ? 0 : 1;
    }
    return 0;
  } catch (error) {
    if (!(error instanceof WrongUse)) throw error;
    say(`plan: ${error.message}`);
    return 2;
  }
}

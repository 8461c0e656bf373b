import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { noteText } from "../src/i18n/drawing-note.ts";
import { drawing as words } from "../src/i18n/en/drawing.ts";
import { drawingImport as imported } from "../src/i18n/en/drawing-import.ts";
import { formatNumber } from "../src/i18n/number.ts";
import { programText } from "../src/nc/print.ts";
import { LAYOUTS } from "../src/nc/style.ts";
import type { ContourChoice, Drawing, DrawingGiven, DrawingNote } from "../src/program/drawing/drawing.ts";
import { contourOf, propose, readDrawing } from "../src/program/drawing/formats.ts";
import { contourStatements } from "../src/program/job/print-contour.ts";
import { INCH } from "../src/kernel/units.ts";

/** A command line that cannot be carried out; its message is the one line on standard error. */
class WrongUse extends Error {}

/** Stands for standard input in place of a file. */
const STDIN = "-";
/** Label of the subprogram. */
const LABEL = 1;

const usage = (called: string): string =>
  `usage: ${called} FILE.dxf [--unit mm|inch] [--body N] [--axis Y] [--zero Z] [--half upper|lower] [--piece N] [--side outside|bore] ` +
  "[--gap WIDTH] [--layer NAME …] [--mirrored] [--reversed] [--diameters] [--thin]";

const help = (called: string): string =>
  `${usage(called)}

Takes the contour of a turned part from a drawing and prints it as a subprogram in Klartext: LBL 1 to LBL 0. What was left
out, joined or is doubtful is on standard error, a line each. What is not given is proposed from the drawing.

  FILE.dxf             the drawing: DXF, STEP or SVG; ${STDIN} reads one from standard input
  --unit mm|inch       unit of its numbers, in place of the one it names
  --body N             which body of a STEP file, 1 for the one with the largest turned surface
  --axis Y             place of the axis of rotation: y of a horizontal one, x=… of a vertical one; x or y alone is its
                       direction. Places are in the unit of the drawing.
  --zero Z             place of Z0 along the axis
  --half upper|lower   side of the axis that is taken; upper is the one with the greater coordinates
  --piece N            which of several pieces, 1 for the likeliest
  --side outside|bore  of a section of a hollow part
  --gap WIDTH          ends no farther apart are joined, mm
  --layer NAME         takes this layer only; may be repeated
  --mirrored           Z runs against the direction of the drawing
  --reversed           the contour begins at its other end
  --diameters          distances from the axis are drawn as diameters
  --thin               takes hidden and thin lines, too
  --help, --version    this text; the version

Exit status: 0 a contour is printed, 1 there is none, 2 the command could not run.
`;

/** Values of a command: those of a choice as typed, places still in the unit of the drawing. */
interface Command {
  readonly file: string;
  readonly given: DrawingGiven;
  readonly axis: ContourChoice["axis"] | undefined;
  readonly axisAt: number | undefined;
  readonly zero: number | undefined;
  readonly layers: readonly string[];
  readonly choice: Partial<ContourChoice>;
}

const FLAGS = ["mirrored", "reversed", "diameters", "thin"] as const;

function number(option: string, typed: string): number {
  const value = typed.trim() === "" ? Number.NaN : Number(typed.replace(",", "."));
  if (!Number.isFinite(value)) throw new WrongUse(`${option} needs a number, not ${typed}`);
  return value;
}

/** Index of what is counted from 1. */
function ordinal(option: string, typed: string): number {
  const value = number(option, typed);
  if (!Number.isInteger(value) || value < 1) throw new WrongUse(`${option} needs a number from 1, not ${typed}`);
  return value - 1;
}

function oneOf<T extends string>(option: string, typed: string, names: readonly T[]): T {
  const found = names.find((name) => name === typed.toLowerCase());
  if (found === undefined) throw new WrongUse(`${option} needs one of ${names.join(", ")}, not ${typed}`);
  return found;
}

/** `12.5`, `y=12.5` and `x=30` are places of an axis, `x` and `y` its directions. */
function axisOf(typed: string): Pick<Command, "axis" | "axisAt"> {
  const [, name = "", place = ""] = /^(?:([xy])=?)?(.*)$/i.exec(typed) ?? [];
  const letter = name.toLowerCase();
  if (place === "" && letter !== "") return { axis: letter === "x" ? "x" : "y", axisAt: undefined };
  return { axis: letter === "x" ? "y" : "x", axisAt: number("--axis", place) };
}

function command(args: readonly string[], called: string): Command {
  const files: string[] = [],
    layers: string[] = [];
  let made: Omit<Command, "file" | "layers"> = {
    given: {},
    axis: undefined,
    axisAt: undefined,
    zero: undefined,
    choice: {},
  };
  const choose = (choice: Partial<ContourChoice>) => {
    made = { ...made, choice: { ...made.choice, ...choice } };
  };
  for (let i = 0; i < args.length; i += 1) {
    const arg = args[i] ?? "",
      flag = FLAGS.find((name) => arg === `--${name}`);
    if (flag) {
      choose({ [flag]: true });
      continue;
    }
    if (!arg.startsWith("--")) {
      files.push(arg);
      continue;
    }
    const value = (): string => {
      const next = args[(i += 1)];
      if (next === undefined) throw new WrongUse(`${arg} needs a value`);
      return next;
    };
    switch (arg) {
      case "--unit":
        made = { ...made, given: { ...made.given, unit: oneOf(arg, value(), ["mm", "inch"]) } };
        break;
      case "--body":
        made = { ...made, given: { ...made.given, body: ordinal(arg, value()) } };
        break;
      case "--axis":
        made = { ...made, ...axisOf(value()) };
        break;
      case "--zero":
        made = { ...made, zero: number(arg, value()) };
        break;
      case "--half":
        choose({ half: oneOf(arg, value(), ["upper", "lower"]) });
        break;
      case "--side":
        choose({ side: oneOf(arg, value(), ["outside", "bore"]) });
        break;
      case "--piece":
        choose({ piece: ordinal(arg, value()) });
        break;
      case "--gap": {
        const typed = value(),
          gap = number(arg, typed);
        if (gap < 0) throw new WrongUse(`${arg} needs a width of 0 or more, not ${typed}`);
        choose({ gap });
        break;
      }
      case "--layer":
        layers.push(value());
        break;
      default:
        throw new WrongUse(`unknown option ${arg}`);
    }
  }
  const [file] = files;
  if (file === undefined) throw new WrongUse(usage(called));
  if (files.length > 1) throw new WrongUse(`one drawing at a time, not ${files.join(", ")}`);
  return { ...made, file, layers };
}

function bytes(path: string): Uint8Array {
  try {
    return new Uint8Array(readFileSync(path === STDIN ? process.stdin.fd : path));
  } catch {
    throw new WrongUse(`cannot read ${path}`);
  }
}

/** What was given of a choice, in mm of the drawing. */
function given(asked: Command, drawing: Drawing): Partial<ContourChoice> {
  const mm = drawing.unit.unit === "inch" ? INCH : 1,
    known = new Set(drawing.curves.map((c) => c.layer));
  const unknown = asked.layers.find((name) => !known.has(name));
  if (unknown !== undefined) throw new WrongUse(`no layer ${unknown}; there are ${[...known].join(", ") || "none"}`);
  return {
    ...asked.choice,
    ...(asked.axis && { axis: asked.axis }),
    ...(asked.axisAt !== undefined && { axisAt: asked.axisAt * mm }),
    ...(asked.zero !== undefined && { zero: asked.zero * mm }),
    ...(asked.layers.length > 0 && { withoutLayers: [...known].filter((name) => !asked.layers.includes(name)) }),
  };
}

/** `npm run --silent contour -- FILE.dxf …`: 0 a contour is printed, 1 there is none, 2 the command could not run. */
export async function main(args: readonly string[], called = "npm run --silent contour --"): Promise<number> {
  const say = (line: string) => process.stderr.write(`${line}\n`);
  const tell = (notes: readonly DrawingNote[]) =>
    notes.forEach((n) => say(`${n.severity}: ${noteText("en", n, words)}`));
  try {
    if (args.includes("--help") || args.includes("-h")) process.stdout.write(help(called));
    else if (args.includes("--version")) process.stdout.write(`Turnwise ${import.meta.env.VITE_VERSION}\n`);
    else {
      const asked = command(args, called),
        drawing = await readDrawing({ name: basename(asked.file), bytes: bytes(asked.file) }, asked.given);
      if (drawing.curves.length === 0) {
        tell(drawing.notes);
        return 1;
      }
      const { bodies } = drawing;
      if (asked.given.body !== undefined && (bodies?.drawn ?? 0) !== asked.given.body)
        throw new WrongUse(`--body ${asked.given.body + 1}: there are ${bodies?.all.length ?? 1}`);
      const fixed = given(asked, drawing),
        choice = propose(drawing, fixed),
        { rows, notes, pieces } = contourOf(drawing, choice);
      if (fixed.piece !== undefined && fixed.piece >= pieces.length && pieces.length > 0)
        throw new WrongUse(`--piece ${fixed.piece + 1}: there are ${pieces.length}`);
      tell([...drawing.notes, ...notes]);
      if (bodies && bodies.all.length > 1)
        bodies.all.forEach(({ name, across, length }, i) =>
          say(
            `info: --body ${imported.bodyOf(i + 1, name, formatNumber("en", across, 1), formatNumber("en", length, 1))}`,
          ),
        );
      if (rows.length < 2) return 1;
      const label = (number: number) => ({ kind: "label" as const, label: number });
      process.stdout.write(programText([label(LABEL), ...contourStatements(rows), label(0)], LAYOUTS.tnc7, false));
    }
    return 0;
  } catch (error) {
    if (!(error instanceof WrongUse)) throw error;
    say(`contour: ${error.message}`);
    return 2;
  }
}

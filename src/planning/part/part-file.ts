import { readJson } from "../../program/files/bounded.ts";
import { z } from "zod/mini";
import { CLAMPING_KINDS, CLAMPING_WORDS } from "../../program/clamping/words.ts";
import { newRow, type BlankDraft, type ContourRow } from "../../program/job/job.ts";
import type { FinishedPart } from "./finished-part.ts";
import { partProblem, type PartProblem } from "./part-problem.ts";

/** First member of a part file: its format and edition. */
const FORMAT = "turnwise-part/",
  EDITION = 1;
export const PART_FORMAT = `${FORMAT}${EDITION}`;

/** Longest file that is read, characters; most rows of a contour; longest text of a cell and longest name. */
const LONGEST_FILE = 200_000,
  MOST_ROWS = 500,
  LONGEST_CELL = 60,
  LONGEST_NAME = 60;
/** Greatest number in a file, in any unit: no lathe is 100 m long. */
const LARGEST = 100_000;
/** Most problems that are listed. */
const MOST_PROBLEMS = 100;

const text = z.string().check(z.maxLength(LONGEST_CELL));
/** A number as typed, or as a number of JSON. */
const cell = z.union([text, z.number().check(z.gte(-LARGEST), z.lte(LARGEST))]);
const id = z.string().check(z.minLength(1), z.maxLength(LONGEST_CELL));
const words = z.record(text, cell);
const flag = z.optional(z.boolean());

const KINDS = ["L", "RND", "CHF", "CR", "CC", "C", "CT", "LP", "CP", "CTP", "UDC", "GRV"] as const;
const row = z.strictObject({
  id: z.optional(id),
  kind: z.optional(z.enum(KINDS)),
  x: z.optional(cell),
  z: z.optional(cell),
  r: z.optional(cell),
  turn: z.optional(z.enum(["cw", "ccw"])),
  incrementalX: flag,
  incrementalZ: flag,
  angle: z.optional(cell),
  length: z.optional(cell),
  tangent: flag,
  second: flag,
  form: z.optional(text),
  words: z.optional(words),
});
const contour = z.array(row).check(z.maxLength(MOST_ROWS));

/** Roughness, µm. */
const roughness = z.optional(z.number().check(z.gte(0.01), z.lte(1000)));
const seconds = z.optional(z.number().check(z.gte(0), z.lte(3600)));
const oversize = z.number().check(z.gte(0), z.lte(20));

/** The part file. Lengths are mm, X is a diameter. */
export const partSchema = z.strictObject({
  format: z.literal(PART_FORMAT),
  name: z.string().check(z.minLength(1), z.maxLength(LONGEST_NAME)),
  material: z.optional(id),
  outside: contour,
  inside: z.optional(contour),
  marks: z.optional(
    z.record(
      id,
      z.strictObject({
        thread: z.optional(text),
        undercut: z.optional(text),
        tolerance: z.optional(text),
        ra: roughness,
        rz: roughness,
      }),
    ),
  ),
  general: z.optional(z.strictObject({ tolerance: z.optional(text), ra: roughness, rz: roughness })),
  blank: z.optional(
    z.union([
      z.strictObject({ outline: contour }),
      z.strictObject({
        outside: z.optional(cell),
        bore: z.optional(cell),
        length: z.optional(cell),
        allowance: z.optional(cell),
      }),
    ]),
  ),
  clamping: z.optional(
    z.strictObject({ kind: z.enum(CLAMPING_KINDS), words: z.partialRecord(z.enum(CLAMPING_WORDS), cell) }),
  ),
  partsOff: flag,
  unmachinedBehind: flag,
  rules: z.optional(
    z.strictObject({
      toolChange: seconds,
      usualTool: seconds,
      finishBeforeRough: seconds,
      insideBeforeOutside: seconds,
      thinBeforeLong: seconds,
      tolerancedLast: seconds,
      allowance: z.optional(z.strictObject({ diameter: oversize, z: oversize })),
    }),
  ),
});
type PartFile = z.output<typeof partSchema>;
type FileRow = z.output<typeof row>;

/** A part as read, or null and its problems. */
export interface ReadPart {
  readonly part: FinishedPart | null;
  readonly problems: readonly PartProblem[];
}

type Found = NonNullable<ReturnType<typeof partSchema.safeParse>["error"]>["issues"][number];

const valueAt = (raw: unknown, path: readonly PropertyKey[]): unknown =>
  path.reduce<unknown>(
    (value, key) =>
      typeof value === "object" && value !== null ? (value as Record<PropertyKey, unknown>)[key] : undefined,
    raw,
  );

/** The problems of a value that fits none of several forms: those of the form that it comes closest to. */
const closest = (errors: readonly (readonly Found[])[]): readonly Found[] =>
  errors.reduce<readonly Found[]>(
    (best, next) =>
      best.length === 0 || next.filter((f) => f.code !== "invalid_type").length < best.length ? next : best,
    [],
  );

function problemsOf(found: Found, raw: unknown, above: readonly PropertyKey[] = []): readonly PartProblem[] {
  const path = [...above, ...found.path],
    at = path.map(String).join(".");
  switch (found.code) {
    case "unrecognized_keys":
      return found.keys.map((key) => partProblem("unknown", { at: [...path.map(String), key].join(".") }));
    case "too_small":
      return [partProblem("low", { at, limit: Number(found.minimum) })];
    case "too_big":
      return [partProblem("high", { at, limit: Number(found.maximum) })];
    case "invalid_union":
      return valueAt(raw, path) === undefined || found.errors.length === 0 || found.errors[0]?.length === 0
        ? [partProblem("wrong", { at })]
        : closest(found.errors as readonly (readonly Found[])[]).flatMap((f) =>
            f.code === "invalid_type" && f.path.length === 0
              ? [partProblem("wrong", { at })]
              : problemsOf(f, raw, path),
          );
    case "invalid_key":
      return [partProblem("unknown", { at })];
    default:
      return [valueAt(raw, path) === undefined ? partProblem("missing", { at }) : partProblem("wrong", { at })];
  }
}

const typed = (given: string | number | undefined): string => (given === undefined ? "" : String(given));
const typedWords = (given: Readonly<Record<string, string | number | undefined>>): Record<string, string> =>
  Object.fromEntries(Object.entries(given).map(([name, value]) => [name, typed(value)]));

function rowOf(given: FileRow, otherwise: string): ContourRow {
  const { id: own, x, z: along, r, angle, length, words: named, ...others } = given;
  const defined = Object.fromEntries(Object.entries(others).filter(([, value]) => value !== undefined));
  return newRow(own ?? otherwise, {
    ...(defined as Partial<ContourRow>),
    x: typed(x),
    z: typed(along),
    r: typed(r),
    angle: typed(angle),
    length: typed(length),
    ...(named && { words: typedWords(named) }),
  });
}

const rowsOf = (given: readonly FileRow[] | undefined, letter: string): readonly ContourRow[] =>
  (given ?? []).map((each, i) => rowOf(each, `${letter}${i + 1}`));

function blankOf(given: PartFile["blank"]): FinishedPart["blank"] {
  if (!given) return null;
  if ("outline" in given) return { outline: rowsOf(given.outline, "b") };
  const { outside, bore, length, allowance } = given as Partial<Record<keyof BlankDraft, string | number>>;
  return { outside: typed(outside), bore: typed(bore), length: typed(length), allowance: typed(allowance) };
}

function partOf(file: PartFile): FinishedPart {
  const { name, material, marks, general, clamping, rules } = file;
  return {
    name,
    material: material ?? "c45",
    outside: rowsOf(file.outside, "e"),
    inside: rowsOf(file.inside, "i"),
    marks: (marks ?? {}) as FinishedPart["marks"],
    general: (general ?? {}) as FinishedPart["general"],
    blank: blankOf(file.blank),
    clamping: clamping ? { kind: clamping.kind, words: typedWords(clamping.words) } : null,
    partsOff: file.partsOff ?? false,
    unmachinedBehind: file.unmachinedBehind ?? false,
    rules: (rules ?? {}) as FinishedPart["rules"],
  };
}

/** Ids of rows must be unique, and marks must name one. */
function problemsOfIds({ outside, inside, marks }: FinishedPart): readonly PartProblem[] {
  const ids = [...outside, ...inside].map((each) => each.id),
    known = new Set(ids);
  const twice = new Set(ids.filter((each, i) => ids.indexOf(each) !== i));
  return [
    ...[...twice].map((each) => partProblem("sameId", { id: each })),
    ...Object.keys(marks).flatMap((each) => (known.has(each) ? [] : [partProblem("noRow", { id: each })])),
  ];
}

const isRecord = (raw: unknown): raw is Readonly<Record<string, unknown>> =>
  typeof raw === "object" && raw !== null && !Array.isArray(raw);

/** Reads the text of a part file. Never throws. */
export function readPart(source: string): ReadPart {
  const refused = (code: "notJson" | "notPart" | "newer"): ReadPart => ({
    part: null,
    problems: [partProblem(code, {})],
  });
  if (source.length > LONGEST_FILE) return { part: null, problems: [partProblem("tooLong", { limit: LONGEST_FILE })] };
  let raw: unknown = null;
  try {
    raw = readJson(source);
  } catch (error) {
    return refused(error instanceof SyntaxError ? "notJson" : "notPart");
  }
  const format = isRecord(raw) && typeof raw["format"] === "string" ? raw["format"] : "";
  if (!format.startsWith(FORMAT)) return refused("notPart");
  if (Number(format.slice(FORMAT.length)) > EDITION) return refused("newer");
  const read = partSchema.safeParse(raw);
  if (!read.success)
    return {
      part: null,
      problems: read.error.issues.flatMap((found) => problemsOf(found, raw)).slice(0, MOST_PROBLEMS),
    };
  const part = partOf(read.data),
    problems = problemsOfIds(part);
  return { part: problems.length > 0 ? null : part, problems };
}

/** Whether a cell is written as a number: only when the number is spelled the same. */
const asNumber = (cellText: string): string | number =>
  cellText !== "" && String(Number(cellText)) === cellText && Math.abs(Number(cellText)) <= LARGEST
    ? Number(cellText)
    : cellText;
const numbers = (given: Readonly<Record<string, string>>) =>
  Object.fromEntries(Object.entries(given).flatMap(([name, value]) => (value === "" ? [] : [[name, asNumber(value)]])));

/** A row with what differs from an empty one; its id only where it is not that of its place. */
function printedRow(given: ContourRow, usual: string): Record<string, unknown> {
  const empty = newRow(given.id);
  const cells = (Object.keys(empty) as (keyof ContourRow)[]).flatMap((name): [string, unknown][] => {
    const value = given[name];
    if (name === "id") return value === usual ? [] : [[name, value]];
    if (name === "words") return Object.keys(given.words).length === 0 ? [] : [[name, numbers(given.words)]];
    if (value === empty[name]) return [];
    return [[name, typeof value === "string" && name !== "kind" && name !== "turn" ? asNumber(value) : value]];
  });
  return Object.fromEntries(cells.toSorted(([a], [b]) => Number(b === "id") - Number(a === "id")));
}
const printedRows = (rows: readonly ContourRow[], letter: string) =>
  rows.map((each, i) => printedRow(each, `${letter}${i + 1}`));

const orNone = <T extends object>(given: T): T | undefined => (Object.keys(given).length > 0 ? given : undefined);

/** Widest line of a file, characters. */
const WIDEST = 120;

/** A member of a list or an object, without its comma; short data are on one line. */
function printed(value: unknown, key: string, indent: string): string {
  if (typeof value !== "object" || value === null) return indent + key + JSON.stringify(value);
  const isList = Array.isArray(value),
    members = Object.entries(value).filter(([, each]) => each !== undefined);
  const all = (deeper: string) =>
    members.map(([name, each]: [string, unknown]) => printed(each, isList ? "" : `${JSON.stringify(name)}: `, deeper));
  const line = isList ? `[${all("").join(", ")}]` : `{ ${all("").join(", ")} }`;
  if (indent.length + key.length + line.length < WIDEST && !line.includes("\n")) return indent + key + line;
  const [open, close] = isList ? ["[", "]"] : ["{", "}"];
  return `${indent}${key}${open}\n${all(`${indent}  `).join(",\n")}\n${indent}${close}`;
}

/** Writes a part file. Numbers are as typed. */
export function printPart(part: FinishedPart): string {
  const { name, material, inside, marks, general, blank, clamping, partsOff, unmachinedBehind, rules } = part;
  const file: Record<string, unknown> = {
    format: PART_FORMAT,
    name,
    material,
    blank: blank && ("outline" in blank ? { outline: printedRows(blank.outline, "b") } : numbers({ ...blank })),
    clamping: clamping && { kind: clamping.kind, words: numbers(clamping.words) },
    outside: printedRows(part.outside, "e"),
    inside: inside.length > 0 ? printedRows(inside, "i") : undefined,
    marks: orNone(marks),
    general: orNone(general),
    partsOff: partsOff || undefined,
    unmachinedBehind: unmachinedBehind || undefined,
    rules: orNone(rules),
  };
  const members = Object.entries(file).filter(([, value]) => value !== undefined && value !== null);
  return `{\n${members.map(([key, value]) => printed(value, `${JSON.stringify(key)}: `, "  ")).join(",\n")}\n}\n`;
}

import { readJson } from "../files/bounded.ts";
import { z } from "zod/mini";
import {
  isKnownCycle,
  newParameter,
  OWN_CELLS,
  OWN_KINDS,
  OWN_SIZES,
  readOwn,
  type OwnCycle,
  type OwnEntry,
  type OwnParameterEntry,
  type OwnReading,
} from "./own-cycle.ts";

/** All descriptions of this device, in their order. */
export type OwnList = readonly OwnEntry[];

/** The list as read: each description by its id, the valid ones by number. */
export interface OwnLibrary {
  readonly rows: ReadonlyMap<string, OwnReading>;
  readonly cycles: ReadonlyMap<number, OwnCycle>;
}

/** Reads every description. Of two with one number the first is used, the second is marked. */
export function readLibrary(list: OwnList): OwnLibrary {
  const rows = new Map<string, OwnReading>();
  const cycles = new Map<number, OwnCycle>();
  const taken = new Set<number>();
  for (const entry of list) {
    const reading = readOwn(entry);
    const isSecond = reading.number !== null && taken.has(reading.number);
    if (reading.number !== null) taken.add(reading.number);
    rows.set(
      entry.id,
      isSecond
        ? {
            ...reading,
            cycle: null,
            problems: [{ at: "number", code: "twice", text: String(reading.number) }, ...reading.problems],
          }
        : reading,
    );
    if (reading.cycle && !isSecond) cycles.set(reading.cycle.number, reading.cycle);
  }
  return { rows, cycles };
}

/** A free id of a list. */
export function freeId(all: readonly { readonly id: string }[], letter: string): string {
  const taken = new Set(all.map(({ id }) => id));
  let n = all.length + 1;
  while (taken.has(`${letter}${n}`)) n++;
  return `${letter}${n}`;
}

/** Lowest free cycle number from `from` on; null when there is none left. */
export function freeCycle(list: OwnList, from: number): number | null {
  const taken = new Set(list.map((entry) => readOwn(entry).number));
  for (let n = from; n <= 9999; n++) if (!taken.has(n) && !isKnownCycle(n)) return n;
  return null;
}

/** Merges descriptions of a file into the list: equal numbers are replaced, others appended. */
export function mergedLibrary(
  list: OwnList,
  entries: OwnList,
): { readonly list: OwnList; readonly replaced: number; readonly added: number } {
  const next = [...list];
  let replaced = 0;
  for (const entry of entries) {
    const { number } = readOwn(entry);
    const at = number === null ? -1 : next.findIndex((old) => readOwn(old).number === number);
    if (at >= 0 && at < list.length) replaced++;
    if (at >= 0) next[at] = { ...entry, id: next[at]?.id ?? entry.id };
    else next.push({ ...entry, id: freeId(next, "c") });
  }
  return { list: next, replaced, added: next.length - list.length };
}

/** A text as a number where both mean the same, else as typed. */
const written = (text: string): string | number =>
  /^-?(?:0|[1-9]\d{0,8})(?:\.\d*[1-9])?$/.test(text) && text !== "-0" ? Number(text) : text;

/** Writes the list as a file, one parameter per line, wrong input included. */
export function writeLibrary(list: OwnList): string {
  const parameter = ({ q, prompt, kind, ...rest }: OwnParameterEntry): string => {
    const cells = (["min", "max", "first", "choices"] as const).flatMap((cell) =>
      rest[cell] === "" ? [] : [[cell, cell === "choices" ? rest[cell] : written(rest[cell])]],
    );
    return `    ${JSON.stringify({ q, prompt, kind, ...Object.fromEntries(cells) })}`;
  };
  const cycles = list.map(({ number, name, parameters }) => {
    const lines = parameters.map(parameter).join(",\n");
    const inside = lines === "" ? "[]" : `[\n${lines}\n  ]`;
    return `  { "number": ${JSON.stringify(written(number))}, "name": ${JSON.stringify(name)}, "parameters": ${inside} }`;
  });
  return `{ "cycles": [\n${cycles.join(",\n")}\n] }\n`;
}

const cellText = z.union([z.string().check(z.maxLength(OWN_SIZES.cell)), z.number()]);
const optionalCell = z.nullish(cellText);
const parameterShape = z.looseObject({
  q: optionalCell,
  prompt: optionalCell,
  kind: z.nullish(z.string()),
  min: optionalCell,
  max: optionalCell,
  first: optionalCell,
  choices: optionalCell,
});
const cycleShape = z.looseObject({
  number: optionalCell,
  name: optionalCell,
  parameters: z.nullish(z.array(parameterShape).check(z.maxLength(OWN_SIZES.parameters))),
});
const fileShape = z.looseObject({ cycles: z.array(z.unknown()) });
const asText = (value: string | number | null | undefined): string =>
  value === null || value === undefined ? "" : String(value);

/** Content of a file: descriptions, and unknown names; or why it has none. */
export type OwnFile =
  | { readonly entries: OwnList; readonly leftOut: readonly string[] }
  | {
      readonly problem: "notALibrary" | "nothing" | "tooMany";
    }
  | { readonly problem: "wrongCycle"; readonly at: number };

const isOneOf = <T extends string>(all: readonly T[], text: string): text is T => all.some((each) => each === text);
const NAMES: ReadonlySet<string> = new Set(["number", "name", "parameters", "kind", ...OWN_CELLS]);

/** Reads a file of descriptions field by field, so that wrong fields are imported and shown. Never throws. */
export function readLibraryFile(text: string): OwnFile {
  let json: unknown;
  try {
    json = readJson(text);
  } catch {
    return { problem: "notALibrary" };
  }
  const file = fileShape.safeParse(json);
  if (!file.success) return { problem: "notALibrary" };
  const all = file.data.cycles;
  if (all.length === 0) return { problem: "nothing" };
  if (all.length > OWN_SIZES.cycles) return { problem: "tooMany" };
  const leftOut = new Set<string>();
  const unread = (row: object) =>
    Object.keys(row)
      .filter((key) => !NAMES.has(key))
      .forEach((key) => leftOut.add(key.slice(0, 40)));
  const entries: OwnEntry[] = [];
  for (const [i, each] of all.entries()) {
    const read = cycleShape.safeParse(each);
    if (!read.success) return { problem: "wrongCycle", at: i + 1 };
    const { number, name, parameters } = read.data;
    unread(read.data);
    entries.push({
      id: `c${i + 1}`,
      number: asText(number),
      name: asText(name),
      parameters: (parameters ?? []).map((p, n) => {
        unread(p);
        const kind = p.kind ?? "number";
        if (!isOneOf(OWN_KINDS, kind)) leftOut.add(`kind ${kind.slice(0, 40)}`);
        return newParameter(`p${n + 1}`, {
          ...Object.fromEntries(OWN_CELLS.map((each) => [each, asText(p[each])])),
          kind: isOneOf(OWN_KINDS, kind) ? kind : "number",
        });
      }),
    });
  }
  return { entries, leftOut: [...leftOut] };
}

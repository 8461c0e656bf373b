import type { LengthUnit } from "../../kernel/units.ts";
import { cellText } from "../files/bounded.ts";
import { MOST_ROWS, type readToolFile } from "../tools/tool-table-json.ts";
import type { ProposalReason, RefusedItem } from "./facts.ts";
import { isRecord, jsonOf, type ForeignContent, type NamedText, type ReadingContext } from "./foreign-file.ts";
import { foreignTool, type ForeignTool } from "./foreign-tool.ts";
import { TOOL_FILE_FORMATS, type ForeignFormat, type ToolFormatName } from "./formats.ts";
import { mounted } from "./iso13399.ts";

/** Tools of a file of another system. */
export interface ForeignTools {
  readonly format: ForeignFormat;
  readonly tools: readonly ForeignTool[];
  readonly refused: readonly RefusedItem[];
  /** The unit that was assumed for lengths without one; null where all have theirs. */
  readonly assumedUnit: LengthUnit | null;
  readonly cutShort: boolean;
}

/** A read file of a set. */
export interface ReadToolFile {
  readonly name: string;
  readonly content:
    | { readonly table: Exclude<OwnTable, { readonly problem: unknown }>; readonly text: string }
    | { readonly foreign: ForeignTools }
    | Extract<OwnTable, { readonly problem: unknown }>;
}
type OwnTable = ReturnType<typeof readToolFile>;

const NAMES = Object.keys(TOOL_FILE_FORMATS) as readonly ToolFormatName[];

interface FoundForeign {
  readonly format: ForeignFormat;
  readonly content: ForeignContent;
}
type Found = { readonly table: OwnTable } | FoundForeign;

/** Content of a text, by the first format that recognises it. */
function find(text: string, context: ReadingContext): Found {
  for (const name of NAMES) {
    const format = TOOL_FILE_FORMATS[name];
    if ("own" in format) return { table: format.own(text) };
    const content = format.foreign(text, context);
    if (content) return { format: name as ForeignFormat, content };
  }
  return { table: { problem: "notATable" } };
}

/** Whether a text refers to other files of its set, and has to be read before them. */
const refersToOthers = ({ text }: NamedText): boolean => {
  const json = text.length < 2_000_000 && text.includes('"nr"') ? jsonOf(text) : null;
  return isRecord(json) && Array.isArray(json["tools"]);
};

const endOf = (path: string) => path.replaceAll("\\", "/").split("/").at(-1)?.toLowerCase() ?? "";

/**
 * Reads a set of files: a library comes with the files that it refers to, and an insert with its holder. `unit` is that
 * of lengths whose unit is not in their file. Never throws.
 */
export function readToolFiles(files: readonly NamedText[], unit: LengthUnit): readonly ReadToolFile[] {
  const taken = new Set<NamedText>();
  const sibling = (path: string): string | null => {
    const found = files.find((file) => endOf(file.name) === endOf(path));
    if (!found) return null;
    taken.add(found);
    return found.text;
  };
  const order = [...files.filter(refersToOthers), ...files.filter((file) => !refersToOthers(file))];
  const read = order.flatMap((file): readonly Reading[] =>
    taken.has(file) ? [] : [[file.name, find(file.text, { name: file.name, unit, sibling }), file.text]],
  );
  return assembled(read).map(([name, found, text]): ReadToolFile => {
    if ("content" in found) return { name, content: foreignContent(found, unit) };
    return { name, content: "problem" in found.table ? found.table : { table: found.table, text } };
  });
}

/** Name of a file, its content, and its text. */
type Reading = readonly [name: string, found: Found, text: string];

/** An insert and a holder of two files become one tool. */
function assembled(read: readonly Reading[]): readonly Reading[] {
  const foreign = read.flatMap(([, found]) => ("content" in found ? [found] : []));
  const [first] = foreign;
  const whole = mounted(foreign.flatMap(({ content }) => content.tools));
  if (!first || foreign.length !== read.length || whole.length !== 1 || read.length < 2) return read;
  const content: ForeignContent = {
    tools: whole,
    refused: foreign.flatMap((each) => each.content.refused),
    unitAsked: foreign.some((each) => each.content.unitAsked),
  };
  return [[read.map(([name]) => name).join(", "), { format: first.format, content }, ""]];
}

function foreignContent({ format, content }: FoundForeign, unit: LengthUnit): ReadToolFile["content"] {
  const { tools, unitAsked, cutShort = false } = content;
  if (tools.length > MOST_ROWS) return { problem: "tooMany", most: MOST_ROWS };
  const made = mounted(tools).map((each) => {
    const tool = foreignTool(each);
    return { ...tool, label: cellText(tool.label), unused: tool.unused.map(cellText) };
  });
  // Without a kind there is no table for a tool, and nothing that its sizes could mean.
  const [known, unknown] = [made.filter(({ cells }) => cells.TYPE), made.filter(({ cells }) => !cells.TYPE)];
  const refused = [
    ...content.refused.map((each) => ({ ...each, label: cellText(each.label), kind: cellText(each.kind) })),
    ...unknown.map(({ label, unused }): RefusedItem => ({ label, why: "kindUnknown", kind: unused.join(", ") })),
  ];
  if (known.length === 0 && refused.length === 0) return { problem: "noRows" };
  return { foreign: { format, tools: known, refused, assumedUnit: unitAsked ? unit : null, cutShort } };
}

/**
 * Gives a free number to each tool without one, and to each whose number an earlier one of the files has. `taken`:
 * numbers of the table, which tools with a number of their own replace.
 */
export function numbered(tools: readonly ForeignTool[], taken: ReadonlySet<number>): readonly ForeignTool[] {
  const own = tools.map(({ cells }) => (cells.T === undefined ? NaN : Number(cells.T)));
  const used = new Set([...taken, ...own]);
  const first = new Set<number>();
  let next = 1;
  return tools.map((tool, i) => {
    const number = own[i] ?? NaN;
    if (!Number.isNaN(number) && !first.has(number)) {
      first.add(number);
      return tool;
    }
    while (used.has(next)) next += 1;
    used.add(next);
    const why: ProposalReason = Number.isNaN(number) ? "numberFree" : "numberTaken";
    return {
      ...tool,
      cells: { ...tool.cells, T: String(next) },
      origins: { ...tool.origins, T: { from: tool.origins.T?.from ?? "", why: [why] } },
    };
  });
}

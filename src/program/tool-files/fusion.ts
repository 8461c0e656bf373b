import type { FileProperties, FileProperty, FileTool, RefusedItem } from "./facts.ts";
import { unitOf } from "./facts.ts";
import { isRecord, jsonOf, MOST_ITEMS, type ForeignContent, type ReadingContext } from "./foreign-file.ts";
import { camTool } from "./cam-tool.ts";

type Json = Readonly<Record<string, unknown>>;

const isProperty = (value: unknown): value is FileProperty["value"] =>
  typeof value === "string" || typeof value === "number" || typeof value === "boolean";

/** Parts of a tool with its properties; `expressions` are named as in formulas, tool_cornerRadius. */
const PARTS = ["geometry", "holder", "post-process", "expressions"] as const;
const MOST_PROPERTIES = 300;

function propertiesOf(tool: Json): FileProperties {
  const found = new Map<string, FileProperty>();
  for (const part of PARTS) {
    const record = tool[part];
    // The holder of a milling tool is a list of segments.
    if (!isRecord(record) || (part === "holder" && "segments" in record)) continue;
    for (const [name, value] of Object.entries(record).slice(0, MOST_PROPERTIES))
      if (isProperty(value)) found.set(part === "expressions" ? name : `${part}.${name}`, { value });
  }
  return found;
}

const textOf = (value: unknown) => (typeof value === "string" ? value.slice(0, 200) : "");

const isTool = (item: FileTool | RefusedItem): item is FileTool => "facts" in item;

/** Sorts what was read. */
export const sorted = (items: readonly (FileTool | RefusedItem)[]): Pick<ForeignContent, "tools" | "refused"> => ({
  tools: items.filter(isTool),
  refused: items.filter((item): item is RefusedItem => !isTool(item)),
});

/** Reads a tool library of Fusion (JSON, also the content of .tools); null when the text is none. */
export function readFusion(text: string, { unit }: ReadingContext): ForeignContent | null {
  const json = jsonOf(text);
  const list = isRecord(json) ? (json["data"] ?? (isRecord(json["geometry"]) ? [json] : null)) : null;
  const items = Array.isArray(list) ? (list as readonly unknown[]) : [];
  if (items.length === 0 || !items.every((item) => isRecord(item) && typeof item["type"] === "string")) return null;
  const tools = (items as readonly Json[]).slice(0, MOST_ITEMS);
  return {
    ...sorted(
      tools.map((tool) =>
        camTool(propertiesOf(tool), unitOf(textOf(tool["unit"])) ?? unit, {
          type: textOf(tool["type"]),
          description: textOf(tool["description"]),
          product: textOf(tool["product-id"]),
        }),
      ),
    ),
    unitAsked: tools.some((tool) => unitOf(textOf(tool["unit"])) === null),
  };
}

/** Title of a column in a sheet of Fusion: `Corner Radius (tool_cornerRadius)`. */
const TITLE = /\(((?:tool|holder|preset)_\w+)\)\s*$/;

/** Reads the sheet that Fusion exports, from its cells; one row for each preset of a tool. Null when it is none. */
export function fusionSheet(rows: readonly (readonly string[])[], { unit }: ReadingContext): ForeignContent | null {
  const names = (rows[0] ?? []).map((title) => TITLE.exec(title)?.[1] ?? "");
  if (!names.includes("tool_type")) return null;
  const seen = new Set<string>();
  let unitAsked = false;
  const items = rows.slice(1, MOST_ITEMS + 1).flatMap((row) => {
    const cell = (name: string) => row[names.indexOf(name)] ?? "";
    const key = ["tool_index", "tool_number", "tool_description", "tool_type"].map(cell).join("\n");
    if (seen.has(key) || cell("tool_type") === "") return [];
    seen.add(key);
    const own = unitOf(cell("tool_unit"));
    unitAsked ||= own === null;
    const properties = new Map(names.map((name, i) => [name, { value: (row[i] ?? "").trim() }]));
    const about = { type: cell("tool_type"), description: cell("tool_description"), product: cell("tool_productId") };
    return [camTool(properties, own ?? unit, about)];
  });
  return { ...sorted(items), unitAsked };
}

import { isPart21, readPart21, type Part21Entity, type Part21Record, type Part21Value } from "../files/part21.ts";
import { listIn, numberIn, referenceIn, textIn } from "../files/part21-values.ts";
import { unitOf, type FileProperty, type FileTool, type RefusedItem } from "./facts.ts";
import { MOST_ITEMS, type ForeignContent, type ReadingContext } from "./foreign-file.ts";
import { isoTool } from "./iso13399.ts";

/*
 * Tool data of ISO 13399 as exchange files of Part 21 (schema CUTTING_TOOL_SCHEMA_ARM), alone or in a GTC package. The
 * makers' files name each value by the symbol of its property: NUMERICAL_VALUE('DC', $, #unit, '6.35'). Files that
 * refer to the dictionary by codes alone are not guessed. Sources: docs/decisions, tool files of other systems.
 */

type Entities = ReadonlyMap<number, Part21Entity>;

const recordAt = (entities: Entities, id: number | null): Part21Record | undefined =>
  id === null ? undefined : entities.get(id)?.[0];

/** Depth of references that are followed. */
const DEEPEST = 6;

/** Text of a value: a string, or a string in the first language. */
function stringAt(entities: Entities, value: Part21Value, depth = 0): string {
  const plain = textIn(value);
  if (plain !== null) return plain.trim();
  const record = recordAt(entities, referenceIn(value));
  if (!record || depth > DEEPEST) return "";
  const parts = record.type === "MULTI_LANGUAGE_STRING" ? [...record.values].reverse() : record.values;
  for (const part of parts) {
    const text = stringAt(entities, part, depth + 1);
    if (text !== "") return text;
  }
  return "";
}

/** The item that something belongs to: an item, its version or its definition. */
function itemOf(entities: Entities, value: Part21Value, depth = 0): number | null {
  const id = referenceIn(value);
  const record = recordAt(entities, id);
  if (!record || depth > DEEPEST) return null;
  if (record.type === "ITEM") return id;
  if (record.type !== "ITEM_VERSION" && record.type !== "ITEM_DEFINITION") return null;
  for (const each of record.values) {
    const found = itemOf(entities, each, depth + 1);
    if (found !== null) return found;
  }
  return null;
}

const VALUES = ["NUMERICAL_VALUE", "STRING_VALUE"];
const LEADING = ["PROPERTY_VALUE_REPRESENTATION", ...VALUES];

/** The values that an association leads to. */
function valuesOf(entities: Entities, value: Part21Value, depth = 0): readonly Part21Record[] {
  const record = recordAt(entities, referenceIn(value));
  if (!record || depth > DEEPEST || !LEADING.includes(record.type)) return [];
  if (VALUES.includes(record.type)) return [record];
  return record.values.flatMap((each) => valuesOf(entities, each, depth + 1));
}

function propertyOf(entities: Entities, record: Part21Record): readonly [string, FileProperty] | null {
  const name = textIn(record.values[0])?.trim() ?? "";
  const last = record.values.at(-1);
  const value = numberIn(last) ?? textIn(last);
  if (name === "" || name.length > 40 || value === null || value === "") return null;
  const unit = unitOf(textIn(recordAt(entities, referenceIn(record.values[2]))?.values[0]) ?? "");
  return [name.toUpperCase(), { value, ...(unit && { unit }) }];
}

/** Roles of an item that is no tool: what carries one, or consists of several. */
const CARRIERS = ["adaptive item", "assembly item", "assembly", "tool assembly", "spare part"];

/** Reads tool data of ISO 13399; null when the text is no Part 21 file, or one without items. */
export function readPart21Tools(text: string, { unit }: ReadingContext): ForeignContent | null {
  if (!isPart21(text)) return null;
  const { entities, faultCount, faults } = readPart21(text);
  const all = [...entities].flatMap(([id, entity]) => entity.map((record) => ({ id, record })));
  const items = all.filter(({ record }) => record.type === "ITEM").slice(0, MOST_ITEMS);
  if (items.length === 0) return null;
  const properties = new Map(items.map(({ id }) => [id, new Map<string, FileProperty>()]));
  const placed = new Set<Part21Record>();
  const place = (item: number, record: Part21Record) => {
    const found = propertyOf(entities, record);
    placed.add(record);
    if (found) properties.get(item)?.set(...found);
  };
  for (const { record } of all) {
    if (record.type !== "PROPERTY_VALUE_ASSOCIATION") continue;
    const item = record.values.map((value) => itemOf(entities, value)).find((found) => found !== null);
    const values = record.values.flatMap((value) => [value, ...listIn(value)]).flatMap((v) => valuesOf(entities, v));
    if (item !== undefined) for (const value of values) place(item, value);
  }
  const [only] = items;
  // Without associations all values belong to the one item.
  if (only && items.length === 1)
    for (const { record } of all) if (VALUES.includes(record.type) && !placed.has(record)) place(only.id, record);

  const roles = new Map<number, string>();
  for (const { record } of all)
    if (record.type === "SPECIFIC_ITEM_CLASSIFICATION")
      for (const each of listIn(record.values[0])) {
        const [id, role] = [referenceIn(each), textIn(record.values[1])?.trim().toLowerCase() ?? ""];
        if (id !== null && role.includes("item")) roles.set(id, role);
      }
  const tools: FileTool[] = [];
  const refused: RefusedItem[] = [];
  let unitAsked = false;
  for (const { id, record } of items) {
    const [name, key, product] = record.values.map((value) => stringAt(entities, value));
    const texts = [product ?? "", name ?? "", key ?? ""].filter((each) => each !== "");
    const label = (texts[0] ?? `#${id}`).slice(0, 200);
    const own = properties.get(id) ?? new Map<string, FileProperty>();
    const role = roles.get(id) ?? "";
    if (CARRIERS.includes(role)) refused.push({ label, why: "holder", kind: role });
    else if (own.size === 0) refused.push({ label, why: "nothingKnown", kind: role });
    else {
      const codes = ["MIID", "CUTINT_MASTER"].flatMap((symbol) => String(own.get(symbol)?.value ?? "") || []);
      const made = isoTool(own, unit, { label, texts: [...texts, ...codes] });
      unitAsked ||= made.unitAsked;
      tools.push(made.tool);
    }
  }
  return { tools, refused, unitAsked, cutShort: faultCount > 0 && faults.some(({ code }) => code === "cut") };
}

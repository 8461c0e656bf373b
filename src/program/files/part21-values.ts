import type { Part21Entity, Part21Record, Part21Value } from "./part21.ts";

/** Number of an entity that a value refers to; null for anything else. */
export const referenceIn = (v: Part21Value): number | null =>
  typeof v === "object" && v !== null && "kind" in v && v.kind === "reference" ? v.id : null;

/** Name of an enumeration, T and F of a boolean; null for anything else. */
export const enumerationIn = (v: Part21Value): string | null =>
  typeof v === "object" && v !== null && "kind" in v && v.kind === "enumeration" ? v.name : null;

/** Elements of a list; none for anything else. */
export const listIn = (v: Part21Value): readonly Part21Value[] => (isList(v) ? v : []);
const isList = (v: Part21Value): v is readonly Part21Value[] => Array.isArray(v);

/** A number, also of a typed parameter such as LENGTH_MEASURE(25.4); null for anything else. */
export function numberIn(v: Part21Value): number | null {
  if (typeof v === "number") return v;
  if (typeof v !== "object" || v === null || !("kind" in v) || v.kind !== "record") return null;
  const inside = v.values[0];
  return v.values.length === 1 && typeof inside === "number" ? inside : null;
}

/** Text, also of a typed parameter such as LABEL('…'); null for anything else. */
export function textIn(v: Part21Value): string | null {
  if (typeof v === "string") return v;
  if (typeof v !== "object" || v === null || !("kind" in v) || v.kind !== "record") return null;
  const inside = v.values[0];
  return v.values.length === 1 && typeof inside === "string" ? inside : null;
}

/** The record of this type in an entity. */
export const recordOf = (entity: Part21Entity | undefined, type: string): Part21Record | undefined =>
  entity?.find((r) => r.type === type);

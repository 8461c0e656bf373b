import { z } from "zod/mini";
import { JSON_BOUNDS, readJson, type UnreadRow } from "../../program/files/bounded.ts";
import { storedKeys, storedText } from "./storage.ts";

/*
 * Data of records that could not be read, beside the record. They stay until the operator deletes them: a later edition
 * may read them, and nobody else can say what they are worth.
 */

const ENDING = "/damaged";
const rows = z.array(z.object({ name: z.string(), raw: z.unknown() }));

/** What is set aside of a record; a text of an earlier edition counts as one row. */
function rowsOf(key: string): readonly UnreadRow[] {
  const text = storedText(key + ENDING).get() ?? null;
  if (text === null) return [];
  try {
    const raw = readJson(text, JSON_BOUNDS);
    return rows.safeParse(raw).data ?? [{ name: key, raw }];
  } catch {
    return [{ name: key, raw: text }];
  }
}

const put = (key: string, all: readonly UnreadRow[]): boolean =>
  storedText(key + ENDING).set(all.length > 0 ? JSON.stringify(all) : null);

/** Adds rows of a record to those set aside; false if the browser refuses. */
export const setAside = (key: string, more: readonly UnreadRow[]): boolean => put(key, [...rowsOf(key), ...more]);

/** A row that is set aside: its record, and its place there. */
export interface AsideRow extends UnreadRow {
  readonly record: string;
  readonly at: number;
}

/** Everything that is set aside of records. */
export const asideRows = (): readonly AsideRow[] =>
  storedKeys("")
    .filter((key) => key.endsWith(ENDING))
    .flatMap((key) => {
      const record = key.slice(0, -ENDING.length);
      return rowsOf(record).map((row, at) => ({ ...row, record, at }));
    });

/** Deletes a row, at the operator's request only. */
export const forgetAside = ({ record, at }: AsideRow): void =>
  void put(
    record,
    rowsOf(record).filter((_, i) => i !== at),
  );

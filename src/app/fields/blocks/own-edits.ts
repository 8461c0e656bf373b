import type { StatementOf } from "../../../nc/statement.ts";
import {
  describedFrom,
  newParameter,
  OWN_SIZES,
  type OwnEntry,
  type OwnParameterEntry,
} from "../../../program/edits/own-cycle.ts";
import { freeCycle, freeId, mergedLibrary, type OwnList } from "../../../program/edits/own-library.ts";
import { libraryOf } from "../../document/own-reading.ts";
import { editOwn, useOwn } from "../../document/own-store.ts";

/** Numbers of own cycles usually begin here: those below are the control's. */
const FIRST_OWN = 300;

const changed = (id: string, change: (entry: OwnEntry) => OwnEntry, place: string | null = null): void =>
  editOwn((list) => list.map((entry) => (entry.id === id ? change(entry) : entry)), place);

export const isFull = (list: OwnList): boolean => list.length >= OWN_SIZES.cycles;
export const hasRoom = (entry: OwnEntry): boolean => entry.parameters.length < OWN_SIZES.parameters;

/** Sets the typed number or name. */
export const setHead = (id: string, field: "number" | "name", text: string): void =>
  changed(id, (entry) => ({ ...entry, [field]: text }), `own ${id} ${field}`);

/** Sets the typed text of a parameter field. */
export const setOwnParameter = (id: string, parameter: string, change: Partial<Omit<OwnParameterEntry, "id">>): void =>
  changed(
    id,
    (entry) => ({ ...entry, parameters: entry.parameters.map((p) => (p.id === parameter ? { ...p, ...change } : p)) }),
    `own ${id} ${parameter} ${Object.keys(change).join()}`,
  );

/** Adds a description with the next free number; returns its id. */
export function addOwn(): string {
  const { list } = useOwn.getState();
  const id = freeId(list, "c");
  const number = freeCycle(list, FIRST_OWN);
  editOwn(() => [
    ...list,
    { id, number: number === null ? "" : String(number), name: "", parameters: [newParameter("p1")] },
  ]);
  return id;
}

/** Describes the cycle of a block: the existing description, or one proposed from its text. Returns its id. */
export function describeBlock(s: StatementOf<"cycle">): string {
  const { list } = useOwn.getState();
  const { rows } = libraryOf(list);
  const known = list.find((entry) => rows.get(entry.id)?.number === s.cycle);
  if (known) return known.id;
  const id = freeId(list, "c");
  editOwn(() => [...list, describedFrom(s, id)]);
  return id;
}

/** Duplicates a description below the original with the next free number; returns the id of the copy. */
export function duplicateOwn(id: string): string {
  const { list } = useOwn.getState();
  const at = list.findIndex((each) => each.id === id);
  const entry = list[at];
  if (!entry) return id;
  const copy = freeId(list, "c");
  const number = freeCycle(list, libraryOf(list).rows.get(id)?.number ?? FIRST_OWN);
  editOwn(() => list.toSpliced(at + 1, 0, { ...entry, id: copy, number: number === null ? "" : String(number) }));
  return copy;
}

/** Removes a description; returns the id of the one now in its place, null if none is left. */
export function removeOwn(id: string): string | null {
  const { list } = useOwn.getState();
  const at = list.findIndex((each) => each.id === id);
  editOwn(() => list.filter((each) => each.id !== id));
  return (list[at + 1] ?? list[at - 1])?.id ?? null;
}

/** Adds a parameter at the end with the next Q number; returns its id. */
export function addParameter(entry: OwnEntry): string {
  const id = freeId(entry.parameters, "p");
  const last = /^\s*Q?(\d{1,4})\s*$/i.exec(entry.parameters.at(-1)?.q ?? "")?.[1];
  const taken = new Set(entry.parameters.map((p) => p.q.trim().toUpperCase()));
  const q = last === undefined ? "" : `Q${Number(last) + 1}`;
  changed(entry.id, (old) => ({
    ...old,
    parameters: [...old.parameters, newParameter(id, { q: taken.has(q) ? "" : q })],
  }));
  return id;
}

export const removeParameter = (id: string, parameter: string): void =>
  changed(id, (entry) => ({ ...entry, parameters: entry.parameters.filter((p) => p.id !== parameter) }));

/** Moves a parameter one place; prompts and text follow this order. */
export function moveParameter(id: string, parameter: string, by: 1 | -1): void {
  changed(id, (entry) => {
    const at = entry.parameters.findIndex((p) => p.id === parameter);
    const moved = entry.parameters[at];
    const to = at + by;
    if (!moved || to < 0 || to >= entry.parameters.length) return entry;
    return { ...entry, parameters: entry.parameters.toSpliced(at, 1).toSpliced(to, 0, moved) };
  });
}

/** Imports descriptions of a file over those of the list, as one step of undo; null if the list has no room. */
export function takeEntries(entries: OwnList): { readonly replaced: number; readonly added: number } | null {
  const made = mergedLibrary(useOwn.getState().list, entries);
  if (made.list.length > OWN_SIZES.cycles) return null;
  editOwn(() => made.list);
  return made;
}

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

/** The typed text of number or name. */
export const setHead = (id: string, field: "number" | "name", text: string): void =>
  changed(id, (entry) => ({ ...entry, [field]: text }), `own ${id} ${field}`);

/** The typed text of one field of a parameter. */
export const setOwnParameter = (id: string, parameter: string, change: Partial<Omit<OwnParameterEntry, "id">>): void =>
  changed(
    id,
    (entry) => ({ ...entry, parameters: entry.parameters.map((p) => (p.id === parameter ? { ...p, ...change } : p)) }),
    `own ${id} ${parameter} ${Object.keys(change).join()}`,
  );

/** A description with the next free number; gives its id. */
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

/** The description of the cycle of a block: the one that there is, or what its text proposes; gives its id. */
export function describeBlock(s: StatementOf<"cycle">): string {
  const { list } = useOwn.getState();
  const { rows } = libraryOf(list);
  const known = list.find((entry) => rows.get(entry.id)?.number === s.cycle);
  if (known) return known.id;
  const id = freeId(list, "c");
  editOwn(() => [...list, describedFrom(s, id)]);
  return id;
}

/** The same once more, under it, with the next free number; gives the id of the copy. */
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

/** Takes a description out; gives the id of the one that is then in its place, null when none is left. */
export function removeOwn(id: string): string | null {
  const { list } = useOwn.getState();
  const at = list.findIndex((each) => each.id === id);
  editOwn(() => list.filter((each) => each.id !== id));
  return (list[at + 1] ?? list[at - 1])?.id ?? null;
}

/** Another parameter at the end; its Q number goes on from the last one. Gives its id. */
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

/** Puts a parameter one place on or back; the order is that of prompts and text. */
export function moveParameter(id: string, parameter: string, by: 1 | -1): void {
  changed(id, (entry) => {
    const at = entry.parameters.findIndex((p) => p.id === parameter);
    const moved = entry.parameters[at];
    const to = at + by;
    if (!moved || to < 0 || to >= entry.parameters.length) return entry;
    return { ...entry, parameters: entry.parameters.toSpliced(at, 1).toSpliced(to, 0, moved) };
  });
}

/** Descriptions of a file, over those of the list: one step of undo. Null where the list has no room for them. */
export function takeEntries(entries: OwnList): { readonly replaced: number; readonly added: number } | null {
  const made = mergedLibrary(useOwn.getState().list, entries);
  if (made.list.length > OWN_SIZES.cycles) return null;
  editOwn(() => made.list);
  return made;
}

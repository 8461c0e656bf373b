import { useLayoutEffect, useRef, type KeyboardEvent, type RefObject } from "react";
import { beginsTolerance } from "./begun-field.ts";

const FIELDS = "input[data-field], select[data-field]";
type Field = HTMLInputElement | HTMLSelectElement;

/** Actions of the keys on the rows of the table. */
export interface RowActions {
  readonly add: () => void;
  readonly insert: () => void;
  readonly duplicate: () => void;
  readonly remove: () => void;
  readonly move: (by: 1 | -1) => void;
}

function focusField(field: Field | undefined): void {
  field?.focus();
  if (field instanceof HTMLInputElement) field.select();
}

/** Focuses the same field of the next or previous row; its first field if it has no such one. */
function sameField(table: HTMLElement, from: Field, by: 1 | -1): void {
  const lines = [...table.querySelectorAll("tr.contour-line")];
  const line = lines[lines.findIndex((l) => l.contains(from)) + by];
  const fields = [...(line?.querySelectorAll<Field>(FIELDS) ?? [])];
  focusField(
    fields.find((f) => f.dataset["field"] === from.dataset["field"]) ??
      fields.find((f) => f instanceof HTMLInputElement),
  );
}

/**
 * Keys of the table: Enter to the next field, arrows between rows, Alt and arrows to move, R and C for corners, and the
 * rows' own commands.
 */
export function useTableKeys(
  table: RefObject<HTMLElement | null>,
  actions: RowActions & { readonly corner: (kind: "RND" | "CHF") => void },
): (e: KeyboardEvent) => void {
  return (e) => {
    const at = e.target;
    const root = table.current;
    if (!root || !(at instanceof HTMLInputElement || at instanceof HTMLSelectElement)) return;
    const by = e.key === "ArrowDown" ? 1 : e.key === "ArrowUp" ? -1 : 0;
    const take = (act: () => void) => {
      e.preventDefault();
      e.stopPropagation();
      act();
    };
    if (by !== 0 && e.altKey) return take(() => actions.move(by));
    if (by !== 0 && at instanceof HTMLInputElement) return take(() => sameField(root, at, by));
    if (e.key === "Insert") return take(actions.insert);
    if (e.ctrlKey && e.key.toLowerCase() === "d") return take(actions.duplicate);
    if (e.ctrlKey && e.key === "Delete") return take(actions.remove);
    const isText = !(at instanceof HTMLInputElement) || beginsTolerance(at.value);
    const letter = e.ctrlKey || e.altKey || e.metaKey || isText ? "" : e.key.toLowerCase();
    // QR1 is the name of a parameter.
    if (letter === "r" && !/q$/i.test(at.value)) return take(() => actions.corner("RND"));
    if (letter === "c") return take(() => actions.corner("CHF"));
    if (e.key === "Enter" && !e.ctrlKey && !e.altKey) {
      const fields = [...root.querySelectorAll<Field>(FIELDS)];
      const next = fields[fields.indexOf(at) + 1];
      return take(() => (next ? focusField(next) : actions.add()));
    }
  };
}

/** Focuses a row once it is rendered: the same field, or the row's first number. */
export function useRowFocus(table: RefObject<HTMLElement | null>): (row: string | null, field?: string) => void {
  const asked = useRef<{ row: string; field: string | undefined } | null>(null);
  useLayoutEffect(() => {
    const wanted = asked.current;
    asked.current = null;
    if (!wanted) return;
    const fields = [...(table.current?.querySelectorAll<Field>(FIELDS) ?? [])].filter(
      (f) => f.dataset["row"] === wanted.row,
    );
    focusField(
      fields.find((f) => f.dataset["field"] === wanted.field) ??
        fields.find((f) => f instanceof HTMLInputElement) ??
        fields[0],
    );
  });
  return (row, field) => {
    asked.current = row === null ? null : { row, field };
  };
}

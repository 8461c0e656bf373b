import { useEffect, useRef } from "react";
import { KEY_LIST, type KeyPlace } from "./key-list.ts";

/** An entry of the list of shortcuts: its place and its name there. */
export type KeyName = { [P in KeyPlace]: `${P}.${keyof (typeof KEY_LIST)[P] & string}` }[KeyPlace];

/**
 * Something that can be done from anywhere on the page. It is declared where it is done, while that part is on the
 * screen; its shortcut, the sheet of shortcuts and the command palette all follow from the declaration.
 */
export interface Action {
  /** Its entry in the list of shortcuts, or a name of its own. */
  readonly id: KeyName | `do.${string}`;
  /** Name in the screen language; by default that of the sheet of shortcuts. */
  readonly name?: string;
  /** Further words that find it. */
  readonly words?: readonly string[];
  /** The palette does not list it: it repeats another one, or is the palette itself. */
  readonly isUnlisted?: boolean;
  /** Its keys work in dialogs too; a dialog keeps all others. */
  readonly worksInDialogs?: boolean;
  /** Does it; `at` is the element with the focus if a key was pressed. */
  readonly run: (at: Element | null) => void;
}

const declared = new Set<() => readonly Action[]>();

/** Declares actions until the returned function is called. */
export function declareActions(list: () => readonly Action[]): () => void {
  declared.add(list);
  return () => void declared.delete(list);
}

/** Declares actions while the component is on the screen. */
export function useActions(actions: readonly Action[]): void {
  // No effect event: the palette reads the actions while it renders.
  const newest = useRef(actions);
  useEffect(() => {
    newest.current = actions;
  }, [actions]);
  useEffect(() => declareActions(() => newest.current), []);
}

/** Every action that is possible now. A later declaration replaces an earlier one of the same id. */
export function possibleActions(): readonly Action[] {
  const byId = new Map([...declared].flatMap((list) => list().map((action) => [action.id, action] as const)));
  return [...byId.values()];
}

/** The keys of an action; none if it has no shortcut. */
export function keysOf(id: Action["id"]): readonly string[] {
  const [place = "", name = ""] = id.split(".");
  const all: Readonly<Record<string, Readonly<Record<string, readonly string[]>>>> = KEY_LIST;
  return all[place]?.[name] ?? [];
}

type Pressed = Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "altKey" | "shiftKey">;

/** Whether a combination of the list of shortcuts was pressed. Command counts as Ctrl. */
export function isPressed(combination: string, event: Pressed): boolean {
  const parts = combination.split(" ");
  const key = parts.at(-1) ?? "";
  const has = (modifier: string) => parts.slice(0, -1).includes(modifier);
  // A sign may need Shift or not, depending on the keyboard.
  const isSign = key.length === 1 && key.toLowerCase() === key.toUpperCase();
  return (
    event.key.toLowerCase() === key.toLowerCase() &&
    (event.ctrlKey || event.metaKey) === has("Ctrl") &&
    event.altKey === has("Alt") &&
    (isSign || event.shiftKey === has("Shift"))
  );
}

/** Controls in which a sign is text. A choice takes none, and no value of a prompt has one. */
const TYPED_INTO = "input:not([type=radio], [type=checkbox], .value), select, textarea, [contenteditable=true]";

/** Runs the action of a pressed shortcut. A dialog keeps its keys; a key without Ctrl or F types into a field. */
export function onActionKey(event: KeyboardEvent): void {
  const { target, key } = event;
  if (event.defaultPrevented || !(target instanceof Element)) return;
  const inDialog = target.closest("dialog") !== null;
  const types = key.length === 1 && !event.ctrlKey && !event.metaKey && target.closest(TYPED_INTO) !== null;
  const action = types
    ? undefined
    : possibleActions().find(
        ({ id, worksInDialogs = false }) =>
          (worksInDialogs || !inDialog) && keysOf(id).some((combination) => isPressed(combination, event)),
      );
  if (!action) return;
  event.preventDefault();
  action.run(target);
}

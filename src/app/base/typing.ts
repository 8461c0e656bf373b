import { startTransition, useState } from "react";
import { flushSync } from "react-dom";
import { createStore, useStore, type StateCreator, type StoreApi, type UseBoundStore } from "zustand";
import { afterPicture } from "./after-picture.ts";
import { catchUp, useFollowed } from "./followed.ts";
import { once } from "./once.ts";

/*
 * While somebody types, the field and the path are drawn first. Everything else that follows the work is told of the
 * change when that picture is painted, turn by turn, or at once before anything else happens on the page: nothing is
 * ever pressed that knows less than what was typed.
 */

let isTyping = false;
/**
 * Who is told of what was typed, each turn in a task of its own: all of them together are a long one on a slow device.
 */
const TURNS = ["work", "text", "result"] as const;
type Turn = (typeof TURNS)[number];
const held = new Map<() => void, Turn>();
let callOff = (): void => undefined;
/** How often what was typed has been told. */
const told = createStore<{ readonly count: number; readonly isAll: boolean }>(() => ({ count: 0, isAll: true }));

function tellThose(turns: readonly Turn[]): void {
  callOff();
  const due = [...held].filter(([, turn]) => turns.includes(turn));
  for (const [tell] of due) held.delete(tell);
  for (const [tell] of due) tell();
  if (held.size === 0 && !told.getState().isAll) told.setState(({ count }) => ({ count: count + 1, isAll: true }));
}

const release = (): void => tellThose(TURNS);

function releaseByTurns(): void {
  const next = TURNS.find((turn) => [...held.values()].includes(turn));
  if (!next) return;
  if (next === "result") byAndBy(() => tellThose([next]));
  else tellThose([next]);
  const timer = setTimeout(releaseByTurns);
  callOff = () => clearTimeout(timer);
}

/** True while what was told last may not be rendered yet. */
let isBehind = false;

/**
 * Changes a result that comes by itself: what follows it is rendered by and by, or before somebody does something with
 * it.
 */
export function byAndBy(change: () => void): void {
  tellBeforeActing();
  isBehind = true;
  startTransition(change);
}

function tellAll(): void {
  release();
  if (isBehind) catchUp();
  isBehind = false;
}

/** Keys that go on with a number. */
const typesOn = ({ key, ctrlKey, metaKey, altKey, target }: KeyboardEvent): boolean =>
  target instanceof HTMLInputElement &&
  !ctrlKey &&
  !metaKey &&
  !altKey &&
  (key.length === 1 || key === "Backspace" || key === "Delete");

/**
 * From now on everything is told what was typed before a key, a finger or the loss of the keyboard does something else.
 */
const tellBeforeActing = once(() => {
  const tell = (event: Event) => {
    if ((held.size > 0 || isBehind) && !(event instanceof KeyboardEvent && typesOn(event))) flushSync(tellAll);
  };
  for (const act of ["keydown", "pointerdown", "click", "focusout", "paste", "drop"] as const)
    addEventListener(act, tell, { capture: true });
});

/** Makes a change that somebody types; whether anything is held back of it. */
export function whileTyping(change: () => void): boolean {
  isTyping = true;
  try {
    change();
  } finally {
    isTyping = false;
  }
  if (held.size === 0) return false;
  tellBeforeActing();
  told.setState({ isAll: false });
  callOff();
  callOff = afterPicture(releaseByTurns);
  return true;
}

/**
 * Leaves the showing of a text for when what is typed just now is told; false where nobody types, and it is to be done
 * at once.
 */
export function behindTyping(run: () => void): boolean {
  if (isTyping) held.set(run, "text");
  return isTyping;
}

/**
 * A store whose followers among the components see what is typed a moment later; everything else reads and hears it at
 * once. A result that comes by itself while something is held waits its turn; any other change tells all that is held
 * with it.
 */
export function heldWhileTyping<S>(
  begin: StateCreator<S>,
  of: "work" | "result" = "work",
): UseBoundStore<StoreApi<S>> & { readonly atOnce: UseBoundStore<StoreApi<S>> } {
  const store = createStore(begin),
    shown = createStore(() => store.getState());
  const tell = () => shown.setState(store.getState(), true);
  store.subscribe(() => {
    const waits = isTyping || (of === "result" && held.size > 0);
    held.set(tell, of);
    if (!waits) release();
  });
  const follow = of === "result" ? useFollowed : useStore;
  const bound = (api: StoreApi<S>) => Object.assign(<T>(selector: (state: S) => T) => follow(api, selector), store);
  return Object.assign(bound(shown) as UseBoundStore<StoreApi<S>>, {
    atOnce: bound(store) as UseBoundStore<StoreApi<S>>,
  });
}

/**
 * The text of a field, and its typing: until the work is told what was typed the field itself knows it. `of`: which
 * place.
 */
export function useTyping(
  of: string,
  text: string,
  set: (text: string) => void,
): readonly [text: string, type: (text: string) => void] {
  const times = useStore(told, (s) => s.count);
  const [newest, follow] = useState({ of, times: -1, text });
  const type = (next: string) => {
    if (whileTyping(() => set(next))) follow({ of, times, text: next });
  };
  return [newest.of === of && newest.times === times ? newest.text : text, type];
}

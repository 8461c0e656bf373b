import { startTransition, useEffect, useEffectEvent, useRef, useState, type ReactNode } from "react";
import { flushSync } from "react-dom";
import { createStore, useStore, type StateCreator, type StoreApi, type UseBoundStore } from "zustand";
import { once } from "./once.ts";

/*
 * While somebody types, the field and the path are drawn first. Everything else that follows the work hears of the
 * change when that picture is painted, turn by turn, or at once before anything else happens on the page: nothing is
 * ever pressed that knows less than what was typed.
 *
 * React's `useDeferredValue` was tried for all of it: it renders between the key and its picture, each component renders
 * with the key all the same, and nothing brings a deferred value to its newest before a press (docs/decisions/0033).
 */

/** What is done when the next picture is painted, all of it together; by the calls that asked for it. */
const afterPainting = new Map<object, () => void>();

/** A message comes behind the painting; a timer that is set with it would come before. */
const painted = new MessageChannel();
painted.port1.onmessage = () => {
  const due = [...afterPainting.values()];
  afterPainting.clear();
  startTransition(() => due.forEach((each) => each()));
};

/**
 * Runs when the next picture is painted, soon where none is: nobody looks at a hidden page. Gives the way to call it
 * off.
 */
export function afterPicture(run: () => void): () => void {
  const tell = () => painted.port2.postMessage(null);
  if (afterPainting.size === 0) {
    if (document.hidden) tell();
    else requestAnimationFrame(tell);
  }
  const call = {};
  afterPainting.set(call, run);
  return () => {
    if (afterPainting.has(call)) afterPainting.set(call, () => undefined);
  };
}

/**
 * The value as it stood when the last picture was painted: it follows a moment after a key, whose picture does not wait
 * for it.
 */
export function useLater<T>(value: T): T {
  const [late, follow] = useState({ value });
  const isLate = !Object.is(late.value, value);
  useEffect(() => (isLate ? afterPicture(() => follow({ value })) : undefined), [isLate, value]);
  return late.value;
}

/**
 * What may come a moment after a key, when the path is drawn: until then it shows the work as it was.
 * Nothing that is typed into belongs here, a field shows its key at once.
 */
export const Late = ({ children }: { readonly children: ReactNode }): ReactNode => useLater(children);

/** Bring each component to the newest state. */
const followers = new Set<() => void>();

/**
 * What a component shows of a store, as its own state: what a transition changes in the store is rendered by and by, and
 * all who follow it change together. Zustand's own hook renders every change in one piece, however long that takes on a
 * slow device.
 */
function useFollowed<S, T>(store: StoreApi<S>, select: (state: S) => T): T {
  const [seen, see] = useState(() => ({ state: store.getState() }));
  /**
   * What was rendered last, or is about to be. A state that looks the same to this component takes its place in
   * silence.
   */
  const last = useRef(seen);
  const look = useEffectEvent(() => {
    const state = store.getState();
    if (Object.is(select(last.current.state), select(state))) last.current.state = state;
    else see((last.current = { state }));
  });
  const bring = useEffectEvent(() => see(last.current));
  useEffect(() => {
    look();
    const stop = store.subscribe(() => look()),
      whenAsked = () => bring();
    followers.add(whenAsked);
    return () => {
      stop();
      followers.delete(whenAsked);
    };
  }, [store]);
  return select(seen.state);
}

/**
 * Who hears of what was typed, each turn in a task of its own: all of them together are a long one on a slow device.
 */
const TURNS = ["work", "text", "result"] as const;
type Turn = (typeof TURNS)[number];

/** What is held back of what was typed. */
const held = {
  tells: new Map<() => void, Turn>(),
  isTyping: false,
  /** What was passed on last may not be rendered yet. */
  isBehind: false,
  callOff: (): void => undefined,
};
/** How often all that was typed has been passed on. */
const passedOn = createStore<{ readonly count: number; readonly isAll: boolean }>(() => ({ count: 0, isAll: true }));

function tellThose(turns: readonly Turn[]): void {
  held.callOff();
  const due = [...held.tells].filter(([, turn]) => turns.includes(turn));
  for (const [tell] of due) held.tells.delete(tell);
  for (const [tell] of due) tell();
  if (held.tells.size === 0 && !passedOn.getState().isAll)
    passedOn.setState(({ count }) => ({ count: count + 1, isAll: true }));
}

function tellByTurns(): void {
  const next = TURNS.find((turn) => [...held.tells.values()].includes(turn));
  if (!next) return;
  if (next === "result") byAndBy(() => tellThose([next]));
  else tellThose([next]);
  const timer = setTimeout(tellByTurns);
  held.callOff = () => clearTimeout(timer);
}

/**
 * Changes a result that comes by itself: what follows it is rendered by and by, or before somebody does something with
 * it.
 */
export function byAndBy(change: () => void): void {
  tellBeforeActing();
  held.isBehind = true;
  startTransition(change);
}

function tellAll(): void {
  tellThose(TURNS);
  if (held.isBehind) for (const bring of followers) bring();
  held.isBehind = false;
}

/** Keys that go on with a number. */
const typesOn = ({ key, ctrlKey, metaKey, altKey, target }: KeyboardEvent): boolean =>
  target instanceof HTMLInputElement &&
  !ctrlKey &&
  !metaKey &&
  !altKey &&
  (key.length === 1 || key === "Backspace" || key === "Delete");

/**
 * From now on everything hears of what was typed before a key, a finger or the loss of the keyboard does something
 * else.
 */
const tellBeforeActing = once(() => {
  const tell = (event: Event) => {
    if ((held.tells.size > 0 || held.isBehind) && !(event instanceof KeyboardEvent && typesOn(event)))
      flushSync(tellAll);
  };
  for (const act of ["keydown", "pointerdown", "click", "focusout", "paste", "drop"] as const)
    addEventListener(act, tell, { capture: true });
});

/** Makes a change that somebody types; whether anything is held back of it. */
export function whileTyping(change: () => void): boolean {
  held.isTyping = true;
  try {
    change();
  } finally {
    held.isTyping = false;
  }
  if (held.tells.size === 0) return false;
  tellBeforeActing();
  passedOn.setState({ isAll: false });
  held.callOff();
  held.callOff = afterPicture(tellByTurns);
  return true;
}

/**
 * Leaves the showing of a text for the turns of what is typed just now; false where nobody types, and it is to be done
 * at once.
 */
export function behindTyping(run: () => void): boolean {
  if (held.isTyping) held.tells.set(run, "text");
  return held.isTyping;
}

/**
 * A store whose followers among the components see what is typed a moment later; everything else reads and hears it at
 * once. A result that comes by itself while something is held waits its turn; any other change passes on all that is
 * held with it.
 */
export function heldWhileTyping<S>(
  begin: StateCreator<S>,
  of: "work" | "result" = "work",
): UseBoundStore<StoreApi<S>> & { readonly atOnce: UseBoundStore<StoreApi<S>> } {
  const store = createStore(begin),
    shown = createStore(() => store.getState());
  const tell = () => shown.setState(store.getState(), true);
  store.subscribe(() => {
    const waits = held.isTyping || (of === "result" && held.tells.size > 0);
    held.tells.set(tell, of);
    if (!waits) tellThose(TURNS);
  });
  const follow = of === "result" ? useFollowed : useStore;
  const bound = (api: StoreApi<S>) => Object.assign(<T>(selector: (state: S) => T) => follow(api, selector), store);
  return Object.assign(bound(shown) as UseBoundStore<StoreApi<S>>, {
    atOnce: bound(store) as UseBoundStore<StoreApi<S>>,
  });
}

/**
 * The text of a field, and its typing: until the work has what was typed the field itself knows it. `of`: which place.
 */
export function useTyping(
  of: string,
  text: string,
  set: (text: string) => void,
): readonly [text: string, type: (text: string) => void] {
  const times = useStore(passedOn, (s) => s.count);
  const [newest, follow] = useState({ of, times: -1, text });
  const type = (next: string) => {
    if (whileTyping(() => set(next))) follow({ of, times, text: next });
  };
  return [newest.of === of && newest.times === times ? newest.text : text, type];
}

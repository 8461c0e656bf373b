import { startTransition, useEffect, useEffectEvent, useRef, useState, type ReactNode } from "react";
import { flushSync } from "react-dom";
import { createStore, useStore, type StateCreator, type StoreApi, type UseBoundStore } from "zustand";
import { once } from "./once.ts";

/*
 * While somebody types, the field and the path are drawn first. Everything else that depends on the work updates after
 * that frame is painted, group by group, or at once before any other action on the page: a button never acts on an
 * older value than the field shows. React's `useDeferredValue` was tried for all of it: it renders between the key and
 * its frame, each component still renders with the key, and nothing updates a deferred value before a click
 * (docs/decisions/0033).
 */

/** Callbacks for the next painted frame, run together; by the calls that asked for them. */
const afterPainting = new Map<object, () => void>();

/** A message arrives after painting; a timer that is set with it would run before. */
const painted = new MessageChannel();
painted.port1.onmessage = () => {
  const due = [...afterPainting.values()];
  afterPainting.clear();
  startTransition(() => due.forEach((each) => each()));
};

/**
 * Runs after the next frame is painted, or soon on a hidden page, which paints none. Returns a function that cancels
 * the call.
 */
export function afterPaint(run: () => void): () => void {
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

/** The value as of the last painted frame: it follows a moment after a key, whose frame does not wait for it. */
export function useDeferredUntilPaint<T>(value: T): T {
  const [late, follow] = useState({ value });
  const isLate = !Object.is(late.value, value);
  useEffect(() => (isLate ? afterPaint(() => follow({ value })) : undefined), [isLate, value]);
  return late.value;
}

/**
 * Content that may follow a moment after a key, when the path is drawn; until then it shows the previous state. Never
 * for anything that is typed into: a field shows its key at once.
 */
export const DeferredUntilPaint = ({ children }: { readonly children: ReactNode }): ReactNode =>
  useDeferredUntilPaint(children);

/** Functions that render each component with the newest state. */
const followers = new Set<() => void>();

/**
 * A selection from a store as state of the component: a change in a transition is rendered with low priority, and all
 * components that follow it change together. Zustand's own hook renders every change in one piece, however long that
 * takes on a slow device.
 */
function useStoreInTransition<S, T>(store: StoreApi<S>, select: (state: S) => T): T {
  const [seen, see] = useState(() => ({ state: store.getState() }));
  /** The state rendered last or about to be rendered. A state with an equal selection replaces it without a render. */
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

/** Groups of pending updates, each flushed in a task of its own: all together are a long task on a slow device. */
const TURNS = ["work", "text", "result"] as const;
type Turn = (typeof TURNS)[number];

/** Updates that are pending while somebody types. */
const held = {
  tells: new Map<() => void, Turn>(),
  isTyping: false,
  /** The last flushed updates may not be rendered yet. */
  isBehind: false,
  callOff: (): void => undefined,
};
/** Number of complete flushes, and whether nothing is pending. */
const passedOn = createStore<{ readonly count: number; readonly isAll: boolean }>(() => ({ count: 0, isAll: true }));

function flushGroups(turns: readonly Turn[]): void {
  held.callOff();
  const due = [...held.tells].filter(([, turn]) => turns.includes(turn));
  for (const [tell] of due) held.tells.delete(tell);
  for (const [tell] of due) tell();
  if (held.tells.size === 0 && !passedOn.getState().isAll)
    passedOn.setState(({ count }) => ({ count: count + 1, isAll: true }));
}

function flushNextGroup(): void {
  const next = TURNS.find((turn) => [...held.tells.values()].includes(turn));
  if (!next) return;
  if (next === "result") renderDeferred(() => flushGroups([next]));
  else flushGroups([next]);
  const timer = setTimeout(flushNextGroup);
  held.callOff = () => clearTimeout(timer);
}

/**
 * Changes a result that does not come from a key: its followers render as a transition, or at once before an action.
 */
export function renderDeferred(change: () => void): void {
  flushBeforeActions();
  held.isBehind = true;
  startTransition(change);
}

function flushAll(): void {
  flushGroups(TURNS);
  if (held.isBehind) for (const bring of followers) bring();
  held.isBehind = false;
}

/** Keys that continue a number. */
const typesOn = ({ key, ctrlKey, metaKey, altKey, target }: KeyboardEvent): boolean =>
  target instanceof HTMLInputElement &&
  !ctrlKey &&
  !metaKey &&
  !altKey &&
  (key.length === 1 || key === "Backspace" || key === "Delete");

/** Flushes the pending updates before a key, click, or loss of focus does anything else. */
const flushBeforeActions = once(() => {
  const tell = (event: Event) => {
    if ((held.tells.size > 0 || held.isBehind) && !(event instanceof KeyboardEvent && typesOn(event)))
      flushSync(flushAll);
  };
  for (const act of ["keydown", "pointerdown", "click", "focusout", "paste", "drop"] as const)
    addEventListener(act, tell, { capture: true });
});

/** Makes a change that somebody types; returns whether updates are pending after it. */
export function whileTyping(change: () => void): boolean {
  held.isTyping = true;
  try {
    change();
  } finally {
    held.isTyping = false;
  }
  if (held.tells.size === 0) return false;
  flushBeforeActions();
  passedOn.setState({ isAll: false });
  held.callOff();
  held.callOff = afterPaint(flushNextGroup);
  return true;
}

/** Queues the update of a text while somebody types; false if nobody types and it is to be done at once. */
export function deferWhileTyping(run: () => void): boolean {
  if (held.isTyping) held.tells.set(run, "text");
  return held.isTyping;
}

/**
 * A store whose components update a moment after typing; everything else reads and hears of changes at once. A result
 * that arrives meanwhile is queued; any other change flushes all pending updates.
 */
export function createDeferredStore<S>(
  begin: StateCreator<S>,
  of: "work" | "result" = "work",
): UseBoundStore<StoreApi<S>> & { readonly atOnce: UseBoundStore<StoreApi<S>> } {
  const store = createStore(begin),
    shown = createStore(() => store.getState());
  const tell = () => shown.setState(store.getState(), true);
  store.subscribe(() => {
    const waits = held.isTyping || (of === "result" && held.tells.size > 0);
    held.tells.set(tell, of);
    if (!waits) flushGroups(TURNS);
  });
  const follow = of === "result" ? useStoreInTransition : useStore;
  const bound = (api: StoreApi<S>) => Object.assign(<T>(selector: (state: S) => T) => follow(api, selector), store);
  return Object.assign(bound(shown) as UseBoundStore<StoreApi<S>>, {
    atOnce: bound(store) as UseBoundStore<StoreApi<S>>,
  });
}

/**
 * The text of a field, and its setter: until the work has the typed text the field itself keeps it. `of`: the id of the
 * field.
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

import { randomId } from "../base/random-id.ts";
import { jsonOf, storedText } from "../base/storage.ts";
import { once } from "../base/once.ts";

/**
 * Only the tab that holds the lock of a work writes it; the lock ends with the tab. The open work of a tab survives a
 * reload in the session storage. Over a channel a tab requests a work, and its owner replies with the newest state.
 */
const OPEN = storedText("work", "tab");

/** States that a page of an earlier edition could not write before it closed. */
const PENDING = storedText("pending", "tab");

const LOCK = "turnwise ";

/** Works locked by this tab, with their release functions. */
const mine = new Map<string, () => void>();

/** Works being released, until the browser has freed their locks. */
const going = new Set<string>();

/** Called when another tab took a work because this one did not answer. */
export const onLost = new Set<(work: string) => void>();

export const owns = (work: string): boolean => mine.has(work);
export const ownedWorks = (): readonly string[] => [...mine.keys()];

/** What this tab had open before a reload: a work, "" for the start page, null in a new tab. */
export const rememberedWork = (): string | null => OPEN.get() ?? null;

export function rememberWork(work: string | null): void {
  const name = work ?? "";
  if (rememberedWork() !== name) OPEN.set(name);
}

/** The last state of a work in the save format. */
interface PendingState {
  readonly work: string;
  readonly file: unknown;
}

/** Takes the states that a page of an earlier edition left in this tab. */
export function takePending(): readonly PendingState[] {
  const raw = jsonOf(PENDING.get());
  PENDING.set(null);
  return Array.isArray(raw) ? raw.filter(isBehind) : [];
}

const isBehind = (raw: unknown): raw is PendingState =>
  typeof raw === "object" && raw !== null && "work" in raw && "file" in raw && typeof raw.work === "string";

/** Messages between tabs. `to` is the requesting tab. */
type Message =
  | { readonly kind: "who" | "have"; readonly work: string }
  | { readonly kind: "give"; readonly work: string; readonly to: string }
  | { readonly kind: "given"; readonly work: string; readonly to: string; readonly state: unknown }
  | {
      readonly kind: "changed";
    };

const isMessage = (raw: unknown): raw is Message => typeof raw === "object" && raw !== null && "kind" in raw;
const listeners = new Set<(message: Message) => void>();

/** The channel, opened on first use; null if the browser has none. */
const open = once((): BroadcastChannel | null => {
  if (typeof BroadcastChannel !== "function") return null;
  const channel = new BroadcastChannel("turnwise");
  channel.addEventListener("message", ({ data }: MessageEvent<unknown>) => {
    if (isMessage(data)) {
      for (const listener of listeners) listener(data);
    }
  });
  return channel;
});

const say = (message: Message): void => open()?.postMessage(message);

/** Listens to other tabs; returns the function that stops it. */
function hear(listener: (message: Message) => void): () => void {
  open();
  listeners.add(listener);
  return () => void listeners.delete(listener);
}

/** Waits `patience` ms for the answer of another tab; undefined without one. */
function answer<T>(
  question: Message,
  patience: number,
  read: (message: Message) => T | undefined,
): Promise<T | undefined> {
  return new Promise((resolve) => {
    const end = (found?: T) => {
      clearTimeout(timer);
      stop();
      resolve(found);
    };
    const timer = setTimeout(end, patience);
    const stop = hear((message) => {
      const found = read(message);
      if (found !== undefined) end(found);
    });
    say(question);
  });
}

/** Timeouts for a live tab to confirm that it has a work, and to hand it over, ms. */
const PATIENCE = { who: 200, give: 3000 };

/** Tells the other tabs that the list of works or their locks changed. */
export const announceChange = (): void => say({ kind: "changed" });
export const onChanged = (listener: () => void): (() => void) => hear(({ kind }) => kind === "changed" && listener());

/**
 * Claims a work until it is released or the tab closes; false if another tab has it. `steal` takes it from a tab that
 * does not answer. Without locks (old browsers, plain http) the tabs ask each other.
 */
export async function claimWork(work: string, steal = false): Promise<boolean> {
  if (mine.has(work)) return true;
  const locks = typeof navigator === "undefined" ? undefined : navigator.locks;
  if (!locks) {
    const asked = { kind: "who", work } as const;
    const taken =
      !steal && (await answer(asked, PATIENCE.who, (m) => (m.kind === "have" && m.work === work) || undefined));
    if (!taken) mine.set(work, () => undefined);
    return !taken;
  }
  return new Promise((resolve) => {
    const hold = (lock: Lock | null) => {
      if (!lock) return resolve(false);
      return new Promise<void>((release) => {
        mine.set(work, () => {
          going.add(work);
          release();
        });
        resolve(true);
      });
    };
    const held = Promise.resolve(locks.request(LOCK + work, steal ? { steal } : { ifAvailable: true }, hold));
    void held
      .finally(() => going.delete(work) && announceChange())
      .catch(() => {
        resolve(false);
        if (mine.delete(work)) {
          for (const lost of onLost) lost(work);
        }
      });
  });
}

/** Attempts to claim a work, and the pause between them, ms: a tab that closes or reloads releases it late. */
const ASKING = { times: 5, rest: 60 };

/** Claims a work for this tab, with retries. */
export async function claimWithRetries(work: string): Promise<boolean> {
  for (let attempt = 0; attempt < ASKING.times; attempt++) {
    if (attempt > 0) await new Promise((done) => setTimeout(done, ASKING.rest));
    if (await claimWork(work)) return true;
  }
  return false;
}

/** Claims a new work, which no other tab can have. */
export function claimNew(work: string): void {
  void claimWork(work);
  if (!mine.has(work)) mine.set(work, () => undefined);
}

/** Releases a work for other tabs. */
export function releaseWork(work: string): void {
  const release = mine.get(work);
  mine.delete(work);
  release?.();
}

/**
 * Works open in other tabs; none if the browser does not say. Locks that this tab is releasing are excluded, since the
 * browser still reports them.
 */
export async function worksInOtherTabs(): Promise<ReadonlySet<string>> {
  try {
    const own = new Set([...mine.keys(), ...going]);
    const { held = [] } = await navigator.locks.query();
    const names = held.flatMap(({ name = "" }) => (name.startsWith(LOCK) ? [name.slice(LOCK.length)] : []));
    return new Set(names.filter((work) => !own.has(work) && !mine.has(work)));
  } catch {
    return new Set();
  }
}

/** Requests a work from its tab. Returns its newest state, null if that is saved, undefined without an answer. */
export function requestWork(work: string): Promise<unknown> {
  const to = randomId();
  return answer({ kind: "give", work, to }, PATIENCE.give, (m) =>
    m.kind === "given" && m.to === to ? m.state : undefined,
  );
}

/** Starts answering the requests of other tabs. `give` closes a work here and returns its newest state. */
export function answerRequests(give: (work: string) => Promise<unknown>): () => void {
  return hear((message) => {
    if (message.kind === "who" && owns(message.work)) say({ kind: "have", work: message.work });
    if (message.kind !== "give" || !owns(message.work)) return;
    const { work, to } = message;
    void give(work).then((state) => {
      releaseWork(work);
      announceChange();
      say({ kind: "given", work, to, state: state ?? null });
    });
  });
}

import { drawnId } from "../base/chance.ts";
import { jsonOf, keptText } from "../base/kept.ts";
import { once } from "../base/once.ts";

/**
 * A work is written by one tab at a time: the one that holds its lock, which dies with the tab. Which work a tab has
 * open survives a reload in the session storage. Tabs speak over a channel: one asks for a work, the one that has it
 * hands over its newest state.
 */
const OPEN = keptText("work", "tab");

/** What could not be written before the page went away. */
const PENDING = keptText("pending", "tab");

const LOCK = "turnwise ";

/** Works whose lock this tab holds, with what lets it go. */
const mine = new Map<string, () => void>();

/** Works that this tab has let go, until the browser has given their locks back. */
const going = new Set<string>();

/** Hear of a work that another tab took because this one did not answer. */
export const onLost = new Set<(work: string) => void>();

export const owns = (work: string): boolean => mine.has(work);
export const ownedWorks = (): readonly string[] => [...mine.keys()];

/** What this tab had open before a reload: a work, "" for the start page, null in a new tab. */
export const rememberedWork = (): string | null => OPEN.get() ?? null;

export function rememberWork(work: string | null): void {
  const name = work ?? "";
  if (rememberedWork() !== name) OPEN.set(name);
}

/** The last state of a work as it would lie on the device. */
export interface Behind {
  readonly work: string;
  readonly file: unknown;
}

/**
 * Leaves states of works for the next page of this tab, in place of those left before: writing takes longer than
 * leaving. Where there is not room for all of them the largest stay out.
 */
export function leaveBehind(states: readonly Behind[]): void {
  const parts = states.map((state) => JSON.stringify(state)).sort((a, b) => a.length - b.length);
  while (!PENDING.set(parts.length > 0 ? `[${parts.join(",")}]` : null) && parts.length > 0) parts.pop();
}

/** What the page before left behind. */
export function leftBehind(): readonly Behind[] {
  const raw = jsonOf(PENDING.get());
  return Array.isArray(raw) ? raw.filter(isBehind) : [];
}

const isBehind = (raw: unknown): raw is Behind =>
  typeof raw === "object" && raw !== null && "work" in raw && "file" in raw && typeof raw.work === "string";

/** What tabs say to each other. `to` is the one that asked. */
type Message =
  | { readonly kind: "who" | "have"; readonly work: string }
  | { readonly kind: "give"; readonly work: string; readonly to: string }
  | { readonly kind: "given"; readonly work: string; readonly to: string; readonly state: unknown }
  | {
      readonly kind: "changed";
    };

const isMessage = (raw: unknown): raw is Message => typeof raw === "object" && raw !== null && "kind" in raw;
const listeners = new Set<(message: Message) => void>();

/** The channel, opened when the first one listens or speaks; null where the browser has none. */
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

/** Hears what the other tabs say, until it is called off. */
function hear(listener: (message: Message) => void): () => void {
  open();
  listeners.add(listener);
  return () => void listeners.delete(listener);
}

/** Waits for an answer of another tab; undefined when none comes in time, ms. */
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

/** What a tab that lives needs at most to say that it has a work, and to hand it over, ms. */
const PATIENCE = { who: 200, give: 3000 };

/** Tells the other tabs that the list of works, or who has which open, is not as before. */
export const sayChanged = (): void => say({ kind: "changed" });
export const onChanged = (listener: () => void): (() => void) => hear(({ kind }) => kind === "changed" && listener());

/**
 * Claims a work for this tab until it lets it go or is closed; false when another tab has it. `steal` takes it from one
 * that does not answer. Without locks (old browsers, plain http) the tabs ask each other.
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
      .finally(() => going.delete(work) && sayChanged())
      .catch(() => {
        resolve(false);
        if (mine.delete(work)) {
          for (const lost of onLost) lost(work);
        }
      });
  });
}

/** Claims a work that was just made: nobody else can have it. */
export function claimNew(work: string): void {
  void claimWork(work);
  if (!mine.has(work)) mine.set(work, () => undefined);
}

/** Lets other tabs have a work. */
export function releaseWork(work: string): void {
  const release = mine.get(work);
  mine.delete(work);
  release?.();
}

/**
 * Works that other tabs have open; none where the browser does not say. What this tab lets go while it asks is still
 * told of as held.
 */
export async function worksElsewhere(): Promise<ReadonlySet<string>> {
  try {
    const own = new Set([...mine.keys(), ...going]);
    const { held = [] } = await navigator.locks.query();
    const names = held.flatMap(({ name = "" }) => (name.startsWith(LOCK) ? [name.slice(LOCK.length)] : []));
    return new Set(names.filter((work) => !own.has(work) && !mine.has(work)));
  } catch {
    return new Set();
  }
}

/**
 * Asks the tab that has a work for it. Gives its newest state, null where that is on the device; undefined when nobody
 * answers.
 */
export function askFor(work: string): Promise<unknown> {
  const to = drawnId();
  return answer({ kind: "give", work, to }, PATIENCE.give, (m) =>
    m.kind === "given" && m.to === to ? m.state : undefined,
  );
}

/**
 * From now on this tab answers others that ask for its works. `give` stops working on one and says what its newest
 * state is.
 */
export function answerOthers(give: (work: string) => Promise<unknown>): () => void {
  return hear((message) => {
    if (message.kind === "who" && owns(message.work)) say({ kind: "have", work: message.work });
    if (message.kind !== "give" || !owns(message.work)) return;
    const { work, to } = message;
    void give(work).then((state) => {
      releaseWork(work);
      sayChanged();
      say({ kind: "given", work, to, state: state ?? null });
    });
  });
}

/**
 * Each browser tab writes only works that are its own, so two tabs can never overwrite each other. Which work a tab
 * has open survives a reload in the session storage; a lock that dies with the tab tells whose work it is now.
 */
const KEY = "turnwise/work";

/** What could not be written before the page went away. */
const PENDING = "turnwise/pending";

/** Names of works whose lock this tab holds. */
const mine = new Set<string>();

/** What this tab had open before a reload: a work, "" for the start page, null in a new tab. */
export function rememberedWork(): string | null {
  try {
    return sessionStorage.getItem(KEY);
  } catch {
    return null;
  }
}

export function rememberWork(work: string | null): void {
  const name = work ?? "";
  if (rememberedWork() === name) return;
  try {
    sessionStorage.setItem(KEY, name);
  } catch {
    return;
  }
}

/** The last state of a work as it would lie on the device. */
export interface Behind {
  readonly work: string;
  readonly file: unknown;
}

/** Leaves states of works for the next page of this tab, in place of those left before: writing takes longer than leaving. */
export function leaveBehind(states: readonly Behind[]): void {
  try {
    if (states.length > 0) sessionStorage.setItem(PENDING, JSON.stringify(states));
    else sessionStorage.removeItem(PENDING);
  } catch {
    return;
  }
}

/** What the page before left behind. */
export function leftBehind(): readonly Behind[] {
  try {
    const raw: unknown = JSON.parse(sessionStorage.getItem(PENDING) ?? "[]");
    return Array.isArray(raw) ? raw.filter(isBehind) : [];
  } catch {
    return [];
  }
}

const isBehind = (raw: unknown): raw is Behind =>
  typeof raw === "object" && raw !== null && "work" in raw && "file" in raw && typeof raw.work === "string";

/**
 * Claims a work for this tab until it is closed; false when another tab has it open. Without locks (old browsers, plain
 * http) only a work that this tab remembers counts as its own.
 */
export async function claimWork(work: string): Promise<boolean> {
  if (mine.has(work)) return true;
  const locks = typeof navigator === "undefined" ? undefined : navigator.locks;
  if (!locks) {
    const own = rememberedWork() === work;
    if (own) mine.add(work);
    return own;
  }
  return new Promise((answer) => {
    void locks.request(`turnwise ${work}`, { ifAvailable: true }, (lock) => {
      answer(lock !== null);
      if (!lock) return undefined;
      mine.add(work);
      return new Promise<void>(() => undefined);
    }).catch(() => answer(false));
  });
}

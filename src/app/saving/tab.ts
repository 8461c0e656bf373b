/**
 * Each browser tab writes only works that are its own, so two tabs can never overwrite each other. Which work a tab
 * has open survives a reload in the session storage; a lock that dies with the tab tells whose work it is now.
 */
const KEY = "turnwise/work";

/** What could not be written before the page went away. */
const PENDING = "turnwise/pending";

/** Names of works whose lock this tab holds. */
const mine = new Set<string>();

export const newWorkName = (): string => crypto.randomUUID?.() ?? `${Date.now()}-${Math.random().toString(36).slice(2)}`;

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

/** Leaves the last state of a work for the next page of this tab: writing to the device takes longer than leaving. */
export function leaveBehind(work: string, file: unknown): void {
  try {
    sessionStorage.setItem(PENDING, JSON.stringify({ work, file }));
  } catch {
    return;
  }
}

/** What the page before left behind, once. */
export function takeBehind(): { readonly work: string; readonly file: unknown } | null {
  try {
    const text = sessionStorage.getItem(PENDING);
    sessionStorage.removeItem(PENDING);
    const raw: unknown = JSON.parse(text ?? "null");
    if (typeof raw !== "object" || raw === null || !("work" in raw) || !("file" in raw) || typeof raw.work !== "string") return null;
    return { work: raw.work, file: raw.file };
  } catch {
    return null;
  }
}

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

import { z } from "zod/mini";
import { storedData } from "../app/base/storage.ts";
import { useEditor } from "../app/document/store.ts";
import { isCover, usePlace } from "../app/place/place.ts";
import { isShareLink, parseAddress, printAddress } from "../app/place/address.ts";
import { goTo, currentAddress } from "./page-address.ts";

/** State of each entry of the browser's history, which survives a reload. */
const text = z.string().check(z.maxLength(500));
const entryShape = z.object({
  /** Address of the previous entry. */
  from: z.nullable(z.string()),
  /** The open prompt, and its text when it opened, for Escape. */
  prompt: z.nullable(text),
  before: text,
});
type Entry = z.output<typeof entryShape>;

function entryOf(raw: unknown): Entry | null {
  const read = entryShape.safeParse(raw);
  return read.success ? read.data : null;
}

const entry = (): Entry | null => entryOf(history.state);

/** The state of the present entry when the page went away: browsers no longer save history changes at that point. */
const LEFT = storedData("place", z.object({ address: z.nullable(z.string()), note: entryShape }), "tab");

/** The entry that the previous page saved at the same address; read once. */
function takeLeftEntry(): Entry | null {
  const kept = LEFT.get();
  LEFT.set(null);
  return kept?.address === location.hash ? kept.note : null;
}

/** Opens the prompt that was open in this entry of the history. */
export function resumePrompt(): void {
  const kept = takeLeftEntry() ?? entry();
  if (kept && usePlace.getState().prompt === null) usePlace.setState({ prompt: kept.prompt, before: kept.before });
}

/** Debounce before the open prompt is saved in the history, ms: browsers allow few changes a second. */
const REST = 400;

/** Pages over the work with their own close button. */
const isOver = (hash: string): boolean => {
  const address = parseAddress(hash);
  return address !== null && (isCover(address) || (address.page === "work" && address.which));
};

/** Rows of one table share one entry of the history. */
const isSamePage = (a: string, b: string): boolean => {
  const [one, other] = [parseAddress(a), parseAddress(b)];
  return (
    one !== null && one.page === other?.page && (one.page === "tools" || one.page === "own" || one.page === "guide")
  );
};

const noteOf = (from: string | null): Entry => {
  const { prompt, before } = usePlace.getState();
  return { from, prompt, before: before.slice(0, 500) };
};

/** Closes open dialogs; true if there were any. The dialog that finds a cycle has its own address and stays. */
function closeDialogs(): boolean {
  const open = [...document.querySelectorAll<HTMLDialogElement>("dialog[open]:not(.which)")];
  for (const dialog of open) dialog.close();
  return open.length > 0;
}

/**
 * Keeps the browser's history and address in step with the page, and the page with Back and Forward. The place decides
 * what is shown; the address follows it. `begun` is the address that the page has opened: it may have changed
 * meanwhile.
 */
export function followAddress(begun = location.hash): () => void {
  /** Address of the present entry, as this page wrote it. */
  let shown = parseAddress(location.hash) ? location.hash : null;
  /** A page was closed by its button: the browser is going back to the previous entry. */
  let returning = false;
  /** Number of requested places; only the last one counts. */
  let asked = 0;
  let going = false;
  let waiting = false;
  let rest: ReturnType<typeof setTimeout> | undefined;

  const replace = () => {
    clearTimeout(rest);
    rest = undefined;
    shown = printAddress(currentAddress());
    history.replaceState(noteOf(entry()?.from ?? null), "", shown);
  };
  const follow = () => {
    waiting = false;
    if (going || returning) return;
    const now = printAddress(currentAddress());
    if (now === shown) return;
    if (shown === null || isSamePage(shown, now)) return replace();
    if (isOver(shown) && entry()?.from === now) {
      returning = true;
      return history.back();
    }
    // Saves the open prompt in the entry that is left; a page over the work changes no prompt.
    if (isOver(now)) noteNow();
    clearTimeout(rest);
    rest = undefined;
    history.pushState(noteOf(shown), "", now);
    shown = now;
  };
  // All changes of one task are one entry.
  const soon = () => {
    if (waiting) return;
    waiting = true;
    queueMicrotask(follow);
  };
  const onBack = () => {
    const place = parseAddress(location.hash);
    if (returning) {
      returning = false;
      shown = place ? location.hash : null;
      return soon();
    }
    // Share links are opened elsewhere; other addresses are invalid.
    if (!place && location.hash !== "") {
      shown = null;
      return isShareLink(location.hash) ? undefined : replace();
    }
    // Back closes a dialog first: the page behind it stays where it is.
    if (closeDialogs() && entry() !== null && shown !== null)
      return history.pushState(noteOf(location.hash), "", shown);
    const mine = ++asked;
    going = true;
    void goTo(place ?? { page: "start", which: false }).finally(() => {
      if (mine !== asked) return;
      going = false;
      resumePrompt();
      replace();
    });
  };
  const noteNow = () => {
    if (rest === undefined) return;
    clearTimeout(rest);
    rest = undefined;
    if (!going && !returning && shown !== null) history.replaceState(noteOf(entry()?.from ?? null), "", shown);
  };
  const noteSoon = () => {
    rest ??= setTimeout(noteNow, REST);
  };
  const note = () => LEFT.set({ address: shown, note: noteOf(entry()?.from ?? null) });
  const stops = [
    useEditor.subscribe((now, before) => {
      if (now.work !== before.work) soon();
    }),
    usePlace.subscribe((now, before) => {
      const isElsewhere = (["pages", "over", "section", "tools", "own"] as const).some((of) => now[of] !== before[of]);
      if (isElsewhere) soon();
      if (now.prompt !== before.prompt) noteSoon();
    }),
  ];
  addEventListener("popstate", onBack);
  addEventListener("pagehide", note);
  if (location.hash === begun) replace();
  else onBack();
  return () => {
    for (const stop of stops) stop();
    clearTimeout(rest);
    removeEventListener("popstate", onBack);
    removeEventListener("pagehide", note);
  };
}

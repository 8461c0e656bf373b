import type { z } from "zod/mini";

/*
 * The one way to the browser's storage. What stands in it may be damaged, and a browser may refuse it altogether:
 * nothing here throws.
 */

/**
 * The storage of the device, which all tabs share and which stays; or that of one tab, which outlasts a reload of the
 * page.
 */
type Area = "device" | "tab";
const storageOf = (area: Area): Storage => (area === "tab" ? sessionStorage : localStorage);

/** A text that the browser keeps. */
export interface KeptText {
  /** Null where there is none; undefined where the browser refuses storage. */
  get(): string | null | undefined;
  /** Keeps a text, or none; false where the browser does not take it. */
  set(text: string | null): boolean;
  /** Calls back with each text that another tab puts there. */
  follow(changed: (text: string | null) => void): void;
}

/** The text under `turnwise/key`. */
export function keptText(key: string, area: Area = "device"): KeptText {
  const name = `turnwise/${key}`;
  return {
    get() {
      try {
        return storageOf(area).getItem(name);
      } catch {
        return undefined;
      }
    },
    set(text) {
      try {
        if (text === null) storageOf(area).removeItem(name);
        else storageOf(area).setItem(name, text);
        return true;
      } catch {
        return false;
      }
    },
    follow: (changed) =>
      addEventListener("storage", ({ storageArea, key: of, newValue }: StorageEvent) => {
        // Without a name everything was cleared.
        if (storageArea === storageOf(area) && (of === name || of === null)) changed(newValue);
      }),
  };
}

/** What a text in JSON holds; undefined where it is none. */
export function jsonOf(text: string | null | undefined): unknown {
  try {
    return JSON.parse(text ?? "");
  } catch {
    return undefined;
  }
}

/** Data in JSON under `turnwise/key`; null where there are none that fit. */
export function keptData<T>(key: string, schema: z.ZodMiniType<T>, area: Area = "device") {
  const text = keptText(key, area);
  return {
    get: (): T | null => schema.safeParse(jsonOf(text.get())).data ?? null,
    set: (data: T | null): boolean => text.set(data === null ? null : JSON.stringify(data)),
  };
}

import { readJson } from "../../program/files/bounded.ts";
import type { z } from "zod/mini";

/*
 * The only access to the browser's key-value storage. Its contents may be damaged, and a browser may refuse access:
 * nothing here throws.
 */

/** Storage of the device is permanent and shared by all tabs; storage of a tab survives a reload only. */
type Area = "device" | "tab";
const storageOf = (area: Area): Storage => (area === "tab" ? sessionStorage : localStorage);

/** A stored text. */
export interface StoredText {
  /** Null if there is none; undefined if the browser refuses storage. */
  get(): string | null | undefined;
  /** Stores the text, or removes it (null); false if the browser refuses. */
  set(text: string | null): boolean;
  /** Calls back with each text that another tab stores. */
  follow(changed: (text: string | null) => void): void;
}

/** The keys that begin with a prefix and have a text, without `turnwise/`; none if the browser refuses. */
export function storedKeys(prefix: string, area: Area = "device"): readonly string[] {
  try {
    return Object.keys(storageOf(area)).flatMap((name) =>
      name.startsWith(`turnwise/${prefix}`) ? [name.slice("turnwise/".length)] : [],
    );
  } catch {
    return [];
  }
}

/** The text under `turnwise/key`. */
export function storedText(key: string, area: Area = "device"): StoredText {
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
        // Without a key the whole storage was cleared.
        if (storageArea === storageOf(area) && (of === name || of === null)) changed(newValue);
      }),
  };
}

/** The value of a JSON text; undefined if the text is not JSON. */
export function jsonOf(text: string | null | undefined): unknown {
  try {
    return readJson(text ?? "");
  } catch {
    return undefined;
  }
}

/** JSON data under `turnwise/key`; null if there are none that match the schema. */
export function storedData<T>(key: string, schema: z.ZodMiniType<T>, area: Area = "device") {
  const text = storedText(key, area);
  return {
    get: (): T | null => schema.safeParse(jsonOf(text.get())).data ?? null,
    set: (data: T | null): boolean => text.set(data === null ? null : JSON.stringify(data)),
  };
}

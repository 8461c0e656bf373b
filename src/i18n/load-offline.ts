import type { OfflineTexts } from "./en/offline.ts";
import type { Language } from "./languages.ts";

/** The texts of the copy on the device and of newer versions, fetched when there is something to say. */
export async function loadOffline(language: Language): Promise<OfflineTexts> {
  switch (language) {
    case "en":
      return (await import("./en/offline.ts")).offline;
    case "de":
      return (await import("./de/offline.ts")).offline;
    case "fr":
      return (await import("./fr/offline.ts")).offline;
    case "zh":
      return (await import("./zh/offline.ts")).offline;
  }
}

import type { DeviceTexts } from "./en/device.ts";
import type { Language } from "./languages.ts";

/** The texts about the works of a device, fetched when they are asked for. */
export async function loadDevice(language: Language): Promise<DeviceTexts> {
  switch (language) {
    case "en":
      return (await import("./en/device.ts")).device;
    case "de":
      return (await import("./de/device.ts")).device;
    case "fr":
      return (await import("./fr/device.ts")).device;
    case "zh":
      return (await import("./zh/device.ts")).device;
  }
}

import type { MachineTexts } from "./en/machine.ts";
import type { Language } from "./languages.ts";

/** The texts of machine data and running times, fetched when they are asked for. */
export async function loadMachine(language: Language): Promise<MachineTexts> {
  switch (language) {
    case "en":
      return (await import("./en/machine.ts")).machineTexts;
    case "de":
      return (await import("./de/machine.ts")).machineTexts;
    case "fr":
      return (await import("./fr/machine.ts")).machineTexts;
    case "zh":
      return (await import("./zh/machine.ts")).machineTexts;
  }
}

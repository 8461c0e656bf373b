import type { Texts } from "../../i18n/index.ts";
import type { SetupPageId } from "./setup-variants.ts";

/** Symbol, name and unit of a place of the set-up. */
export function setupPageWords(
  { setup: t }: Texts,
  id: SetupPageId,
): { readonly letter: string; readonly name: string; readonly unit: string } {
  const { units } = t;
  switch (id) {
    case "blank.outside":
      return { letter: "D", name: t.blank.outside, unit: units.diameter };
    case "blank.bore":
      return { letter: "DI", name: t.blank.bore, unit: units.diameter };
    case "blank.length":
      return { letter: "L", name: t.blank.length, unit: units.mm };
    case "blank.allowance":
      return { letter: "DIST", name: t.blank.allowance, unit: units.mm };
    case "tool":
      return { letter: "T", name: t.tool.title, unit: "" };
    case "start.x":
      return { letter: "X", name: t.start.x, unit: units.diameter };
    case "start.z":
      return { letter: "Z", name: t.start.z, unit: units.mm };
    case "spindle.cuttingSpeed":
      return { letter: "VC", name: t.spindle.cuttingSpeed, unit: units.cuttingSpeed };
    case "spindle.limit":
      return { letter: "SMAX", name: t.spindle.limit, unit: units.rpm };
    case "spindle.speed":
      return { letter: "S", name: t.spindle.speed, unit: units.rpm };
    case "perRevolution":
      return { letter: "M136", name: t.feed.perRevolution, unit: "" };
    case "rapid":
      return { letter: "FMAX", name: t.feed.rapid, unit: units.perMinute };
  }
}

import { shippedList } from "../../program/tools/tool-list.ts";
import { toolsOnDevice } from "../document/tool-store.ts";
import type { Outcome } from "./outcome.ts";
import { askAgain } from "./worker-life.ts";

/** Rapid rate of programs that ship with the page, mm/min. */
const RAPID = 10_000;

/** Runs a program with the default tools as on a TNC 640: it looks the same on every device. */
export function runWithShippedTools(text: string): Promise<Outcome> {
  const { table } = toolsOnDevice(shippedList);
  return askAgain((engine) => engine.update({ version: 0, text, table, rapid: RAPID, control: "TNC 640" }));
}

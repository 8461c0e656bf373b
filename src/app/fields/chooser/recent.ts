import { create } from "zustand";
import { z } from "zod/mini";
import { storedData } from "../../base/storage.ts";

/** The cycles that were chosen last on this device, newest first. */
const KEPT = storedData("recent-cycles", z.array(z.number()));
const MOST = 5;

export const useRecent = create<{ readonly cycles: readonly number[] }>(() => ({
  cycles: KEPT.get()?.slice(0, MOST) ?? [],
}));

/** Notes that a cycle was chosen. A browser that refuses storage keeps it for this visit only. */
export function noteRecent(cycle: number): void {
  const cycles = [cycle, ...useRecent.getState().cycles.filter((each) => each !== cycle)].slice(0, MOST);
  useRecent.setState({ cycles });
  KEPT.set(cycles);
}

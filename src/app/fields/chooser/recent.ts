import { create } from "zustand";

/** The cycles that were chosen last on this device, newest first. */
const KEY = "turnwise/recent-cycles";
const MOST = 5;

function stored(): readonly number[] {
  try {
    const raw: unknown = JSON.parse(localStorage.getItem(KEY) ?? "[]");
    return Array.isArray(raw) ? raw.filter((each): each is number => typeof each === "number").slice(0, MOST) : [];
  } catch {
    return [];
  }
}

export const useRecent = create<{ readonly cycles: readonly number[] }>(() => ({ cycles: stored() }));

/** Notes that a cycle was chosen. A browser that refuses storage keeps it for this visit only. */
export function noteRecent(cycle: number): void {
  const cycles = [cycle, ...useRecent.getState().cycles.filter((each) => each !== cycle)].slice(0, MOST);
  useRecent.setState({ cycles });
  try {
    localStorage.setItem(KEY, JSON.stringify(cycles));
  } catch {
    return;
  }
}

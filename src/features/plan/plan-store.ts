import { create } from "zustand";
import { ncLanguageOf } from "../../i18n/languages.ts";
import type { MachineData } from "../../program/machine/machine-data.ts";
import type { Action } from "../../planning/types.ts";
import type { PlanChanges, PlanProgress, WorkingPlan } from "../../planning/working-plan.ts";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import { isSameData } from "../../app/base/same.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { loadMachine } from "../../app/calculation/machine-reader.ts";
import { askForPlan, stopPlan } from "../../app/calculation/planner.ts";
import { USUAL_RAPID } from "../../app/calculation/request.ts";
import { useTools } from "../../app/document/tool-store.ts";
import { machineTextOf, shopOf } from "../../app/document/work-tools.ts";
import { editPart, partRecord, type StoredPart } from "../../app/records/part-store.ts";

/** What a plan was made from: it is outdated when one of these has changed. */
interface PlanBasis {
  readonly stored: StoredPart;
  readonly table: ReturnType<typeof shopOf>["table"];
  readonly machine: string;
}

/** The newest answer for a part. */
export interface MadePlan {
  readonly basis: PlanBasis;
  readonly plan: WorkingPlan | null;
  readonly problems: readonly PartProblem[];
}

interface Plans {
  /** Newest plan of each part, by its id. */
  readonly made: ReadonlyMap<string, MadePlan>;
  /** Operations of each part that were locked as they are. */
  readonly locked: ReadonlyMap<string, readonly Action[]>;
  /** The search in progress, of a part by its id. */
  readonly running: { readonly id: string; readonly progress: PlanProgress | null } | null;
  /** How the last search ended. */
  readonly ended: "done" | "stopped" | "failed";
}

const NO_ACTIONS: readonly Action[] = [];

export const usePlans = create<Plans>(() => ({ made: new Map(), locked: new Map(), running: null, ended: "done" }));
const { setState: set, getState: get } = usePlans;

const basisOf = (stored: StoredPart): PlanBasis => ({ stored, table: shopOf({}).table, machine: machineTextOf({}) });
const isBasis = (a: PlanBasis, b: PlanBasis): boolean =>
  a.table === b.table && a.machine === b.machine && isSameData(a.stored, b.stored);

/** The newest plan of a part, and whether the part, its stock or the tools have changed since. */
export function usePlanOf(stored: StoredPart): { readonly made: MadePlan | null; readonly isOutdated: boolean } {
  const made = usePlans((s) => s.made.get(stored.id)) ?? null;
  useTools((s) => s.list);
  useSettings((s) => s.machine);
  return { made, isOutdated: made !== null && !isBasis(made.basis, basisOf(stored)) };
}

/** The locked operations of a part. */
export const useLocked = (id: string): readonly Action[] => usePlans((s) => s.locked.get(id) ?? NO_ACTIONS);

/** Plans the open part. `changes`: what stays of the former plan. */
export async function startPlan(changes: PlanChanges = {}): Promise<void> {
  const [stored] = partRecord.now();
  if (!stored) return;
  const { id, part, withoutTools, withoutCycles } = stored;
  const basis = basisOf(stored),
    locked = get().locked.get(id) ?? NO_ACTIONS;
  const running = { id, progress: null };
  set({ running });
  const { language } = useSettings.getState();
  const machine: MachineData | null = await loadMachine(basis.machine);
  const answer = await askForPlan(
    {
      part,
      withoutTools,
      withoutCycles,
      ncLanguage: ncLanguageOf(language),
      shop: { ...shopOf({}), rapid: USUAL_RAPID, machine },
      changes: { ...changes, ...(locked.length > 0 && { locked }) },
    },
    (progress) => get().running?.id === id && set({ running: { id, progress } }),
  );
  // A newer search has taken its place.
  if (answer?.kind === "stopped" && get().running !== null) return;
  if (!answer || answer.kind === "stopped") return set({ running: null, ended: answer ? "stopped" : "failed" });
  const made: MadePlan = { basis, plan: answer.kind === "planned" ? answer.plan : null, problems: answer.problems };
  set(({ made: all }) => ({ made: new Map([...all, [id, made]]), running: null, ended: "done" }));
}

/** Stops the search; the former plan stays. */
export function stopSearch(): void {
  set({ running: null, ended: "stopped" });
  void stopPlan();
}

const planOf = (id: string): WorkingPlan | null => get().made.get(id)?.plan ?? null;

/** Plans the open part again: the operations of the former plan stay as long as they are possible. */
export function planAgain(): void {
  const [stored] = partRecord.now();
  const plan = stored && planOf(stored.id);
  void startPlan(plan ? { keep: plan.steps } : {});
}

/** Takes another way for an operation, and plans what follows again. */
export function takeWay(at: number, actionKey: string): void {
  const [stored] = partRecord.now();
  const plan = stored && planOf(stored.id);
  if (plan) void startPlan({ keep: plan.steps, instead: { at, actionKey } });
}

/** Excludes tools or cycles, or allows them again, and plans again what follows from that. */
export function exclude(change: Partial<Pick<StoredPart, "withoutTools" | "withoutCycles">>): void {
  editPart((stored) => ({ ...stored, ...change }));
  planAgain();
}

/** Locks an operation as it is, or unlocks it: a later plan keeps it. */
export function toggleLock(id: string, action: Action): void {
  set(({ locked }) => {
    const before = locked.get(id) ?? NO_ACTIONS,
      others = before.filter(({ key }) => key !== action.key);
    return { locked: new Map([...locked, [id, others.length < before.length ? others : [...others, action]]]) };
  });
}

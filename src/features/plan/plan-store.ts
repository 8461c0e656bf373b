import { create } from "zustand";
import { ncLanguageOf } from "../../i18n/languages.ts";
import { withUsualTools } from "../../program/iso-codes/usual-tools.ts";
import type { MachineData } from "../../program/machine/machine-data.ts";
import type { Action } from "../../planning/types.ts";
import type { PlanChanges, PlanProgress, PlanStep, WorkingPlan } from "../../planning/working-plan.ts";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import { isSameData } from "../../app/base/same.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { loadMachine } from "../../app/calculation/machine-reader.ts";
import { askForPlan, stopPlan } from "../../app/calculation/planner.ts";
import { USUAL_RAPID } from "../../app/calculation/request.ts";
import { useTools } from "../../app/document/tool-store.ts";
import { machineTextOf, shopOf } from "../../app/document/work-tools.ts";
import { editPart, partRecord, rememberPlan, type StoredPart } from "../../app/records/part-store.ts";

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

/** What a plan depends on: its own operations are noted beside it. */
const inputOf = ({ part, withoutTools, withoutCycles }: StoredPart) => ({ part, withoutTools, withoutCycles });
const basisOf = (stored: StoredPart): PlanBasis => ({ stored, table: shopOf({}).table, machine: machineTextOf({}) });
const isBasis = (a: PlanBasis, b: PlanBasis): boolean =>
  a.table === b.table && a.machine === b.machine && isSameData(inputOf(a.stored), inputOf(b.stored));

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
  const { control } = shopOf({});
  const { table, usual } = withUsualTools(useTools.getState().list);
  const answer = await askForPlan(
    {
      part,
      withoutTools,
      withoutCycles,
      ncLanguage: ncLanguageOf(language),
      usualTools: usual,
      shop: { table, control, rapid: USUAL_RAPID, machine },
      changes: { ...changes, ...(locked.length > 0 && { locked }) },
    },
    (progress) => get().running?.id === id && set({ running: { id, progress } }),
  );
  // A newer search has taken its place.
  if (answer?.kind === "stopped" && get().running !== null) return;
  if (!answer || answer.kind === "stopped") return set({ running: null, ended: answer ? "stopped" : "failed" });
  const made: MadePlan = { basis, plan: answer.kind === "planned" ? answer.plan : null, problems: answer.problems };
  const chosen = new Set([changes.instead?.actionKey, ...(changes.again?.byHand ?? [])]);
  const taken = (made.plan?.steps ?? []).map(({ tried: { action } }) => action).filter(({ key }) => chosen.has(key));
  set(({ made: all, locked: before }) => ({
    made: new Map([...all, [id, made]]),
    locked: taken.length > 0 ? new Map([...before, [id, withLocks(before.get(id), taken)]]) : before,
    running: null,
    ended: "done",
  }));
  remember(id);
}

/** Locked operations with others, the later of equal ones. */
const withLocks = (locked: readonly Action[] = NO_ACTIONS, added: readonly Action[]): readonly Action[] => [
  ...locked.filter(({ key }) => !added.some((each) => each.key === key)),
  ...added,
];

/** Stores which operations a plan has and which of them are locked. */
function remember(id: string): void {
  const keyOf = ({ key }: Action) => key;
  const ways = planOf(id)?.steps.map(({ tried }) => keyOf(tried.action)) ?? [];
  rememberPlan(id, ways, (get().locked.get(id) ?? NO_ACTIONS).map(keyOf));
}

/** Plans a part of an earlier visit again: its plan is not stored, its operations are. */
export function resumePlan({ id, ways = [], locked = [] }: StoredPart): void {
  const { made, running } = get();
  if (ways.length > 0 && !made.has(id) && running?.id !== id) void startPlan({ again: { keys: ways, byHand: locked } });
}

/** Stops the search; the former plan stays. */
export function stopSearch(): void {
  set({ running: null, ended: "stopped" });
  void stopPlan();
}

const planOf = (id: string): WorkingPlan | null => get().made.get(id)?.plan ?? null;

/** The steps of a plan as the operator decided: only those that are locked stay for sure. */
function keptSteps(id: string, { steps }: WorkingPlan): readonly PlanStep[] {
  const locked = get().locked.get(id) ?? NO_ACTIONS;
  return steps.map((step) => ({ ...step, isByHand: locked.some(({ key }) => key === step.tried.action.key) }));
}

/** Plans the open part again: the operations of the former plan stay as long as they are possible. */
export function planAgain(): void {
  const [stored] = partRecord.now();
  const plan = stored && planOf(stored.id);
  void startPlan(plan ? { keep: keptSteps(stored.id, plan) } : {});
}

/** Takes another way for an operation, locks it, and plans what follows again. */
export function takeWay(at: number, actionKey: string): void {
  const [stored] = partRecord.now();
  const plan = stored && planOf(stored.id);
  if (!plan) return;
  const former = plan.steps[at]?.tried.action.key;
  set(({ locked }) => ({
    locked: new Map([
      ...locked,
      [stored.id, (locked.get(stored.id) ?? NO_ACTIONS).filter(({ key }) => key !== former)],
    ]),
  }));
  void startPlan({ keep: keptSteps(stored.id, plan), instead: { at, actionKey } });
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
  remember(id);
}

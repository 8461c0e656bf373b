import { create } from "zustand";
import { ncLanguageOf } from "../../i18n/languages.ts";
import { withUsualTools } from "../../program/iso-codes/usual-tools.ts";
import type { MachineData } from "../../program/machine/machine-data.ts";
import { handValuesOf } from "../../planning/hand-values.ts";
import type { HandValues } from "../../planning/types.ts";
import type { ClampingChanges, PlanChanges, PlanProgress, WorkingPlan } from "../../planning/working-plan.ts";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import { isSameData } from "../../app/base/same.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { loadMachine } from "../../app/calculation/machine-reader.ts";
import type { PlanOrder, ValuesTried } from "../../app/calculation/part-plan.ts";
import { askForPlan, askForValues, stopPlan } from "../../app/calculation/planner.ts";
import { USUAL_RAPID } from "../../app/calculation/request.ts";
import { useTools } from "../../app/document/tool-store.ts";
import { machineTextOf, shopOf } from "../../app/document/work-tools.ts";
import {
  editHand,
  editPart,
  NO_DECISIONS,
  partRecord,
  rememberPlan,
  type Clamping,
  type PlanDecisions,
  type StoredPart,
} from "../../app/records/part-store.ts";

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
  /** The search in progress, of a part by its id. */
  readonly running: { readonly id: string; readonly progress: PlanProgress | null } | null;
  /** How the last search ended. */
  readonly ended: "done" | "stopped" | "failed";
}

export const usePlans = create<Plans>(() => ({ made: new Map(), running: null, ended: "done" }));
const { setState: set, getState: get } = usePlans;

/** What a plan depends on besides its own operations. */
const inputOf = ({ part, withoutTools, withoutCycles }: StoredPart) => ({ part, withoutTools, withoutCycles });
const basisOf = (stored: StoredPart): PlanBasis => ({ stored, table: shopOf({}).table, machine: machineTextOf({}) });
const isBasis = (a: PlanBasis, b: PlanBasis): boolean =>
  a.table === b.table && a.machine === b.machine && isSameData(inputOf(a.stored), inputOf(b.stored));

/** Keys of the operations of a plan; without one there are none. */
const keysOf = (plan: WorkingPlan | null): readonly string[] => plan?.steps.map(({ tried }) => tried.action.key) ?? [];

/** Whether the operations of a clamping, and their values by hand, are those that are stored. */
const isDecided = (plan: WorkingPlan | null, { keep, hand }: PlanDecisions = NO_DECISIONS): boolean =>
  isSameData(keysOf(plan), keep) &&
  (plan?.steps ?? []).every(({ tried: { action } }) => isSameData(handValuesOf(action), hand[action.key] ?? {}));

/** The newest plan of a part, and whether the part, its stock, the tools or decisions have changed since. */
export function usePlanOf(stored: StoredPart): { readonly made: MadePlan | null; readonly isOutdated: boolean } {
  const made = usePlans((s) => s.made.get(stored.id)) ?? null;
  useTools((s) => s.list);
  useSettings((s) => s.machine);
  const plan = made?.plan ?? null;
  const isNew = (of: MadePlan): boolean =>
    isBasis(of.basis, basisOf(stored)) &&
    isDecided(plan, stored.first) &&
    isDecided(plan?.second ?? null, stored.second);
  return { made, isOutdated: made !== null && !isNew(made) };
}

/** The machine data and tools of a basis, with which a part is planned. */
async function orderOf({ stored, machine: text }: PlanBasis): Promise<PlanOrder> {
  const { part, withoutTools, withoutCycles } = stored;
  const { language } = useSettings.getState();
  const machine: MachineData | null = await loadMachine(text);
  const { control } = shopOf({});
  const { table, usual } = withUsualTools(useTools.getState().list);
  return {
    part,
    withoutTools,
    withoutCycles,
    ncLanguage: ncLanguageOf(language),
    usualTools: usual,
    shop: { table, control, rapid: USUAL_RAPID, machine },
  };
}

/** Plans the open part as decided. `instead`: another way for an operation of a clamping. */
async function search(instead?: { readonly clamping: Clamping } & NonNullable<PlanChanges["instead"]>): Promise<void> {
  const [stored] = partRecord.now();
  if (!stored) return;
  const { id, first, second } = stored;
  const basis = basisOf(stored);
  set({ running: { id, progress: null } });
  const changes = (clamping: Clamping, decided: PlanDecisions = NO_DECISIONS): ClampingChanges =>
    instead?.clamping === clamping ? { ...decided, instead } : decided;
  const answer = await askForPlan(
    await orderOf(basis),
    { ...changes("first", first), second: changes("second", second) },
    (progress) => get().running?.id === id && set({ running: { id, progress } }),
  );
  // A newer search has taken its place.
  if (answer?.kind === "stopped" && get().running !== null) return;
  if (!answer || answer.kind === "stopped") return set({ running: null, ended: answer ? "stopped" : "failed" });
  const made: MadePlan = { basis, plan: answer.kind === "planned" ? answer.plan : null, problems: answer.problems };
  set(({ made: all }) => ({ made: new Map([...all, [id, made]]), running: null, ended: "done" }));
  rememberPlan(id, { first: keysOf(made.plan), second: keysOf(made.plan?.second ?? null) });
}

/** Plans the open part: the operations of its former plan stay as long as they are possible. */
export const startPlan = (): void => void search();

/** Plans a part of an earlier visit again: its plan is not stored, its operations are. */
export function resumePlan({ id, first = NO_DECISIONS }: StoredPart): void {
  const { made, running } = get();
  if (first.keep.length > 0 && !made.has(id) && running?.id !== id) startPlan();
}

/** Stops the search; the former plan stays. */
export function stopSearch(): void {
  set({ running: null, ended: "stopped" });
  void stopPlan();
}

/** Takes another way for an operation, locks it, and plans what follows again. */
export function takeWay(clamping: Clamping, at: number, former: string, actionKey: string): void {
  editHand(clamping, ({ [former]: _, ...others }) => ({ ...others, [actionKey]: {} }));
  void search({ clamping, at, actionKey });
}

/** Sets the values of an operation by hand, and plans what follows again; none: those of the plan count again. */
export function setValues(clamping: Clamping, at: number, actionKey: string, values: HandValues): void {
  const isSet = Object.keys(values).length > 0;
  editHand(clamping, ({ [actionKey]: _, ...others }) => (isSet ? { ...others, [actionKey]: values } : others));
  void search({ clamping, at, actionKey });
}

/** What an operation with values set by hand does in the stock before it; null if it cannot be calculated. */
export async function previewValues(
  { basis }: MadePlan,
  plan: WorkingPlan,
  at: number,
  values: HandValues,
): Promise<ValuesTried | null> {
  const action = plan.steps[at]?.tried.action;
  const stock = plan.steps[at - 1]?.tried.stock ?? plan.setup.blank;
  return action ? askForValues(await orderOf(basis), plan.setup, stock, action, values) : null;
}

/** Excludes tools or cycles, or allows them again, and plans again what follows from that. */
export function exclude(change: Partial<Pick<StoredPart, "withoutTools" | "withoutCycles">>): void {
  editPart((stored) => ({ ...stored, ...change }));
  startPlan();
}

/** Locks an operation, or unlocks it with its values: a later plan keeps a locked one. */
export const toggleLock = (clamping: Clamping, key: string): void =>
  editHand(clamping, ({ [key]: before, ...others }) => (before ? others : { ...others, [key]: {} }));

/** Forgets locks and values of operations that the plan does not have. */
export const forgetHand = (clamping: Clamping, keys: readonly string[]): void =>
  editHand(clamping, (hand) => Object.fromEntries(Object.entries(hand).filter(([key]) => !keys.includes(key))));

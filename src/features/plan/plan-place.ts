import { create } from "zustand";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Clamping } from "../../app/records/part-store.ts";
import type { Side } from "./part-rows.ts";

export const PLAN_TABS = ["part", "stock", "tools", "plan"] as const;
export type PlanSection = (typeof PLAN_TABS)[number];

/** The part file that was opened last. */
interface OpenedFile {
  readonly name: string;
  readonly isOpen: boolean;
  readonly problems: readonly PartProblem[];
}

/** What the page shows: it survives a visit to another page. */
interface PlanPlace {
  readonly tab: PlanSection;
  readonly side: Side;
  /** Which clamping of the plan. */
  readonly clamping: Clamping;
  /** Index of the step with its details, and of the one that is pointed at. */
  readonly open: number | null;
  readonly pointed: number | null;
  /** The stock behind the open step with values that are typed. */
  readonly preview: readonly Ring[] | null;
  /** Rows of a residue that is pointed at. */
  readonly rows: readonly string[];
  /** Until something else is done. */
  readonly opened: OpenedFile | null;
}

const NO_ROWS: readonly string[] = [];
export const usePlanPlace = create<PlanPlace>(() => ({
  tab: "part",
  side: "outside",
  clamping: "first",
  open: null,
  pointed: null,
  preview: null,
  rows: NO_ROWS,
  opened: null,
}));
const { setState: set } = usePlanPlace;

export const showTab = (tab: PlanSection): void => set({ tab, pointed: null, rows: NO_ROWS });
export const sayOpened = (opened: OpenedFile | null): void => set({ opened });
export const showSide = (side: Side): void => set({ side });
export const showClamping = (clamping: Clamping): void => set({ clamping, open: null, pointed: null });
export const previewStock = (preview: readonly Ring[] | null): void => set({ preview });
/** Opens the details of a step, or closes them. */
export const openStep = (index: number): void => set(({ open }) => ({ open: open === index ? null : index }));
export const pointAtStep = (pointed: number | null): void => set({ pointed });
export const pointAtRows = (rows: readonly string[] | null): void => set({ rows: rows ?? NO_ROWS });

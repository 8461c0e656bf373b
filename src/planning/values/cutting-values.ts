import { shankAxis } from "../../kernel/cutter/holder.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { drilling, reaming, threading } from "./axis-values.ts";
import { plunging } from "./blade-values.ts";
import { finishing, roughing } from "./turning-values.ts";
import type { CuttingValues, ValuesRequest, Work } from "./values-request.ts";

const BY_WORK: Readonly<Record<Work, (request: ValuesRequest) => CuttingValues>> = {
  rough: roughing,
  face: roughing,
  finish: finishing,
  recess: plunging,
  partOff: plunging,
  thread: threading,
  drill: drilling,
  centre: drilling,
  ream: reaming,
};

/**
 * Infeed, feeds and speed of one kind of work from material, tool, stability and machine, each the least of several
 * formulas, with the one that decided. Estimates, as the cutting data are (decisions 0032 and 0056).
 */
export const cuttingValues = (request: ValuesRequest): CuttingValues => BY_WORK[request.work](request);

/** Diameter of a boring bar from the shank of its holder, mm; null where none is stated or it lies across. */
export const barDiameter = ({ holder, TO }: Tool): number | null =>
  holder && shankAxis(TO, holder.axis) === "Z" ? holder.width : null;

import { areaOf } from "../../kernel/area/area.ts";
import { difference } from "../../kernel/area/clip.ts";
import { withoutSlivers } from "../../kernel/area/real-area.ts";
import { part, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { roughnessOf } from "../../sim/load/roughness.ts";
import { stockIssues } from "../../sim/issues.ts";
import type { Verdict } from "../../sim/simulation.ts";
import { verdictOf, type VerdictReason } from "../verdict.ts";
import { gainsOf, LEAST, measureOf, measureOfRun, type Gain, type Measure } from "./measure.ts";
import type { CutMaterial } from "../../program/tools/cutting-table.ts";
import { isBent } from "./bending.ts";
import type { Attempt, Trial } from "./situation.ts";
import type { Run } from "../../program/state/run-types.ts";

/** A point of the finished surface with its theoretical roughness, µm. */
interface SurfacePoint {
  readonly at: Pt;
  readonly rz: number;
}

/** What a way is judged against: plain data of the program before. */
export interface Baseline {
  readonly material: CutMaterial;
  readonly measure: Measure;
  readonly verdict: Verdict;
  /** How often each kind of finding occurs: reasons of the verdict, errors and warnings. */
  readonly faults: Readonly<Record<string, number>>;
  readonly gouge: number;
  readonly final: readonly Ring[];
  readonly residual: readonly Ring[];
  readonly surface: readonly SurfacePoint[];
}

const RANK: Readonly<Record<Verdict, number>> = { faults: 0, incomplete: 1, proved: 2 };

/** Residual material may differ by this much, and any other material of the part, mm². */
const NO_DIFFERENCE = 0.05;
/** A surface may be rougher by this share and this much, µm; its points belong together up to this distance, mm. */
const SAME_RZ = { share: 1.02, more: 0.1, near: 0.25 } as const;
/** A workpiece that bends too far may bend further by this share. */
const SAME_BENDING = 1.02;
/** A way that saves tools may take longer by this share of the time. */
const MOST_LONGER = 0.05;
/** Most points of a surface that are compared. */
const MOST_POINTS = 600;

const reasonKeys = (reason: VerdictReason): readonly string[] =>
  reason.kind === "notes"
    ? reason.notes.map((note) => `note ${note}`)
    : reason.kind === "error"
      ? []
      : [`reason ${reason.kind}`];

const issueKeys = (found: readonly Pick<Run["issues"][number], "issue">[]): readonly string[] =>
  found.flatMap(({ issue: { severity, code } }) => (severity === "info" ? [] : [`${severity} ${code}`]));

function counted(keys: readonly string[]): Readonly<Record<string, number>> {
  const count: Record<string, number> = {};
  for (const key of keys) count[key] = (count[key] ?? 0) + 1;
  return count;
}

const faultsOf = ({ run, simulation }: Attempt, reasons: readonly VerdictReason[]): Readonly<Record<string, number>> =>
  counted([...issueKeys(run.issues), ...issueKeys(stockIssues(simulation)), ...reasons.flatMap(reasonKeys)]);

function surfaceOf({ run: { steps, spindles }, simulation: { final, checkpoints } }: Attempt): readonly SurfacePoint[] {
  const first = checkpoints.reduce((last, { step, isStated }) => (isStated ? step : last), 0);
  return roughnessOf(final, steps, spindles, first)
    .flatMap(({ points, rz }): readonly SurfacePoint[] => {
      const at = points[points.length >> 1];
      return at && rz !== null && Number.isFinite(rz) ? [{ at, rz }] : [];
    })
    .slice(0, MOST_POINTS);
}

/** The baseline of a program. */
export function baselineOf(attempt: Attempt, material: CutMaterial): Baseline {
  const { run, simulation } = attempt;
  const { verdict, reasons } = verdictOf(run, simulation);
  return {
    material,
    measure: measureOf(attempt, material),
    verdict,
    faults: faultsOf(attempt, reasons),
    gouge: simulation.proof.gouge,
    final: simulation.final,
    residual: simulation.proof.residual.flatMap(({ ring, isAsked }) => (isAsked ? [] : [ring])),
    surface: surfaceOf(attempt),
  };
}

const outside = (area: readonly Ring[], other: readonly Ring[]): number =>
  areaOf(withoutSlivers(difference(area, other)));

/** Whether the part is the same: nothing more is left, and what is gone was residual material. */
function isSamePart({ final, residual }: Baseline, now: readonly Ring[]): boolean {
  return outside(now, final) <= NO_DIFFERENCE && outside(difference(final, residual), now) <= NO_DIFFERENCE;
}

/** Whether no place of the surface has become rougher. */
function isAsSmooth(before: readonly SurfacePoint[], now: readonly SurfacePoint[]): boolean {
  return now.every(({ at, rz }) => {
    let [nearest, known] = [Infinity, Infinity];
    for (const point of before) {
      const apart = part.apart(point.at, at);
      if (apart < nearest) [nearest, known] = [apart, point.rz];
    }
    return nearest > SAME_RZ.near || rz <= known * SAME_RZ.share + SAME_RZ.more;
  });
}

const hasNoNewFaults = (before: Baseline["faults"], now: Baseline["faults"]): boolean =>
  Object.entries(now).every(([key, count]) => count <= (before[key] ?? 0));

const isMuchLonger = (is: Measure, was: Measure): boolean => is.seconds - was.seconds > MOST_LONGER * was.seconds;

/** What a tried program measures and gains. */
export interface Improvement {
  readonly measure: Measure;
  readonly gains: readonly Gain[];
}

/** Whether stock and check of a run have to be known to judge it: its times, tools and issues alone do not decide. */
function isWorthSimulating({ measure: was, verdict, faults }: Baseline, run: Run): boolean {
  if (!hasNoNewFaults(faults, counted(issueKeys(run.issues)))) return false;
  if (verdict !== "proved" || was.residual >= LEAST.residual || isBent(was.bending)) return true;
  const is = { ...was, ...measureOfRun(run) };
  const isCostly = is.tools > was.tools || is.changes > was.changes || isMuchLonger(is, was);
  return !isCostly && gainsOf(was, is).length > 0;
}

/**
 * Judges a tried program; null unless it is better: the same part with the same surface, no finding more, and a
 * measurable gain that costs nothing else, apart from a little time for a tool or a cut of residual material.
 */
export function judged(before: Baseline, { run, simulated }: Trial): Improvement | null {
  if (!isWorthSimulating(before, run)) return null;
  const attempt = { run, simulation: simulated() };
  const { simulation } = attempt;
  const { verdict, reasons } = verdictOf(run, simulation);
  const measure = measureOf(attempt, before.material);
  const was = before.measure;
  if (RANK[verdict] < RANK[before.verdict]) return null;
  if (simulation.proof.gouge > before.gouge || measure.residual > was.residual + NO_DIFFERENCE) return null;
  if (isBent(measure.bending) && measure.bending > was.bending * SAME_BENDING) return null;
  if (!hasNoNewFaults(before.faults, faultsOf(attempt, reasons))) return null;
  const gains: readonly Gain[] = [
    ...(RANK[verdict] > RANK[before.verdict] ? (["verdict"] as const) : []),
    ...gainsOf(was, measure),
  ];
  const cleaner = gains.includes("verdict") || gains.includes("residual") || gains.includes("bending");
  const more = measure.tools > was.tools || measure.changes > was.changes;
  // Without data of the machine a change of the tool costs no time: time alone must not be bought with one.
  if (gains.length === 0 || (more && !cleaner)) return null;
  // A program with faults is first put right.
  if (before.verdict === "faults" && !gains.includes("verdict")) return null;
  if (!cleaner && isMuchLonger(measure, was)) return null;
  if (!isSamePart(before, simulation.final) || !isAsSmooth(before.surface, surfaceOf(attempt))) return null;
  return { measure, gains };
}

import { at, part, type Pt, type Segment } from "../../kernel/geometry/point.ts";
import { ROUND, SAME } from "../../kernel/tolerance.ts";
import { diameter, INCH, toDiameter, toRadius } from "../../kernel/units.ts";
import { chainsOf, turnedAround } from "./dxf-chain.ts";
import { dxfCurves, type DxfPlacing } from "./dxf-curves.ts";
import { newRow, type ContourRow } from "../job/job.ts";

/** Import options of a drawing. */
export interface DxfChoice extends DxfPlacing {
  /** Gap tolerance for joining ends, mm. */
  readonly tolerance: number;
  /** Index of the chain, 0 for the longest. */
  readonly chain: number;
  /** Reverses the direction. */
  readonly reversed: boolean;
}
export const dxfDefaults: DxfChoice = {
  swapped: false,
  flipped: false,
  diameters: false,
  zeroRight: false,
  tolerance: 0.01,
  chain: 0,
  reversed: false,
};

/** Issues of a drawing; errors leave no contour. X as diameter. */
export type DxfIssue =
  | { readonly code: "nothing" | "arcsInDiameters" | "tooMany" | "onlyAxis"; readonly severity: "error" }
  | {
      readonly code: "skipped";
      readonly severity: "info";
      readonly kind: string;
      readonly count: number;
    }
  | { readonly code: "broken"; readonly severity: "warning"; readonly count: number }
  | { readonly code: "chains"; readonly severity: "warning"; readonly count: number }
  | { readonly code: "branch"; readonly severity: "warning"; readonly x: number; readonly z: number }
  | { readonly code: "gapsClosed"; readonly severity: "info"; readonly count: number; readonly widest: number }
  | {
      readonly code: "axisDropped" | "closed" | "inches";
      readonly severity: "info";
    }
  | { readonly code: "belowAxis"; readonly severity: "error"; readonly x: number; readonly z: number };

/** Reading of a drawing: the rows of its contour, and the number of chains to choose from. */
export interface DxfReading {
  readonly rows: readonly ContourRow[];
  readonly chains: number;
  readonly issues: readonly DxfIssue[];
}

/** Output of a DXF parser, as far as it is used here. */
export interface ParsedDxf {
  readonly entities?: readonly unknown[];
  readonly header?: Readonly<Record<string, unknown>>;
}

/** Most lines and arcs that are read. */
const MOST = 20_000;
/** Millimetres per header unit; drawings without units are in mm. */
const UNITS: Readonly<Record<number, number>> = { 1: INCH, 2: 12 * INCH, 4: 1, 5: 10, 6: 1000 };

function placed(s: Segment, choice: DxfChoice): Segment {
  const put = (p: Pt): Pt => {
    const [z, x] = choice.swapped ? [p.r, p.z] : [p.z, p.r];
    return at(choice.flipped ? -z : z, choice.diameters ? toRadius(diameter(x)) : x);
  };
  const over = choice.swapped !== choice.flipped;
  return s.kind === "line"
    ? { kind: "line", from: put(s.from), to: put(s.to) }
    : {
        kind: "arc",
        from: put(s.from),
        to: put(s.to),
        centre: put(s.centre),
        turn: over === (s.turn === "cw") ? "ccw" : "cw",
      };
}

const onAxis = (s: Segment, tolerance: number) =>
  s.kind === "line" && Math.abs(s.from.r) <= tolerance && Math.abs(s.to.r) <= tolerance;
const spot = (p: Pt) => ({ x: toDiameter(p.r), z: p.z });

/** Reads lines, arcs and polylines of a drawing into the rows of a contour. */
export function readDxf(dxf: ParsedDxf, choice: DxfChoice): DxfReading {
  const issues: DxfIssue[] = [];
  const units = dxf.header?.["$INSUNITS"],
    scale = (typeof units === "number" ? UNITS[units] : undefined) ?? 1;
  if (units === 1) issues.push({ code: "inches", severity: "info" });
  const { curves, skipped, broken } = dxfCurves(dxf.entities ?? [], scale);
  skipped.forEach((count, kind) => issues.push({ code: "skipped", severity: "info", kind, count }));
  if (broken > 0) issues.push({ code: "broken", severity: "warning", count: broken });
  const none = (code: "nothing" | "arcsInDiameters" | "tooMany" | "onlyAxis", chains = 0): DxfReading => ({
    rows: [],
    chains,
    issues: [{ code, severity: "error" }, ...issues],
  });
  if (curves.length === 0) return none("nothing");
  if (curves.length > MOST) return none("tooMany");
  const all = curves.map((s) => placed(s, choice)),
    off = all.filter((s) => !onAxis(s, Math.max(choice.tolerance, SAME)));
  if (off.length === 0) return none("onlyAxis");
  if (off.length < all.length) issues.push({ code: "axisDropped", severity: "info" });
  const chains = chainsOf(off, choice.tolerance),
    chain = chains[choice.chain] ?? chains[0];
  if (!chain) return none("nothing");
  if (chains.length > 1) issues.push({ code: "chains", severity: "warning", count: chains.length });
  if (choice.diameters && chain.segments.some((s) => s.kind === "arc")) return none("arcsInDiameters", chains.length);
  if (chain.gaps > 0) issues.push({ code: "gapsClosed", severity: "info", count: chain.gaps, widest: chain.widest });
  if (chain.closed) issues.push({ code: "closed", severity: "info" });
  for (const p of chain.branches) issues.push({ code: "branch", severity: "warning", ...spot(at(p.z, p.r)) });
  const run = choice.reversed ? chain.segments.map(turnedAround).reverse() : chain.segments;
  const low = run.flatMap((s) => [s.from, s.to]).find((p) => p.r < -Math.max(choice.tolerance, SAME));
  if (low) issues.push({ code: "belowAxis", severity: "error", ...spot(low) });
  return { rows: low ? [] : rowsOf(run, choice.zeroRight), chains: chains.length, issues };
}

/** A coordinate as typed, at the resolution of a control. */
const typed = (n: number) => String(Number(n.toFixed(3)) || 0);

function rowsOf(run: readonly Segment[], zeroRight: boolean): ContourRow[] {
  const first = run[0];
  if (!first) return [];
  const shift = zeroRight ? Math.max(...run.flatMap((s) => [s.from.z, s.to.z])) : 0;
  // At a closed gap between a line and an arc, the line is adjusted: the arc keeps its circle.
  const ends = run.map((s, i) => {
    const next = run[i + 1];
    return s.kind === "line" && next?.kind === "arc" ? next.from : s.to;
  });
  const write = (p: Pt) => ({ x: typed(toDiameter(p.r)), z: typed(p.z - shift) });
  let before = write(first.from);
  const rows = [newRow("e1", before)];
  run.forEach((s, i) => {
    const end = write(ends[i] ?? s.to),
      id = `e${i + 2}`;
    if (end.x === before.x && end.z === before.z) return;
    if (s.kind === "line")
      rows.push(newRow(id, { x: end.x === before.x ? "" : end.x, z: end.z === before.z ? "" : end.z }));
    else {
      const size = Math.hypot(s.from.z - s.centre.z, s.from.r - s.centre.r),
        long = part.sweepOf(s) > Math.PI + ROUND;
      rows.push(newRow(id, { kind: "CR", ...end, r: typed(long ? -size : size), turn: s.turn }));
    }
    before = end;
  });
  return rows;
}

import { curvatureUnknown, flanksUnknown } from "../kernel/cutter/insert.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import type { Run } from "../program/state/run-types.ts";
import { REAL_AREA } from "../kernel/area/real-area.ts";
import { unknownHolders } from "../sim/known-holders.ts";
import { STOCK_FAULTS, type StockFinding, type Simulation, type Verdict } from "../sim/simulation.ts";

/**
 * A reason for a verdict, as data: the block where it begins (null: the whole program) and its subject. `file`: the
 * called program with the reason; the block is then that of the call.
 */
export type VerdictReason =
  /** Errors that the run found in the program: how many, and the block of the first. */
  | { readonly kind: "error"; readonly block: number | null; readonly count: number; readonly file?: string }
  /** Found in the stock: number of places and total mm². */
  | { readonly kind: StockFinding["kind"]; readonly block: number; readonly count: number; readonly area: number }
  /** Something was read but not simulated; everything from its block on is unverified. */
  | { readonly kind: "unproved"; readonly block: number | null; readonly what: string; readonly file?: string }
  /** Milling changes the stock in a way that the half plane cannot show. */
  | { readonly kind: "milling"; readonly block: number }
  | { readonly kind: "nothingCut"; readonly block: number; readonly operation: number }
  | { readonly kind: "noOperation"; readonly block: null }
  /** Path and stock are verified, but the result is probably not intended. */
  | { readonly kind: "notes"; readonly block: number | null; readonly notes: readonly VerdictNote[] }
  /**
   * The verdict holds, but the holder of this tool, the flanks of its insert, or the curvature of its blade were not
   * checked.
   */
  | {
      readonly kind: "holderUnknown" | "flanksUnknown" | "curvatureUnknown";
      readonly block: number;
      readonly tool: number;
      readonly name: string;
    };

/**
 * An implausible feed, mostly air passes of an operation, much residual material, or a cutting edge too short for an
 * operation.
 */
export type VerdictNote = "feed" | "air" | "residue" | "cutLength";

/** The verdict on a run with all its reasons, the gravest first. */
export interface Judged {
  readonly verdict: Verdict;
  readonly reasons: readonly VerdictReason[];
  /** True when verified with nothing unchecked: only then may a screen show green. */
  readonly isClear: boolean;
}

/** The verdict over a run and its simulation. */
export function verdictOf(run: Run, simulation: Pick<Simulation, "findings" | "proof">): Judged {
  const [faults, gaps] = [faultsOf(run, simulation), gapsOf(run, simulation)];
  const verdict = faults.length > 0 ? "faults" : gaps.length > 0 ? "incomplete" : "proved";
  const notes = [...(verdict === "proved" ? notesOf(run, simulation.proof) : []), ...undescribedTools(run)];
  return { verdict, reasons: [...faults, ...gaps, ...notes], isClear: verdict === "proved" && notes.length === 0 };
}

function faultsOf(run: Run, { findings }: Pick<Simulation, "findings">): VerdictReason[] {
  const out: VerdictReason[] = [];
  const errors = run.issues.filter((f) => f.issue.severity === "error");
  const [first] = errors;
  if (first)
    out.push({
      kind: "error",
      block: first.block,
      count: errors.length,
      ...(first.inFile && { file: first.inFile.file }),
    });
  for (const kind of STOCK_FAULTS) {
    const of = findings.filter((f) => f.kind === kind);
    if (of[0]) out.push({ kind, block: of[0].block, count: of.length, area: of.reduce((sum, f) => sum + f.area, 0) });
  }
  return out;
}

/** Parts that were not simulated or had no effect, in program order where known. */
function gapsOf(run: Run, { findings, proof }: Pick<Simulation, "findings" | "proof">): VerdictReason[] {
  const out: VerdictReason[] = proof.unproved.map(({ block, what, file }) => ({
    kind: "unproved",
    block,
    what,
    ...(file !== undefined && { file }),
  }));
  const milled = run.plane.find((s) => s.kind !== "rapid");
  if (milled) out.push({ kind: "milling", block: milled.block });
  run.operations.forEach((o, operation) => {
    const failed =
      o.issues.some((i) => i.severity === "error") ||
      findings.some((f) => f.kind === "cutOnLoosePiece" && f.operation === operation);
    if (!failed && (proof.operations[operation]?.cut ?? 0) < REAL_AREA)
      out.push({ kind: "nothingCut", block: o.block, operation });
  });
  if (run.operations.length === 0) out.push({ kind: "noOperation", block: null });
  return out;
}

/** Residual material larger than a corner, mm². */
const MUCH = 1;

/** Everything a setter should see before calling the program verified, in one reason. */
function notesOf(run: Run, { operations, residual }: Simulation["proof"]): VerdictReason[] {
  const left = residual.filter((r) => !r.isAsked);
  const isInAir = ({ plan: { passes } }: Run["operations"][number], i: number): boolean => {
    const { cut = 0, airPasses = 0 } = operations[i] ?? {};
    return passes > 1 && cut >= REAL_AREA && 2 * airPasses > passes;
  };
  const inAir = run.operations.findIndex(isInAir);
  const said = (code: string) => run.issues.find((f) => f.issue.code === code);
  const [feed, short] = [said("feedUnlikely"), said("depthOverCutLength")];
  const cutShort = left.find((r) => r.reason === "cutLength");
  const notes: readonly VerdictNote[] = [
    ...(feed ? ["feed" as const] : []),
    ...(inAir >= 0 ? ["air" as const] : []),
    ...(left.reduce((sum, r) => sum + r.area, 0) > MUCH ? ["residue" as const] : []),
    ...(short || cutShort ? ["cutLength" as const] : []),
  ];
  const block =
    feed?.block ??
    run.operations[inAir]?.block ??
    short?.block ??
    run.operations[left[0]?.operation ?? -1]?.block ??
    null;
  return notes.length > 0 ? [{ kind: "notes", block, notes }] : [];
}

/** Tools that moved and are not described in full, each once. */
function undescribedTools(run: Run): VerdictReason[] {
  const first = new Map<number, { readonly tool: Tool; readonly block: number }>();
  const unknown = unknownHolders(run);
  for (const { tool, block } of run.steps) if (!first.has(tool.T)) first.set(tool.T, { tool, block });
  return [...first.values()].flatMap(({ tool, block }) => {
    const about = { block, tool: tool.T, name: tool.NAME };
    return [
      ...(unknown.has(tool.T) ? [{ kind: "holderUnknown", ...about } as const] : []),
      ...(flanksUnknown(tool) ? [{ kind: "flanksUnknown", ...about } as const] : []),
      ...(curvatureUnknown(tool) ? [{ kind: "curvatureUnknown", ...about } as const] : []),
    ];
  });
}

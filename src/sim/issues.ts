import { issue, type Issue } from "../kernel/issue.ts";
import { toDiameter } from "../kernel/units.ts";
import type { Finding, Residual, Simulation } from "./simulation.ts";

/** An issue of the proof with where it belongs; block and operation are null for what is left at the end. */
export interface ProofIssue {
  readonly issue: Issue;
  readonly step: number | null;
  readonly block: number | null;
  readonly operation: number | null;
}

function fromFinding(f: Finding): ProofIssue {
  const [x, z] = [toDiameter(f.place.r), f.place.z];
  const what =
    f.kind === "holderContact" ? issue("holderContact", "error", { x, z }) : issue(f.kind, "error", { area: f.area, x, z });
  return { issue: what, step: f.step, block: f.block, operation: f.operation };
}

function fromResidual(r: Residual): ProofIssue {
  const data = { reason: r.reason, area: r.area, x: toDiameter(r.place.r), z: r.place.z };
  return { issue: issue("materialLeft", r.reason === "oversize" ? "info" : "warning", data), step: null, block: null, operation: r.operation };
}

/** What the simulation found, as issues: each contact of each move, then each region that stays. X is a diameter. */
export const issuesOf = (simulation: Pick<Simulation, "findings" | "proof">): ProofIssue[] => [
  ...simulation.findings.map(fromFinding), ...simulation.proof.residual.map(fromResidual),
];

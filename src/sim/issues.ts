import { issue, type Issue } from "../kernel/plan/issue.ts";
import { REAL_AREA } from "../kernel/area/real-area.ts";
import type { Pt } from "../kernel/geometry/point.ts";
import { radius, toDiameter } from "../kernel/units.ts";
import { withoutConsequences, type Explained, type ProofIssue } from "./causes.ts";
import { MOST_CONTACTS } from "./check.ts";
import { isTooDeep } from "./measure.ts";
import type { AnyFinding, Depth, LoosePiece, OperationProof, Residual, Simulation, ThreadWay } from "./simulation.ts";

/** Tolerance above the crest of a thread, below which there is no shoulder, mm. */
const OVER_CREST = 0.05;

/** The overrun of a thread as an issue, by its cause; null for damage elsewhere. */
function overrun({ crest, stop, openSide }: ThreadWay, { place, area }: AnyFinding): Issue | null {
  const [before, last] = [crest.at(-2), crest.at(-1)];
  if (!before || !last) return null;
  const inFace = Math.abs(openSide.z) > Math.abs(openSide.r);
  const [z, r] = inFace ? [0, Math.sign(last.r - before.r)] : [Math.sign(last.z - before.z), 0];
  const beyond = (p: Pt) => (p.z - last.z) * z + (p.r - last.r) * r;
  if (beyond(place) <= 0) return null;
  const k = beyond(place) / -beyond(before);
  const over =
    (place.z - last.z - k * (last.z - before.z)) * openSide.z +
    (place.r - last.r - k * (last.r - before.r)) * openSide.r;
  const along = (p: Pt) => (inFace ? toDiameter(p.r) : p.z);
  return issue("threadOverruns", "error", {
    meets: over > OVER_CREST ? "shoulder" : "shaft",
    area,
    x: toDiameter(place.r),
    z: place.z,
    axis: inFace ? "X" : "Z",
    end: along(last),
    to: along(stop),
  });
}

function whatOf({
  kind,
  area,
  place,
  block,
  clamp,
  idle,
  hole,
  limit,
  other = block,
  rear = place.z,
}: AnyFinding): Issue {
  const [x, z] = [toDiameter(place.r), place.z];
  if (clamp) return issue("clampContact", "error", { ...clamp, x, z });
  switch (kind) {
    case "holderContact":
    case "clampContact":
      return issue("holderContact", "error", { x, z });
    case "cutOnLoosePiece":
      return issue(kind, "error", { area, x, z, block: other });
    case "cutBelowContour":
      return issue(kind, "warning", { area, x, z, block: other });
    case "intendedCut":
      return issue(kind, "info", { area, x, z, blocks: [block] });
    case "rapidBehindBlank":
      return issue("behindBlank", "error", { motion: "rapid", x, z, rear });
    case "feedBehindBlank":
      return issue("behindBlank", "warning", { motion: "feed", x, z, rear });
    case "spindleStopped":
      return issue(kind, "error", { how: idle?.how ?? "stopped", ...(idle && idle.by !== null && { block: idle.by }) });
    case "toolLimit":
      return issue(kind, "error", { tool: 0, column: "CDX", value: 0, limit: 0, ...limit, x, z });
    case "holeMissing":
      return issue(kind, "error", { tool: hole?.tool ?? 0, diameter: toDiameter(radius(hole?.drill ?? 0)), z });
    default:
      return issue(kind, "error", { area, x, z });
  }
}

function fromFinding(f: AnyFinding, operations: readonly OperationProof[]): ProofIssue {
  const way = f.kind === "gouge" && f.operation !== null ? operations[f.operation]?.thread : null;
  return { issue: (way && overrun(way, f)) ?? whatOf(f), step: f.step, block: f.block, operation: f.operation };
}

/** A loose piece as an issue. Rings, slugs and pieces that were not parted off on purpose are warnings. */
function fromLoose({ shape, isPartedOff, area, place, step, block, operation }: LoosePiece): ProofIssue {
  const data = { area, block, x: toDiameter(place.r), z: place.z };
  const what = isPartedOff ? issue("partedOff", "info", data) : issue("cameLoose", "warning", { shape, ...data });
  return { issue: what, step: step - 1, block, operation };
}

/** Nothing of the outside is left where the blank is held. */
const fromUnheld = ({ unheld }: Simulation["proof"]): ProofIssue[] => {
  if (!unheld) return [];
  const { place, rear, step, block, operation } = unheld;
  return [
    {
      issue: issue("behindBlank", "warning", { motion: "unheld", x: toDiameter(place.r), z: place.z, rear }),
      step,
      block,
      operation,
    },
  ];
};

function fromResidual(r: Residual): ProofIssue {
  const data = {
    reason: r.reason,
    area: r.area,
    x: toDiameter(r.place.r),
    z: r.place.z,
    ...(r.isAsked && { asked: true as const }),
  };
  return {
    issue: issue("materialLeft", r.isAsked ? "info" : "warning", data),
    step: null,
    block: null,
    operation: r.operation,
  };
}

/** The stock issues of one operation: start point, depth of cut and removed material. */
function fromOperation(
  { cut, airPasses, deepest, thickest, behindLimits, startInMaterial: start, crest }: OperationProof,
  operation: number,
): ProofIssue[] {
  const at = (found: Issue, depth: Pick<Depth, "step" | "block"> | null = null): ProofIssue => ({
    issue: found,
    step: depth?.step ?? null,
    block: depth?.block ?? null,
    operation,
  });
  const out: ProofIssue[] = [];
  if (start) out.push(at(issue("startInMaterial", "warning", { x: toDiameter(start.r), z: start.z }, "start.x")));
  for (const d of [deepest, thickest])
    if (d && isTooDeep(d)) {
      const { depth, allowed, pass } = d;
      out.push(at(issue("deeperThanInfeed", "warning", { depth, allowed, ...(pass !== undefined && { pass }) }), d));
    }
  for (const b of behindLimits) {
    const { area, place, finishing, limit } = b;
    out.push(
      at(issue("cutBehindLimit", "warning", { area, x: toDiameter(place.r), z: place.z, finishing }, limit.at), b),
    );
  }
  if (crest) {
    const { missing, inFace, r } = crest;
    out.push(
      at(
        issue(
          "crestMissing",
          "warning",
          inFace ? { missing, z: crest.z } : { missing, diameter: toDiameter(radius(r)) },
        ),
      ),
    );
  }
  if (cut < REAL_AREA) out.push(at(issue("nothingCut", "warning", {})));
  else if (airPasses > 0) out.push(at(issue("airPasses", "info", { count: airPasses })));
  return out;
}

/** Issues of blanks stated after cuts: missing material, or material already cut. */
const fromStated = ({ stated }: Simulation["proof"]): ProofIssue[] =>
  stated.flatMap(({ step, block, what, missingArea, extraArea }) => {
    const found =
      missingArea > 0
        ? issue("blankLacks", "warning", { what, area: missingArea })
        : extraArea > 0
          ? issue("blankGone", "info", { what, area: extraArea })
          : null;
    return found ? [{ issue: found, step, block, operation: null }] : [];
  });

const explainedIn = ({ operations }: Simulation["proof"]): Explained => {
  const those = (of: (operation: OperationProof) => boolean) =>
    new Set(operations.flatMap((each, i) => (of(each) ? [i] : [])));
  return { failed: those(({ hasFailed }) => hasFailed), questioned: those(({ isQuestioned }) => isQuestioned) };
};

/** Where the simulation no longer looked for contacts of moves. */
const fromUnlooked = ({ uncheckedFrom }: Simulation["proof"]): ProofIssue[] =>
  uncheckedFrom
    ? [{ issue: issue("contactsUnlooked", "error", { limit: MOST_CONTACTS }), ...uncheckedFrom, operation: null }]
    : [];

/**
 * The simulation's findings as issues: contacts of moves, then operations, then residual material, without consequences
 * of other findings. X is a diameter.
 */
export const stockIssues = (simulation: Pick<Simulation, "findings" | "proof">): ProofIssue[] =>
  withoutConsequences(
    [
      ...simulation.findings.map((f) => fromFinding(f, simulation.proof.operations)),
      ...simulation.proof.remarks.map((f) => fromFinding(f, simulation.proof.operations)),
      ...simulation.proof.loose.map(fromLoose),
      ...fromUnheld(simulation.proof),
      ...fromUnlooked(simulation.proof),
      ...fromStated(simulation.proof),
      ...simulation.proof.operations.flatMap(fromOperation),
      ...simulation.proof.residual.map(fromResidual),
    ],
    explainedIn(simulation.proof),
  );

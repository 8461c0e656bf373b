import { wayOf } from "../../kernel/plane/mill-motion.ts";
import { partPoint, plane, type PlanePoint, type PlaneSegment } from "../../kernel/plane/plane.ts";
import type { Pt, Ring } from "../../kernel/geometry/point.ts";
import { axial, diameter, radius, toDiameter, toRadius } from "../../kernel/units.ts";
import type { RunFinding, Run } from "../../program/state/run-types.ts";
import type { ProofIssue } from "../../sim/causes.ts";
import type { AnyFinding, Simulation } from "../../sim/simulation.ts";
import type { Bounds } from "../../view/camera.ts";
import type { FindingSpot } from "./entry.ts";
import { JOINED } from "../../kernel/tolerance.ts";

type Unmarked = Omit<FindingSpot, "mark">;

/** Half the edge of the box around a single point, mm. */
const ROUND = 2;

/**
 * Share of the step at which a finding is shown: a rapid before it enters the material, the others once they have
 * happened.
 */
const SHOWN_AT = {
  rapidInStock: 0,
  gouge: 0.999,
  holderContact: 0.5,
  clampContact: 0.5,
  cutBehindLimit: 0.999,
  cutOnLoosePiece: 0.5,
  rapidBehindBlank: 0.999,
  feedBehindBlank: 0.999,
  cutBelowContour: 0.999,
  intendedCut: 0.999,
  spindleStopped: 0,
  holeMissing: 0,
  toolLimit: 0.999,
} as const;

/** The issue code of a finding of the stock. */
const codeOf = (kind: AnyFinding["kind"]) =>
  kind === "rapidBehindBlank" || kind === "feedBehindBlank" ? "behindBlank" : kind;

const roundPoint = ({ z, r }: Pt): Bounds => ({ left: z - ROUND, right: z + ROUND, low: r - ROUND, high: r + ROUND });

/** Bounding box of rings and a place, mm. */
export function boundsRound(rings: readonly Ring[], place: Pt): Bounds {
  const box = roundPoint(place);
  let { left, right, low, high } = box;
  for (const ring of rings)
    for (const p of ring) {
      left = Math.min(left, p.z);
      right = Math.max(right, p.z);
      low = Math.min(low, p.r);
      high = Math.max(high, p.r);
    }
  return { left, right, low, high };
}

const near = (a: number, b: number) => Math.abs(a - b) < JOINED;

/** The spot of an issue of the check; for residual material also its index and thickness, mm. */
interface ProofSpot {
  readonly spot: Unmarked;
  readonly residual?: number;
  readonly thickness?: number;
}

/** A spot at a position, with the rings around it. */
const spotIn = (rings: readonly Ring[], place: Pt, position: Unmarked["position"]): ProofSpot => ({
  spot: { plane: "ZX", kind: "finding", place, bounds: boundsRound(rings, place), position },
});

/** The middle of a move. */
function spotOfMove({ steps }: Simulation, step: number): Unmarked | null {
  const s = steps[step];
  if (!s) return null;
  const {
    from,
    move: { to },
  } = s;
  const place: Pt = { z: axial((from.z + to.z) / 2), r: radius((from.r + to.r) / 2) };
  return {
    plane: "ZX",
    kind: "finding",
    place,
    bounds: boundsRound([[from, to]], place),
    position: { step, fraction: 0.5 },
  };
}

/** The spot of an issue in the simulation; null if it has no place. */
export function spotOfProof(simulation: Simulation, { issue, step }: ProofIssue): ProofSpot | null {
  const { findings, proof, steps } = simulation;
  const isAt =
    ({ x, z }: { readonly x: number; readonly z: number }) =>
    ({ place }: { readonly place: Pt }) =>
      near(toDiameter(place.r), x) && near(place.z, z);
  switch (issue.code) {
    case "materialLeft": {
      const residual = proof.residual.findIndex(isAt(issue.data));
      const left = proof.residual[residual];
      if (!left) return null;
      const spot: Unmarked = {
        plane: "ZX",
        kind: "residual",
        place: left.place,
        bounds: boundsRound([left.ring], left.place),
        position: { step: steps.length, fraction: 0 },
      };
      return { spot, residual, thickness: left.thickness };
    }
    case "cutBehindLimit": {
      const b = proof.operations.flatMap((o) => o.behindLimits).find(isAt(issue.data));
      return b ? spotIn([b.ring], b.place, { step: b.step, fraction: SHOWN_AT.cutBehindLimit }) : null;
    }
    case "cameLoose":
    case "partedOff": {
      const piece = proof.loose.find(isAt(issue.data));
      return piece ? spotIn(piece.rings, piece.place, { step: piece.step, fraction: 0 }) : null;
    }
    case "gouge":
    case "threadOverruns":
    case "rapidInStock":
    case "holderContact":
    case "clampContact":
    case "cutOnLoosePiece":
    case "toolLimit":
    case "cutBelowContour":
    case "intendedCut":
    case "behindBlank": {
      const code = issue.code === "threadOverruns" ? "gouge" : issue.code;
      const f = [...findings, ...proof.remarks].find((each) => codeOf(each.kind) === code && isAt(issue.data)(each));
      if (f) return spotIn(f.rings, f.place, { step: f.step, fraction: SHOWN_AT[f.kind] });
      const { unheld } = proof;
      return unheld && spotIn([], unheld.place, { step: steps.length, fraction: 0 });
    }
    default: {
      const spot = step === null ? null : spotOfMove(simulation, step);
      return spot && { spot };
    }
  }
}

/** Margin around a milled place, in tool radii: the whole mill is visible. */
const RADII = 3;

/**
 * A spot in the working plane, at the position where the block comes nearest to it, or after the previous block if it
 * has no path.
 */
function spotInPlane({ plane: steps }: Run, x: number, y: number, block: number | null): Unmarked {
  const place = partPoint({ x, y });
  let [best, gap] = [-1, Infinity];
  steps.forEach((s, i) => {
    const far = s.block === block ? plane.distanceTo(wayOf(s), { x, y }) : Infinity;
    if (far < gap) [best, gap] = [i, far];
  });
  const own = steps[best],
    before = steps.findLastIndex((s) => s.block < (block ?? 0)),
    around = RADII * ((own ?? steps[before])?.radius ?? 0);
  const position = own ? { step: best, fraction: shareOf(wayOf(own), { x, y }) } : { step: before + 1, fraction: 0 };
  const { left, right, low, high } = roundPoint(place);
  const bounds = { left: left - around, right: right + around, low: low - around, high: high + around };
  return { plane: "XY", kind: "finding", place, bounds, position };
}

/** The share of a path that is nearest to a point, below 1: the very end belongs to the next step. */
function shareOf(way: PlaneSegment, to: PlanePoint): number {
  const long = plane.lengthOf(way);
  return long < JOINED ? 0 : Math.min(0.999, plane.along(way, plane.nearestOn(way, to)) / long);
}

/** Where a tool of a mill, an approach or a departure cuts its contour; null for findings without a place. */
export function spotOfRun(run: Run, { issue, block }: RunFinding): Unmarked | null {
  if (issue.code === "toolRadiusTooLarge" || issue.code === "pathCutsContour") {
    const { x, y } = issue.data;
    return x === undefined || y === undefined ? null : spotInPlane(run, x, y, block);
  }
  if (
    issue.code !== "approachCutsContour" &&
    issue.code !== "approachValueCutsContour" &&
    issue.code !== "approachBlocked"
  )
    return null;
  const { x, y, z } = issue.data;
  if (y !== undefined) return spotInPlane(run, x, y, block);
  if (z === undefined) return null;
  const place: Pt = { z: axial(z), r: toRadius(diameter(x)) };
  const lead = run.approaches.find((a) => a.block === block && a.plane === "ZX");
  const step = lead ? run.stepBlocks.indexOf(lead.index) : -1;
  return {
    plane: "ZX",
    kind: "finding",
    place,
    bounds: roundPoint(place),
    position: { step: Math.max(0, step), fraction: 0.5 },
  };
}

/** Letters for residual material: A, B … Z, AA …; other findings have numbers. */
export const letterOf = (index: number): string =>
  (index >= 26 ? letterOf(Math.floor(index / 26) - 1) : "") + String.fromCharCode(65 + (index % 26));

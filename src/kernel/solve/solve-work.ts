import { signOf } from "../geometry/segments.ts";
import { at, part, type Pt, type Turn } from "../geometry/point.ts";
import { constantForm, solveLinear, type Affine, type Equation } from "./solve-linear.ts";
import { SAME } from "../tolerance.ts";
import { radians, type Axial, type Degrees, type Length, type Radius } from "../units.ts";

/** A given coordinate: absolute, relative to the previous one, or none. */
export type GivenCoordinate<U extends number> = { readonly at: U } | { readonly by: U } | null;

interface Ends {
  readonly z: GivenCoordinate<Axial>;
  readonly r: GivenCoordinate<Radius>;
  /** Continues the previous element tangentially. */
  readonly tangent: boolean;
  /** The intended solution where there are two: the likelier (0) or the other. */
  readonly choice: 0 | 1;
}
/** A partly given element. The first element of a contour is only its start point. */
export type SolveElement =
  /** Angle to +Z, counter-clockwise with X upwards; it gives the direction of travel. */
  | (Ends & { readonly kind: "line"; readonly angle: Degrees | null; readonly length: Length | null })
  /** Radius in mm; negative for the longer arc. */
  | (Ends & {
      readonly kind: "arc";
      readonly turn: Turn | null;
      readonly radius: number | null;
      readonly centre: Pt | null;
    });

export interface Circle {
  readonly centre: Pt;
  readonly radius: number;
  readonly turn: Turn;
}

/** State of a contour being solved. Element i runs from point i − 1 to point i. */
export interface SolveState {
  readonly elements: readonly SolveElement[];
  readonly z: (number | null)[];
  readonly r: (number | null)[];
  /** Coordinates as functions of the free parameters; a known one is a constant. */
  readonly forms: { z: Affine; r: Affine }[];
  /** Direction of each line, radians; given or found. */
  readonly angle: (number | null)[];
  /** "straight" where a tangential arc turns out to be a line. */
  readonly circle: (Circle | "straight" | null)[];
  /** Number of solutions to choose from. */
  readonly choices: number[];
  /** Elements whose length or circle is too short to reach its neighbour. */
  readonly unreachable: Set<number>;
}

/** Longest run of unknown points solved at once. */
const STRETCH = 64;

export const pointOf = (w: SolveState, i: number): Pt | null => {
  const [z, r] = [w.z[i] ?? null, w.r[i] ?? null];
  return z === null || r === null ? null : at(z, r);
};
/** Vector from a line to the centre of a tangent arc of radius `far` with this turn. */
export const centreOffset = (turn: Turn, way: Pt, far: number): Pt => part.scaled(part.leftOf(way), signOf(turn) * far);

/** Rank of a candidate, compared in this order; the lower is better. */
export interface Rank {
  /** Number of faults: lines that run backwards, arcs without length and the like. */
  readonly faults: number;
  /** 1 when the arc is the longer one where the shorter is intended, or the reverse. */
  readonly otherWay: 0 | 1;
  /** Angle of an arc, or length of a line. */
  readonly detour: number;
}
export const byRank = (a: Rank, b: Rank) => a.faults - b.faults || a.otherWay - b.otherWay || a.detour - b.detour;
/** Rank of an arc by its angle; a negative radius asks for the longer arc. */
export function arcRank(e: SolveElement | undefined, sweep: number): Omit<Rank, "faults"> {
  const longer = e?.kind === "arc" && (e.radius ?? 0) < 0;
  return { otherWay: longer === sweep > Math.PI ? 0 : 1, detour: sweep };
}

export function startSolving(elements: readonly SolveElement[]): SolveState {
  const work: SolveState = {
    elements,
    z: [],
    r: [],
    forms: [],
    choices: elements.map(() => 1),
    unreachable: new Set(),
    circle: elements.map(() => null),
    angle: elements.map((e, i) => (i > 0 && e.kind === "line" && e.angle !== null ? radians(e.angle) : null)),
  };
  elements.forEach((e, i) => {
    for (const axis of ["z", "r"] as const) {
      const before = i === 0 ? 0 : (work[axis][i - 1] ?? null);
      work[axis].push(coordinateOf(e[axis], before));
    }
    work.forms.push({ z: constantForm(work.z[i] ?? 0), r: constantForm(work.r[i] ?? 0) });
  });
  return work;
}

/** A given coordinate as an absolute value; null if it is relative to an unknown one. */
function coordinateOf(given: GivenCoordinate<Axial> | GivenCoordinate<Radius>, before: number | null): number | null {
  if (given === null) return null;
  if ("at" in given) return given.at;
  return before === null ? null : before + given.by;
}

/**
 * Finds everything that follows from coordinates, directions and lengths along them. True if something new became
 * known.
 */
export function solveCoordinates(w: SolveState): boolean {
  let changed = false;
  const unknown = (i: number) => i < w.elements.length && (w.z[i] === null || w.r[i] === null);
  for (let i = 0; i < w.elements.length; i += 1) {
    if (!unknown(i)) continue;
    const from = i;
    while (unknown(i + 1) && i + 1 - from < STRETCH) i += 1;
    changed = solveStretch(w, from, i) || changed;
  }
  return changed;
}

function solveStretch(w: SolveState, from: number, to: number): boolean {
  const variables = new Map<string, number>();
  for (let i = from; i <= to; i += 1)
    for (const axis of ["z", "r"] as const) if (w[axis][i] === null) variables.set(`${axis}${i}`, variables.size);
  const equations: Equation[] = [];
  /**
   * Adds the equation "sum of factor times coordinate equals value" if every coordinate in it is known or belongs to
   * this run.
   */
  const add = (parts: readonly (readonly ["z" | "r", number, number])[], value: number) => {
    const terms: [number, number][] = [];
    let rest = value;
    for (const [axis, i, factor] of parts) {
      const variable = variables.get(`${axis}${i}`),
        constant = w[axis][i] ?? null;
      if (variable !== undefined) terms.push([variable, factor]);
      else if (constant === null) return;
      else rest -= constant * factor;
    }
    equations.push({ terms, value: rest });
  };
  for (let i = Math.max(1, from); i <= Math.min(to + 1, w.elements.length - 1); i += 1) {
    const e = w.elements[i],
      angle = w.angle[i] ?? null;
    for (const axis of ["z", "r"] as const) {
      const given = e?.[axis];
      if (given && "by" in given)
        add(
          [
            [axis, i, 1],
            [axis, i - 1, -1],
          ],
          given.by,
        );
    }
    if (e?.kind !== "line" || angle === null) continue;
    const way = part.heading(angle);
    add(
      [
        ["z", i, way.r],
        ["z", i - 1, -way.r],
        ["r", i, -way.z],
        ["r", i - 1, way.z],
      ],
      0,
    );
    if (e.length !== null)
      add(
        [
          ["z", i, way.z],
          ["z", i - 1, -way.z],
          ["r", i, way.r],
          ["r", i - 1, -way.r],
        ],
        e.length,
      );
  }
  // Parameters of different runs never meet in one element with both ends unknown, but they must not share names.
  const solved = solveLinear(variables.size, equations, from * 2);
  let changed = false;
  for (const [name, variable] of variables) {
    const axis = name.startsWith("z") ? "z" : "r",
      i = Number(name.slice(1)),
      form = solved[variable],
      forms = w.forms[i];
    if (!form || !forms) continue;
    forms[axis] = form;
    if (form.by.size > 0) continue;
    w[axis][i] = form.constant;
    changed = true;
  }
  for (let i = from; i <= to; i += 1)
    for (const axis of ["z", "r"] as const) {
      const constant = w[axis][i] ?? null,
        forms = w.forms[i];
      if (forms && constant !== null) forms[axis] = constantForm(constant);
    }
  return changed;
}

/** Sets the unknown coordinates of a point that was found. True if there were any. */
export function setFoundPoint(w: SolveState, i: number, found: Pt): boolean {
  let news = false;
  for (const axis of ["z", "r"] as const)
    if (w[axis][i] === null && Number.isFinite(found[axis])) {
      w[axis][i] = found[axis];
      const forms = w.forms[i];
      if (forms) forms[axis] = constantForm(found[axis]);
      news = true;
    }
  return news;
}

/** True for points that are identical on a control. */
export const isSamePoint = (a: Pt, b: Pt) => part.apart(a, b) <= SAME;

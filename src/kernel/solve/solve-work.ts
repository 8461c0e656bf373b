import { signOf } from "../geometry/segments.ts";
import { at, part, type Pt, type Turn } from "../geometry/point.ts";
import { known, solveLinear, type Affine, type Equation } from "./solve-linear.ts";
import { SAME } from "../tolerance.ts";
import { radians, type Axial, type Degrees, type Length, type Radius } from "../units.ts";

/** What is given of a coordinate: where it is, how far it is from the one before, or nothing. */
export type GivenCoordinate<U extends number> = { readonly at: U } | { readonly by: U } | null;

interface Ends {
  readonly z: GivenCoordinate<Axial>;
  readonly r: GivenCoordinate<Radius>;
  /** It leaves the element before it in that one's direction. */
  readonly tangent: boolean;
  /** Which solution is meant where there are two: the likelier (0) or the other. */
  readonly choice: 0 | 1;
}
/** An element of which some things are given. The first element of a contour is only its start point. */
export type SolveElement =
  /** Angle to +Z, counter-clockwise with X upwards; it tells the direction of travel. */
  | (Ends & { readonly kind: "line"; readonly angle: Degrees | null; readonly length: Length | null })
  /** Radius in mm; negative takes the longer way round. */
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

/** What is known so far while a contour is being solved. Element i runs from point i − 1 to point i. */
export interface Solving {
  readonly elements: readonly SolveElement[];
  readonly z: (number | null)[];
  readonly r: (number | null)[];
  /** Coordinates by what is still free; a known one is a constant. */
  readonly forms: { z: Affine; r: Affine }[];
  /** Direction of each line, radians; given or found. */
  readonly angle: (number | null)[];
  /** "straight" where a tangential arc turns out to be a line. */
  readonly circle: (Circle | "straight" | null)[];
  /** How many solutions there were to choose from. */
  readonly choices: number[];
  /** Elements whose length or circle does not reach what it should. */
  readonly unreachable: Set<number>;
}

/** Longest stretch of unknown points that is solved at once. */
const STRETCH = 64;

export const pointOf = (w: Solving, i: number): Pt | null => {
  const [z, r] = [w.z[i] ?? null, w.r[i] ?? null];
  return z === null || r === null ? null : at(z, r);
};
/** The way from a line to the centre of an arc of radius `far` that touches it and turns so. */
export const aside = (turn: Turn, way: Pt, far: number): Pt => part.scaled(part.leftOf(way), signOf(turn) * far);

/** How well a candidate fits, to be compared in this order; the lower comes first. */
export interface Rank {
  /** Lines that would run backwards, arcs of no length and the like. */
  readonly faults: number;
  /** 1 when an arc goes the longer way round where the shorter one is meant, or the other way about. */
  readonly otherWay: 0 | 1;
  /** How far round an arc turns, or how long the way is. */
  readonly detour: number;
}
export const byRank = (a: Rank, b: Rank) => a.faults - b.faults || a.otherWay - b.otherWay || a.detour - b.detour;
/** The arc of an element by its way round; a negative radius means the longer one. */
export function arcRank(e: SolveElement | undefined, sweep: number): Omit<Rank, "faults"> {
  const longer = e?.kind === "arc" && (e.radius ?? 0) < 0;
  return { otherWay: longer === sweep > Math.PI ? 0 : 1, detour: sweep };
}

export function startSolving(elements: readonly SolveElement[]): Solving {
  const work: Solving = {
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
    work.forms.push({ z: known(work.z[i] ?? 0), r: known(work.r[i] ?? 0) });
  });
  return work;
}

/** A given coordinate, counted from the one before where it is a distance; null where that is not known. */
function coordinateOf(given: GivenCoordinate<Axial> | GivenCoordinate<Radius>, before: number | null): number | null {
  if (given === null) return null;
  if ("at" in given) return given.at;
  return before === null ? null : before + given.by;
}

/**
 * Everything that follows from coordinates, directions and lengths along them. True when something new became known.
 */
export function settle(w: Solving): boolean {
  let changed = false;
  const unknown = (i: number) => i < w.elements.length && (w.z[i] === null || w.r[i] === null);
  for (let i = 0; i < w.elements.length; i += 1) {
    if (!unknown(i)) continue;
    const from = i;
    while (unknown(i + 1) && i + 1 - from < STRETCH) i += 1;
    changed = settleStretch(w, from, i) || changed;
  }
  return changed;
}

function settleStretch(w: Solving, from: number, to: number): boolean {
  const variables = new Map<string, number>();
  for (let i = from; i <= to; i += 1)
    for (const axis of ["z", "r"] as const) if (w[axis][i] === null) variables.set(`${axis}${i}`, variables.size);
  const equations: Equation[] = [];
  /** Sum of factor times coordinate equals value, when every coordinate in it is known or belongs to this stretch. */
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
  // Parameters of different stretches never meet in one element with both ends unknown, but keep their names apart.
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
      if (forms && constant !== null) forms[axis] = known(constant);
    }
  return changed;
}

/** Puts a point where it was found, in the coordinates that were not known. True when that is news. */
export function place(w: Solving, i: number, found: Pt): boolean {
  let news = false;
  for (const axis of ["z", "r"] as const)
    if (w[axis][i] === null && Number.isFinite(found[axis])) {
      w[axis][i] = found[axis];
      const forms = w.forms[i];
      if (forms) forms[axis] = known(found[axis]);
      news = true;
    }
  return news;
}

/** True for points that are one and the same on a control. */
export const same = (a: Pt, b: Pt) => part.apart(a, b) <= SAME;

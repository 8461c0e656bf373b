import { solveContour } from "../kernel/solve-contour.ts";
import type { GivenCoordinate, SolveElement } from "../kernel/solve-work.ts";
import { at, part, type Pt, type Segment } from "../kernel/point.ts";
import { ARC_END, SAME } from "../kernel/tolerance.ts";
import { axial, degrees, diameter, inDegrees, length, radians, radius, toDiameter, toRadius, type Axial,
  type Radius } from "../kernel/units.ts";
import type { AxisName, AxisWord, FreeForm, StatementOf, Value, Words } from "../nc/statement.ts";

type Free = StatementOf<"free">;
type Path = StatementOf<"path">;

/** The plane of a free contour: X/Y of a mill, or Z/X of a turning tool with diameters in X, or with radii. */
export type FreePlane = "XY" | "lathe" | "radii";

/** What an element leaves behind it: a path block with all coordinates; null where it can not be solved. */
export type FreeBlock = Path | null;

/** Elements of a free contour that are solved together, by their blocks. */
export interface FreeRun {
  readonly blocks: ReadonlyMap<number, FreeBlock>;
  /** The block that comes next. */
  readonly expected: number | null;
}

/** How values become numbers; all lengths in the unit of the program, counted from its datum. */
export interface FreeSetting {
  readonly plane: FreePlane;
  /** Where the first element begins; null where nobody knows. */
  readonly from: Pt | null;
  /** What ran before it, for a tangential transition. */
  readonly before: Segment | null;
  readonly number: (value: Value) => number | null;
}

/** Far above the axis: the solver holds points below it for unlikely, and a mill has no axis. */
const ASIDE = 10_000;

const IS_ELEMENT: ReadonlySet<FreeForm> = new Set(["FL", "FLT", "FC", "FCT"]);
export const isFreeElement = (s: Free): boolean => IS_ELEMENT.has(s.form);

interface Known {
  readonly s: Free;
  readonly element: SolveElement | null;
  /** The solution that FSELECT names; null without one. */
  selected: 1 | 2 | null;
}

const NAMES = { XY: ["X", "Y"], lathe: ["Z", "X"], radii: ["Z", "X"] } as const;

/** Solves a run of free elements from a known point. One result for each of its elements, in order. */
export function solveFree(run: readonly Free[], setting: FreeSetting): FreeBlock[] {
  const known = readRun(run, setting);
  const { from, before, plane } = setting;
  const unreadable = known.findIndex((k) => k.element === null);
  const readable = unreadable < 0 ? known : known.slice(0, unreadable);
  if (!from || readable.length === 0) return known.map(() => null);
  const up = plane === "XY" ? ASIDE : 0;
  const lifted = (p: Pt): Pt => at(p.z, p.r + up);
  const start = beginning(lifted(from),
    before
      && (before.kind === "arc"
        ? { ...before, from: lifted(before.from), to: lifted(before.to), centre: lifted(before.centre) }
        : { ...before, from: lifted(before.from), to: lifted(before.to) }));
  const { elements, issues } = solveContour([...start, ...readable.map((k) => k.element as SolveElement)]);
  const wrong = new Set(issues.flatMap((i) => ("element" in i.data ? [i.data.element - 1] : [])));
  let open = false;
  return known.map((k, i): FreeBlock => {
    const solved = elements[start.length + i];
    const segment = solved?.segment ?? null;
    open ||= !solved || !segment || solved.freedom > 0 || wrong.has(start.length + i);
    open ||= segment !== null && !isRound(segment, k.element);
    // Of two solutions one has to be chosen.
    open ||= (solved?.choices ?? 1) > 1 && k.selected === null;
    return open || !segment ? null : pathOf(k.s, segment, plane, up);
  });
}

/** An arc whose ends lie on one circle about its centre, of the radius that is given. */
function isRound(s: Segment, e: SolveElement | null): boolean {
  if (s.kind !== "arc") return true;
  const { startRadius, endRadius } = part.polarOf(s);
  const given = e?.kind === "arc" && e.radius !== null ? Math.abs(e.radius) : startRadius;
  return Math.abs(startRadius - endRadius) <= ARC_END && Math.abs(startRadius - given) <= ARC_END;
}

/** The start point, with the element before it where that is known. */
function beginning(from: Pt, before: Segment | null): SolveElement[] {
  const placed = (p: Pt) => ({ z: { at: axial(p.z) }, r: { at: radius(p.r) }, tangent: false, choice: 0 as const });
  const line = (p: Pt): SolveElement => ({ kind: "line", angle: null, length: null, ...placed(p) });
  if (!before || part.apart(before.to, from) > SAME) return [line(from)];
  const last: SolveElement = before.kind === "line"
    ? line(from)
    : { kind: "arc", turn: before.turn, radius: null, centre: before.centre, ...placed(from) };
  return [line(before.from), last];
}

function readRun(run: readonly Free[], setting: FreeSetting): Known[] {
  const known: Known[] = [];
  let pole: Pt | null = null;
  for (const s of run) {
    if (s.form === "FPOL") pole = pointOf(s.words.axes, setting);
    else if (s.form === "FSELECT") {
      const [last, n] = [known.at(-1), s.given[0]?.value];
      if (last && (n === 1 || n === 2)) {
        last.selected = n;
        known[known.length - 1] = { ...last, element: last.element && { ...last.element, choice: n === 2 ? 1 : 0 } };
      } else if (last) known[known.length - 1] = { ...last, element: null };
    } else known.push({ s, element: elementOf(s, setting, pole), selected: null });
  }
  return closed(known, setting);
}

const closing = (s: Free) => s.given.find((w) => w.name === "CLSD")?.value;

/** CLSD: the element that closes a contour ends where the one that begins it does. Where that is not known, nothing is gained. */
function closed(known: readonly Known[], { from, plane }: FreeSetting): Known[] {
  let begun: Pt | null = null;
  return known.map((k, i) => {
    const before = i === 0 ? from : null;
    if (closing(k.s) === 1) begun = before;
    if (closing(k.s) !== -1 || !begun || !k.element) return k;
    const end = { z: k.element.z ?? { at: begun.z }, r: k.element.r ?? { at: radius(begun.r + (plane === "XY" ? ASIDE : 0)) } };
    return { ...k, element: { ...k.element, ...end } };
  });
}

const one = (words: readonly AxisWord[], axis: AxisName) => words.find((w) => w.axis === axis);

function pointOf(words: readonly AxisWord[], { plane, number }: FreeSetting): Pt | null {
  const [a, b] = NAMES[plane].map((axis) => {
    const w = one(words, axis);
    return w && !w.incremental ? number(w.value) : null;
  });
  if (a === null || b === null || a === undefined || b === undefined) return null;
  return { z: axial(a), r: across(b, plane) };
}

/** A coordinate of the second axis as a distance: X is a diameter while turning. */
const across = (n: number, plane: FreePlane): Radius => (plane === "lathe" ? toRadius(diameter(n)) : radius(n));
const above = (n: number, plane: FreePlane): Radius => radius(across(n, plane) + (plane === "XY" ? ASIDE : 0));

/** What a block gives; null when it gives something that is not understood here, or that nobody knows. */
function elementOf(s: Free, setting: FreeSetting, pole: Pt | null): SolveElement | null {
  const { plane, number } = setting;
  const { words } = s;
  let unknown = words.extra.length > 0 || words.linear.length > 0 || words.centreAngle !== undefined;
  const read = (value: Value | undefined): number | null => {
    const n = value === undefined ? null : number(value);
    unknown ||= value !== undefined && n === null;
    return n;
  };
  const given = (name: string) => read(s.given.find((w) => w.name === name)?.value);
  const [first, second] = NAMES[plane];
  const [u, v] = [one(words.axes, first), one(words.axes, second)];
  const [un, vn] = [read(u?.value), read(v?.value)];
  let z: GivenCoordinate<Axial> = u && un !== null ? (u.incremental ? { by: axial(un) } : { at: axial(un) }) : null;
  let r: GivenCoordinate<Radius> = v && vn !== null ? (v.incremental ? { by: across(vn, plane) } : { at: above(vn, plane) }) : null;
  if (words.polarRadius || words.polarAngle) {
    const [far, angle] = [read(words.polarRadius?.value), read(words.polarAngle?.value)];
    if (!pole || far === null || angle === null || words.polarRadius?.incremental || words.polarAngle?.incremental) return null;
    const end = part.beyond(pole, part.heading(radians(angle)), far);
    [z, r] = [{ at: end.z }, { at: radius(end.r + (plane === "XY" ? ASIDE : 0)) }];
  }
  const [angle, far, size] = [given("AN"), read(words.length), read(words.radius)];
  const [cu, cv] = [given(`CC${first}`), given(`CC${second}`)];
  const [polarFar, polarAngle] = [given("CCPR"), given("CCPA")];
  const common = { z, r, tangent: s.form === "FLT" || s.form === "FCT", choice: 0 as const };
  if (unknown) return null;
  if (s.form === "FL" || s.form === "FLT") {
    if (cu !== null || cv !== null || polarFar !== null || polarAngle !== null || size !== null || words.turn) return null;
    return { ...common, kind: "line", angle: angle === null ? null : degrees(angle), length: far === null ? null : length(far) };
  }
  if (angle !== null || far !== null || (cu === null) !== (cv === null)) return null;
  if ((polarFar === null) !== (polarAngle === null) || (polarFar !== null && (!pole || cu !== null))) return null;
  const polar = pole && polarFar !== null && polarAngle !== null ? part.beyond(pole, part.heading(radians(polarAngle)), polarFar) : null;
  const lifted = polar && at(polar.z, polar.r + (plane === "XY" ? ASIDE : 0));
  const centre = cu === null || cv === null ? lifted : { z: axial(cu), r: above(cv, plane) };
  return { ...common, kind: "arc", turn: words.turn ?? null, radius: size, centre };
}

/** The element as a block that names its end. An arc of more than half a turn has a negative radius. */
function pathOf(s: Free, segment: Segment, plane: FreePlane, up: number): Path {
  const [first, second] = NAMES[plane];
  const end = segment.to.r - up;
  const axes: AxisWord[] = [...s.words.axes.filter((w) => w.axis !== first && w.axis !== second), {
    axis: first,
    value: segment.to.z,
    incremental: false,
  }, { axis: second, value: plane === "lathe" ? toDiameter(radius(end)) : end, incremental: false }];
  const { polarRadius: _p, polarAngle: _a, length: _l, radius: _r, turn: _t, ...plain } = s.words;
  const words: Words = { ...plain, axes };
  if (segment.kind === "line") return { kind: "path", path: "L", words };
  const { startRadius, endRadius, sweep } = part.polarOf(segment);
  const size = Math.max((startRadius + endRadius) / 2, part.apart(segment.from, segment.to) / 2);
  const long = Math.abs(inDegrees(sweep)) > 180;
  return { kind: "path", path: "CR", words: { ...words, radius: long ? -size : size, turn: segment.turn } };
}

import type { TurnedShape } from "../../cycles/define.ts";
import type { Site, ShapeRequest } from "../../cycles/shape-request.ts";
import type { Pt, Ring, Segment } from "../../kernel/geometry/point.ts";
import { cutThread, type NamedThread } from "../../kernel/thread/named-thread.ts";
import { axial, diameter, length, rounded, toDiameter } from "../../kernel/units.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import type { WhichRegion } from "../place/place.ts";
import { anyNumber, readText, type Field } from "../../program/values/field.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { longestOf, startOnSurface, surfacesOf } from "../../program/job/stock-surface.ts";
import { boxAroundContour, rowsOf } from "../../program/job/requested-shape.ts";

/** The stock in the chuck: solid, the shape with an oversize, or what earlier operations have left. */
export type StockChoice = "solid" | "preturned" | "now";
/** The numbers of the request. */
export type AskedMeasure = "d1" | "d2" | "z1" | "z2" | "angle" | "chamfer" | "pitch" | "allowance";

/** A request for an operation: choices, and numbers as typed. */
export interface OperationRequest {
  readonly site: Site;
  readonly shape: TurnedShape;
  readonly stock: StockChoice;
  readonly typed: Readonly<Record<AskedMeasure, string>>;
  readonly rows: readonly ContourRow[];
  /** The thread that was asked for by its name, with its diameter and pitch among the numbers; absent or null: none. */
  readonly thread?: NamedThread | null;
}

const MORE = Number.MIN_VALUE;
const field = (id: AskedMeasure, [least, most]: readonly [number, number]): Field => ({
  ...anyNumber,
  id: `which.${id}`,
  range: [least, most],
  optional: false,
  decimals: 3,
});

/** The field of each number, mm and degrees. */
export const REQUEST_FIELDS: Readonly<Record<AskedMeasure, Field>> = {
  d1: field("d1", [0, 99_999.999]),
  d2: field("d2", [0, 99_999.999]),
  z1: field("z1", [-99_999.999, 99_999.999]),
  z2: field("z2", [-99_999.999, 99_999.999]),
  angle: field("angle", [0, 89.9999]),
  chamfer: field("chamfer", [0, 99.999]),
  pitch: field("pitch", [MORE, 999.999]),
  allowance: field("allowance", [MORE, 99.999]),
};

/** A contradiction between two numbers, and the number where it is shown. */
export interface OperationRequestFault {
  readonly at: AskedMeasure | "contour";
  readonly code: "notSmaller" | "notLarger" | "same" | "contour";
}

export interface OperationRequestReading {
  /** Null while something is missing or wrong. */
  readonly wanted: ShapeRequest | null;
  readonly fault: OperationRequestFault | null;
}

/** The numbers that a shape needs, in display order. */
export function measuresOf({
  site,
  shape,
  stock,
}: Pick<OperationRequest, "site" | "shape" | "stock">): readonly AskedMeasure[] {
  const allowance: readonly AskedMeasure[] = stock === "preturned" && canBePreturned(shape) ? ["allowance"] : [];
  const hasChamfer = shape === "step" && site !== "face";
  switch (shape) {
    case "free":
      return allowance;
    case "thread":
      return ["d1", "z1", "z2", "pitch"];
    default:
      return ["d1", "d2", "z1", "z2", "angle", ...(hasChamfer ? (["chamfer"] as const) : []), ...allowance];
  }
}

/** Grooves and threads are cut into a finished surface. */
export const canBePreturned = (shape: TurnedShape): boolean => shape !== "groove" && shape !== "thread";

function faultOf(
  { site, shape }: OperationRequest,
  n: Readonly<Record<AskedMeasure, number>>,
): OperationRequestFault | null {
  if (n.z1 === n.z2) return { at: "z2", code: "same" };
  if (shape === "thread") return null;
  if (n.d1 === n.d2) return { at: "d2", code: "same" };
  if (site === "outside" && n.d2 > n.d1) return { at: "d2", code: "notSmaller" };
  return site === "inside" && n.d2 < n.d1 ? { at: "d2", code: "notLarger" } : null;
}

/** The wanted shape, if all its numbers can be read and agree. */
export function readOperationRequest(asking: OperationRequest): OperationRequestReading {
  const { site, shape, stock, typed, rows } = asking;
  const asked = measuresOf(asking);
  const numbers = Object.fromEntries(
    Object.entries(REQUEST_FIELDS).map(([m, f]) => [m, readText(f, typed[m as AskedMeasure]).value]),
  ) as Record<AskedMeasure, number | null>;
  const value = (m: AskedMeasure) => numbers[m] ?? 0;
  if (asked.some((m) => numbers[m] === null)) return { wanted: null, fault: null };
  const rest = {
    site,
    shape,
    angle: shape === "free" || shape === "thread" ? 0 : value("angle"),
    pitch: value("pitch"),
    thread: shape === "thread" ? (asking.thread ?? null) : null,
    chamfer: asked.includes("chamfer") ? length(value("chamfer")) : 0,
    allowance: asked.includes("allowance") && stock === "preturned" ? length(value("allowance")) : 0,
  } as const;
  if (shape === "free") {
    const { contour } = readRows(rows);
    const broken = contour.segments.length === 0 || contour.issues.some((i) => i.severity === "error");
    if (broken) return { wanted: null, fault: { at: "contour", code: "contour" } };
    return { wanted: { ...rest, ...boxAroundContour(contour.segments, site), contour: contour.segments }, fault: null };
  }
  const all = Object.fromEntries(Object.keys(REQUEST_FIELDS).map((m) => [m, value(m as AskedMeasure)])) as Record<
    AskedMeasure,
    number
  >;
  const fault = faultOf(asking, all);
  if (fault) return { wanted: null, fault };
  const corner = (d: number, z: number) => ({ diameter: diameter(d), z: axial(z) });
  const to = corner(shape === "thread" ? all.d1 : all.d2, all.z2);
  return { wanted: { ...rest, from: corner(all.d1, all.z1), to, contour: null }, fault: null };
}

type Typed = OperationRequest["typed"];
const numbers = (d1: string, d2: string, z1: string, z2: string, angle = "0"): Typed => ({
  d1,
  d2,
  z1,
  z2,
  angle,
  chamfer: "0",
  pitch: "2",
  allowance: "2",
});

/** Default numbers, so that the operations for a shape can be seen before anything is typed. */
export function usualNumbers(site: Site, shape: TurnedShape): Typed {
  const inside = site === "inside";
  const [open, deep] = inside ? ["30", "40"] : ["75", "60"];
  switch (shape) {
    case "groove":
      return site === "face" ? numbers("60", "40", "0", "-8") : numbers(open, inside ? "36" : deep, "-15", "-25");
    case "plunge":
      return site === "face" ? numbers("70", "30", "0", "-5", "60") : numbers(open, deep, "-10", "-50", "70");
    case "thread":
      return numbers("30", "30", "0", "-25");
    case "step":
    case "free":
      return site === "face"
        ? numbers("75", "40", "0", "-6")
        : numbers(open, inside ? "50" : "50", "0", inside ? "-25" : "-40");
  }
}

/** Diameter of the open side among the usual numbers. */
const USUAL_OPEN = { outside: 75, inside: 30, face: 75 };

/** The usual numbers of a shape, moved to the longest surface of a stock; unchanged where it has none on this site. */
export function numbersOn(stock: readonly Ring[], site: Site, shape: TurnedShape): Typed {
  const usual = usualNumbers(site, shape);
  const surface = longestOf(surfacesOf(stock, site));
  if (!surface) return usual;
  const open = toDiameter(surface.from.r);
  const share = open / USUAL_OPEN[site];
  const across = (text: string) => {
    const scaled = shape === "thread" ? open : Number(text) * share;
    return asTyped(Math.abs(scaled - open) < 1 ? open : Math.round(scaled));
  };
  const along = (text: string) => asTyped(Number(text) + startOnSurface(surface, stock));
  return { ...usual, d1: across(usual.d1), d2: across(usual.d2), z1: along(usual.z1), z2: along(usual.z2) };
}

/** The side of a thread for a place: the one that its name says, or on which it exists. */
function siteOf(thread: NamedThread, site: Site): Site {
  const wanted = thread.side ?? (site === "inside" ? "inside" : "outside");
  return thread[wanted] ? wanted : wanted === "inside" ? "outside" : "inside";
}

/** The request with diameter, pitch and, of a taper, length of its thread; without the name where it has no such side. */
function withThread(next: OperationRequest): OperationRequest {
  const { thread, site, shape, typed } = next;
  if (!thread) return next;
  const side = shape === "thread" && site !== "face" && siteOf(thread, site) === site ? thread[site] : null;
  if (!side) return { ...next, thread: null };
  const { crest, root } = cutThread(side, "middle");
  const { gauge, taper, pitch, starts } = thread;
  const wider = gauge && site === "outside" ? (gauge.useful - gauge.length) * taper : 0;
  const long = gauge && (site === "inside" ? gauge.usefulInside : gauge.useful);
  return {
    ...next,
    typed: {
      ...typed,
      d1: asTyped((site === "inside" ? root : crest) + wider),
      pitch: asTyped(pitch * starts),
      ...(long && { z2: asTyped(Number(typed.z1) - long) }),
    },
  };
}

/**
 * A request after a change. A thread stays as long as its numbers do. Typed numbers stay as long as they fit the new shape; the others are the usual ones of that
 * shape.
 */
export function changedRequest(
  before: OperationRequest,
  change: Partial<OperationRequest>,
  typed: ReadonlySet<AskedMeasure>,
  usual: typeof usualNumbers = usualNumbers,
): OperationRequest {
  let next = { ...before, ...change };
  if (change.thread) return withThread({ ...next, site: siteOf(change.thread, next.site) });
  const isRenumbered = (["d1", "pitch"] as const).some((m) => next.typed[m] !== before.typed[m]);
  if (next.thread && isRenumbered) next = { ...next, thread: null };
  const stock = next.stock === "preturned" && !canBePreturned(next.shape) ? "solid" : next.stock;
  if (change.typed !== undefined || (change.site === undefined && change.shape === undefined))
    return { ...next, stock };
  let fitting: OperationRequest = { ...next, stock, typed: usual(next.site, next.shape) };
  for (const measure of typed) {
    const tried = { ...fitting, typed: { ...fitting.typed, [measure]: before.typed[measure] } };
    if (readOperationRequest(tried).fault === null) fitting = tried;
  }
  return withThread(fitting);
}

/** A number of a drawing, as typed. */
const asTyped = (n: number) => String(rounded(n));

/** Largest distance of a groove's ends from its open side, as a share of its depth. */
const AT_THE_EDGE = 0.1;

/** Whether an element runs along an axis: a groove of the request has square corners. */
const isSquare = (s: Segment): boolean =>
  s.kind === "line" && (Math.abs(s.from.z - s.to.z) < SQUARE || Math.abs(s.from.r - s.to.r) < SQUARE);
const SQUARE = 0.001;

/**
 * The likely shape of a contour section: a groove if it is a square one that begins and ends at its open side, else a
 * free contour.
 */
function likelyShape(stretch: readonly Segment[], { d1, d2, z1, z2 }: Typed, site: Site): TurnedShape {
  const depth = ({ z, r }: Pt) =>
    site === "face"
      ? (Number(z1) - z) / (Number(z1) - Number(z2))
      : (Number(d1) - toDiameter(r)) / (Number(d1) - Number(d2));
  const [first, last] = [stretch[0]?.from, stretch.at(-1)?.to];
  const isValley =
    stretch.length > 2 && stretch.every(isSquare) && first && last && Math.max(depth(first), depth(last)) < AT_THE_EDGE;
  return isValley ? "groove" : "free";
}

/** The request for a section of an open work: the section as a contour, and its bounding box in the numbers. */
export function operationRequestAt({ contour, first, last, site, initialStock }: WhichRegion): OperationRequest {
  const stretch = contour.slice(first, last + 1);
  const { from, to } = boxAroundContour(stretch, site);
  const typed = {
    ...usualNumbers(site, "free"),
    d1: asTyped(from.diameter),
    d2: asTyped(to.diameter),
    z1: asTyped(from.z),
    z2: asTyped(to.z),
  };
  return { site, shape: likelyShape(stretch, typed, site), stock: initialStock, typed, rows: rowsOf(stretch) };
}

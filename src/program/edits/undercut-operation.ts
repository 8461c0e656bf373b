import { catalogue } from "../../cycles/index.ts";
import { noseRadius } from "../../kernel/cutter/insert.ts";
import { contourFrom, type ContourElement } from "../../kernel/contour/contour.ts";
import { undercutShape } from "../../kernel/contour/undercut.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { axial, diameter, radius, rounded, toDiameter, toRadius } from "../../kernel/units.ts";
import { noWords, type AxisWord, type Words } from "../../nc/words.ts";
import type { Statement } from "../../nc/statement.ts";
import { readRows } from "../job/contour-rows.ts";
import { newRow, type ContourRow, type SetJob } from "../job/job.ts";
import { jobFor } from "../job/requested-job.ts";
import { boxAroundContour } from "../job/requested-shape.ts";
import { frontOf, surfacesOf, type StockSurface } from "../job/stock-surface.ts";
import type { NamedUndercut, UndercutPlace } from "../job/undercut-name.ts";
import type { ToolFit } from "../tools/which-tool.ts";
import { INTENDED_CUT } from "../state/intended-cuts.ts";
import { positionAsTyped } from "../values/typed-value.ts";

/** A shoulder of the stock: a cylinder whose rear end meets a face. */
export interface Shoulder {
  readonly surface: StockSurface;
  /** Position of the face. */
  readonly z: number;
}

/** A nose radius may stand between cylinder and face, mm. */
const FILLET = 3;
/** Differences within one position, mm. */
const SAME_PLACE = 0.01;

/** The shoulders of a stock outside or in its bores, from the front to the rear. */
export function shouldersOf(stock: readonly Ring[], site: "outside" | "inside"): readonly Shoulder[] {
  const faces = surfacesOf(stock, "face");
  return surfacesOf(stock, site).flatMap((surface): Shoulder[] => {
    const { to } = surface;
    const meets = faces.find(({ from, to: inner }) => {
      // Outside the face rises from the cylinder, in a bore it falls from it.
      const near = site === "outside" ? inner.r - to.r : to.r - from.r;
      return near > -SAME_PLACE && near <= FILLET && to.z - from.z > -SAME_PLACE && to.z - from.z <= FILLET;
    });
    return meets ? [{ surface, z: meets.from.z }] : [];
  });
}

/** Cylinder in front of the undercut and face above it that are cut with it, mm. */
const BESIDE = 1;
/** Clearance of the start point, mm. */
const CLEARANCE = 2;
/** The same above an undercut that is roughed: its passes begin there. */
const ROUGHED = 0.5;
/** Finishing, and roughing before it; deeper undercuts are roughed, mm on the radius. */
const [FINISH, BOTH] = ["2", "0"];
const DEEPEST_FINISH = 0.6;
const INFEED = "1";

/** The longitudinal cycle for a contour of a subprogram. */
const cycle = catalogue.find(({ group, contour }) => group === "longitudinal" && contour === "free");

/** The rows of a contour that only cuts an undercut: a piece of its cylinder, the undercut, a piece of its face. */
export function undercutRows({ udc }: NamedUndercut, place: UndercutPlace, z: number): readonly ContourRow[] | null {
  if (!udc) return null;
  const shape = undercutShape({ kind: "undercut", ...udc }, place.diameter, place.isInside);
  if (!("vertices" in shape)) return null;
  const [first, last] = [shape.vertices[0], shape.vertices.at(-1)];
  const [along, up] = [(first?.u ?? 0) + BESIDE, Math.max(0, last?.v ?? 0) + BESIDE];
  const x = (d: number) => positionAsTyped(rounded(d));
  const top = place.diameter + 2 * (place.isInside ? -up : up);
  if (top < 0) return null;
  const words = Object.fromEntries(Object.entries(udc.words).map(([word, n]) => [word, String(n)]));
  return [
    newRow("e1", { x: x(place.diameter), z: positionAsTyped(rounded(z + along)) }),
    newRow("e2", { z: positionAsTyped(rounded(z)) }),
    newRow("e3", { kind: "UDC", form: udc.form, words }),
    newRow("e4", { x: x(top) }),
  ];
}

const pointOf = (d: number, z: number) => at(axial(z), toRadius(diameter(d)));

/**
 * The operation that cuts an undercut where the contour stands already: the longitudinal contour cycle on the cylinder
 * in front of it, the undercut and the face above it; finishing, for a deep one after roughing. Null where UDC has no
 * such form or the undercut does not fit.
 */
export function undercutJob(
  named: NamedUndercut,
  { place, z, stock }: { readonly place: UndercutPlace; readonly z: number; readonly stock: readonly Ring[] },
): SetJob | null {
  const rows = undercutRows(named, place, z);
  if (!cycle || !rows || !named.udc) return null;
  const [front, , , up] = rows;
  const [d, begin, top] = [place.diameter, Number(front?.z), Number(up?.x)];
  const elements: ContourElement[] = [
    { kind: "line", to: pointOf(d, begin) },
    { kind: "line", to: pointOf(d, z) },
    { kind: "undercut", ...named.udc },
    { kind: "line", to: pointOf(top, z) },
  ];
  const contour = contourFrom(elements);
  if (contour.issues.some(({ severity }) => severity === "error")) return null;
  const site = place.isInside ? "inside" : "outside";
  const wanted = {
    site,
    shape: "free",
    angle: 0,
    pitch: 1,
    contour: contour.segments,
    allowance: 0,
    ...boxAroundContour(contour.segments, site),
  } as const;
  const made = jobFor(cycle, wanted, stock.length > 0 ? stock : null);
  const out = place.isInside ? -1 : 1;
  const depth = Math.max(...contour.segments.map(({ to }) => (toRadius(place.diameter) - to.r) * out));
  const values = made.drafts[cycle.number] ?? {};
  return {
    ...made,
    contour: rows,
    start: startBeside(place, { z, begin, stock, clear: depth > DEEPEST_FINISH ? ROUGHED : CLEARANCE }),
    drafts: {
      [cycle.number]:
        depth > DEEPEST_FINISH
          ? { ...values, Q215: BOTH, Q463: INFEED, Q483: "0.2", Q484: "0.1" }
          : { ...values, Q215: FINISH, Q483: "0", Q484: "0" },
    },
  };
}

/** The tip clear of all material in front of the shoulder: above it outside, in front of the bore inside. */
function startBeside(
  { diameter: d, isInside }: UndercutPlace,
  {
    z,
    begin,
    stock,
    clear,
  }: { readonly z: number; readonly begin: number; readonly stock: readonly Ring[]; readonly clear: number },
): SetJob["start"] {
  const ahead = stock.flat().flatMap((p) => (p.z > z + SAME_PLACE ? [p.r] : []));
  const own = toRadius(d);
  const r = isInside ? Math.min(own, ...ahead) - clear : Math.max(own, ...ahead) + clear;
  const front = isInside && stock.length > 0 ? Math.max(begin, frontOf(stock)) : begin;
  return {
    x: positionAsTyped(rounded(toDiameter(radius(Math.max(0, r))))),
    z: positionAsTyped(rounded(front + CLEARANCE)),
  };
}

/** The corner of a shoulder. */
export const placeOf = ({ surface: { from, site } }: Shoulder): UndercutPlace => ({
  diameter: diameter(rounded(toDiameter(from.r))),
  isInside: site === "inside",
});

/** Feed along an undercut, mm/rev. */
const FEED = 0.1;

function pathBlock(segment: Segment, words: Partial<Words>): Statement {
  const axes: AxisWord[] = [
    { axis: "X", value: rounded(toDiameter(segment.to.r)), incremental: false },
    { axis: "Z", value: rounded(segment.to.z), incremental: false },
  ];
  if (segment.kind === "line") return { kind: "path", path: "L", words: { ...noWords, axes, ...words } };
  const size = rounded(Math.hypot(segment.from.z - segment.centre.z, segment.from.r - segment.centre.r));
  return { kind: "path", path: "CR", words: { ...noWords, axes, radius: size, turn: segment.turn, ...words } };
}

/** A section of a contour that path blocks cut. */
export interface CompensatedPath {
  /** In cutting direction: along the cylinder, then up its face outside, down inside. */
  readonly segments: readonly Segment[];
  readonly start: SetJob["start"];
  /** What it is, for the comment that marks an intended cut. */
  readonly name: string;
  /** Feed, mm/rev; absent: the usual one. */
  readonly feed?: number;
}

/** A section as path blocks with tip radius compensation, from its start point and back. Empty for no section. */
export function compensatedCut({ segments, start, name, feed = FEED }: CompensatedPath): readonly Statement[] {
  const [first, last] = [segments[0], segments.at(-1)];
  if (!first || !last) return [];
  const inside = last.to.r < first.from.r;
  const to = (p: Pt): Segment => part.line(p, p);
  const above = (p: Pt, z: number) => at(axial(p.z + z), radius(Math.max(0, p.r + (inside ? -CLEARANCE : CLEARANCE))));
  const away = above(last.to, CLEARANCE);
  const back = at(axial(Number(start.z)), toRadius(diameter(Number(start.x))));
  return [
    ...(inside ? [pathBlock(to(at(back.z, above(first.from, 0).r)), { feed: "max" })] : []),
    pathBlock(to(above(first.from, 0)), { feed: "max" }),
    { kind: "comment", text: `${INTENDED_CUT} ${name.replace("×", "x")}` },
    pathBlock(to(first.from), { compensation: inside ? "RL" : "RR", feed: { value: feed, unit: "F" } }),
    ...segments.map((s) => pathBlock(s, {})),
    pathBlock(to(away), { compensation: "R0" }),
    ...(inside
      ? [pathBlock(to(at(back.z, away.r)), { feed: "max" })]
      : [pathBlock(to(at(away.z, back.r)), { feed: "max" })]),
  ];
}

/**
 * Form F as path blocks with tip radius compensation: its recess reaches behind the face, where the passes of a
 * longitudinal cycle do not go. Null for the other forms, which `undercutJob` cuts.
 */
export function undercutCut(
  { name, udc }: NamedUndercut,
  { start, contour }: SetJob,
): { readonly start: SetJob["start"]; readonly cut: readonly Statement[] } | null {
  const { segments } = readRows(contour).contour;
  if (udc?.form !== "F" || segments.length === 0) return null;
  return { start, cut: compensatedCut({ segments, start, name }) };
}

/**
 * The tools as tried on an undercut: those whose nose is no larger than its radius make it whole, finishing tools first.
 * Tip radius compensation (form F) needs a nose that is smaller than the arc.
 */
export function reachingFirst(fits: readonly ToolFit[], { udc }: NamedUndercut): readonly ToolFit[] {
  const most = (udc?.words.R ?? 0) + (udc?.form === "F" ? -SAME_PLACE : SAME_PLACE);
  const small = (tool: Tool) => noseRadius(tool) <= most;
  const rank = ({ makesContour, tool }: ToolFit) => (makesContour ? 0 : 2) + (tool.TYPE === "FINISH" ? 0 : 1);
  return fits
    .map((fit) => ({ ...fit, makesContour: fit.makesContour && small(fit.tool) }))
    .sort((a, b) => rank(a) - rank(b));
}

import type { Dimension, Outline } from "../../cycles/define.ts";
import type { Params, Topic } from "../../cycles/params.ts";
import type { Plan } from "../../kernel/plan/plan.ts";
import { STEP, toDiameter } from "../../kernel/units.ts";
import { toScreen, type Place, type Size } from "../camera.ts";
import { arrange, type Sheet } from "../dimensions/arrange.ts";
import * as choices from "./choices.ts";
import { numberOf, startPoint, type Context } from "./context.ts";
import { detail, isSmall } from "./detail.ts";
import type { Lettering } from "./dimensions.ts";
import { outward, type HelpFrame } from "./frame.ts";
import { labelsOverlap, runsThrough, SIZE, textBox, type LabelBox } from "../dimensions/labels.ts";
import { FIRST, layoutOf } from "./layout.ts";
import { letteringOf, positionText, type Numbers, type HelpWords } from "./lettering.ts";
import { dense, polygon, polyline, segmentPath, type Mark } from "./marks.ts";
import { passesOf } from "./passes.ts";
import * as plunges from "./plunges.ts";
import * as explain from "./process.ts";
import { blankOver, drawnLine, sectionOf } from "./section.ts";
import { caption, filled, stroke, type Candidate, type HelpItem, type PlacedHelp } from "./stroke.ts";
import { columnsFor, hasTiles, TILE_ROW, tiles } from "./tiles.ts";
import * as threads from "./threads.ts";
import { partnerOf, qOf, shownAs } from "./topics.ts";
import { SAME } from "../../kernel/tolerance.ts";

/** What to draw, and how large. */
export interface HelpRequest {
  readonly params: Params;
  readonly values: Numbers;
  /**
   * The values that somebody typed; the others only serve the drawing, and show their Q alone. All values when left
   * out.
   */
  readonly typed?: Numbers;
  /** The contour is not the operator's own: its numbers are not written. */
  readonly isBorrowed?: boolean;
  readonly outline: Outline;
  /** What the cycle plans for a point there. */
  readonly plan: Plan;
  /** The Q of the current prompt; null draws everything grey. */
  readonly active: string | null;
  /** CSS pixels. */
  readonly size: Size;
  readonly speech: HelpWords;
}

/** The display list of a help picture, from back to front, and the boxes of all its texts. */
export interface HelpDrawing {
  readonly size: Size;
  readonly marks: readonly Mark[];
  readonly labels: readonly LabelBox[];
}

/** Topics whose dimension is drawn grey while another parameter is active. */
const ALWAYS: readonly Topic[] = [
  "outline",
  "clearance",
  "infeed",
  "limitDiameter",
  "limitZ",
  "allowance",
  "oversizeDiameter",
  "oversizeZ",
];
/** Cost of crossing the line of another dimension. */
const CROSSING = 1.5;
/** A quiet dimension with a higher cost than this is left out. */
const QUIET_MOST = 30;
/** The topics of `ALWAYS` that stay when the diagrams of a choice need room. */
const CALM: readonly Topic[] = ALWAYS.slice(0, 6);

const explanations: Readonly<Record<Topic, (c: Context, l: Lettering) => explain.Explanation>> = {
  outline: (c, l) => explain.outlined(c, l, null),
  element: (c, l) => explain.outlined(c, l, partnerOf(c.params, l.q)),
  clearance: explain.clearance,
  infeed: explain.infeed,
  allowance: explain.allowance,
  oversizeDiameter: (c, l) => explain.oversize(c, l, "diameter"),
  oversizeZ: (c, l) => explain.oversize(c, l, "z"),
  roughingFeed: explain.roughingFeed,
  finishingFeed: explain.finishingFeed,
  plungingFeed: explain.plungingFeed,
  limitDiameter: (c, l) => explain.limit(c, l, "diameter"),
  limitZ: (c, l) => explain.limit(c, l, "z"),
  offsetWidth: explain.offsetWidth,
  depthCompensation: explain.depthCompensation,
  operation: choices.operation,
  reverse: choices.reverse,
  smoothing: choices.smoothing,
  plunging: choices.plunging,
  limits: choices.limits,
  direction: choices.direction,
  cuttingLines: choices.cuttingLines,
  threadPosition: threads.alongThread,
  threadOrientation: threads.alongThread,
  taperForm: threads.alongThread,
  infeedType: threads.alongThread,
  pitch: (c, l) => explain.outlined(c, l, null),
  threadDepth: (c, l) => explain.outlined(c, l, null),
  runIn: (c, l) => explain.outlined(c, l, null),
  startingAngle: threads.startingAngle,
  threadStarts: threads.starts,
  airCuts: threads.airCuts,
  depthLimit: plunges.depthLimit,
  overlap: plunges.sideStep,
  solidFeed: plunges.solidFeed,
  retraction: plunges.retraction,
  dwell: plunges.dwell,
  comb: plunges.comb,
};

function contextOf(request: HelpRequest, size: Size, indent: number): Context {
  const { params, values, typed = values, outline, plan, active, speech } = request;
  const frame: HelpFrame = { ...outline.frame, sunk: outline.sunk };
  const line = drawnLine(outline.contour);
  const { blank, corner } = blankOver(frame, line);
  const start = startPoint(frame, corner, Math.min(numberOf(values, qOf(params, "clearance")), 1e4));
  const span = Math.max(STEP, ...line.map((p) => Math.hypot(p.z - corner.z, p.r - corner.r)));
  const near = Math.hypot(start.z - corner.z, start.r - corner.r) < span * 0.4 ? [start] : [];
  const allowed = numberOf(values, qOf(params, "allowance"));
  const outer = allowed > 0 && allowed < span * 0.4 ? plan.area : [];
  const along = frame.transverse ? 2 : 1;
  const layout = layoutOf(frame, line, [...line, ...blank, ...near, ...outer], outline.dimensions, size, {
    top: along,
    right: 0,
    indent,
  });
  const passes = passesOf(frame, plan);
  const top = passes[0] ? passes[0].level + plan.infeed : outward(frame, corner);
  const square = (q: string) => {
    const d = outline.dimensions.find((o) => o.q === q && o.form === "leader");
    const s = d?.form === "leader" ? explain.nearestElement(outline.contour, d.at)?.element : undefined;
    return s?.kind === "line" && Math.abs(Math.abs(s.to.z - s.from.z) - Math.abs(s.to.r - s.from.r)) < SAME;
  };
  return {
    params,
    values,
    outline,
    plan,
    frame,
    layout,
    passes,
    step: plan.infeed > 0 ? plan.infeed : plan.maxInfeed,
    top,
    section: sectionOf(frame, line, layout.reach),
    letter: (q) => ({
      q,
      active: q === active,
      text: typed[q] === undefined ? q : letteringOf(params, q, typed, speech, square(q)),
    }),
    plain: (kind, at) => ({
      q: "",
      active: false,
      text: positionText(kind, kind === "axial" ? at.z : toDiameter(at.r), speech),
    }),
  };
}

/** The diagrams of a choice go below the drawing or to its left, whichever leaves the drawing larger. */
function contextBesideTiles(request: HelpRequest, count: number): { readonly c: Context; readonly column: number } {
  const { width, height } = request.size;
  const row = contextOf(request, { width, height: Math.max(60, height - TILE_ROW) }, 0);
  const beside = columnsFor(count, height);
  if (beside.width > width * 0.45) return { c: row, column: 0 };
  const column = contextOf(request, request.size, beside.width);
  return column.layout.camera.scale > row.layout.camera.scale
    ? { c: column, column: beside.width }
    : { c: row, column: 0 };
}

/** Part, contour, blank and axis: these are always drawn. */
function ground(c: Context): Mark[] {
  const none = { q: null, active: false };
  const at = (p: Parameters<typeof toScreen>[1]) => toScreen(c.layout.camera, p);
  const { section, layout } = c;
  const [left, right] = [
    Math.max(2, layout.box.x - 8),
    Math.min(layout.size.width - 2, layout.box.x + layout.box.width + 12),
  ];
  return [
    filled(none, "part", polygon(section.part.map(at))),
    ...section.edges.map(([a, b]) => stroke(none, "edge", polyline([at(a), at(b)]))),
    ...section.breaks.map(([a, b]) => stroke(none, "break", polyline([at(a), at(b)]))),
    stroke(none, "area", polyline(section.blank.map(at))),
    stroke(
      none,
      "axis",
      polyline([
        { x: left, y: layout.axisY },
        { x: right, y: layout.axisY },
      ]),
    ),
  ];
}

/** Points on the drawing's strong lines and below the axis, a few pixels apart, that texts should avoid. */
function strongPlaces(c: Context): Place[] {
  const at = (p: Parameters<typeof toScreen>[1]) => toScreen(c.layout.camera, p);
  const axis = dense([
    { x: c.layout.box.x, y: c.layout.axisY },
    { x: c.layout.box.x + c.layout.box.width, y: c.layout.axisY },
  ]);
  const edges = c.section.edges.flatMap(([a, b]) => dense([at(a), at(b)]));
  const below: Place[] = [];
  for (let y = c.layout.axisY; y < c.layout.size.height; y += 6)
    for (let x = 0; x < c.layout.size.width; x += 6) below.push({ x, y });
  return [...dense(c.section.line.map(at)), ...dense(c.section.blank.map(at)), ...edges, ...axis, ...below];
}

/**
 * The order in which dimensions of the outline are placed, 0 … 3: short lengths go nearest to the part, leaders come
 * last because they fit almost anywhere.
 */
function placementOrder(d: Dimension): number {
  switch (d.form) {
    case "diameter":
      return 1;
    case "z":
      return Math.abs(d.to.z - d.from.z) / (Math.abs(d.to.z - d.from.z) + 100);
    case "leader":
      return 3;
    case "r":
    case "along":
    case "angle":
      return 2;
  }
}

/**
 * Quiet dimensions keep their places; the active one is placed first if it would find no place otherwise, and is always
 * shown.
 */
function arranged(items: readonly HelpItem[], active: string | null, sheet: Sheet): PlacedHelp[] {
  const placed = arrange(items, sheet);
  const own = items.find((i) => i.q === active);
  if (!own || placed.some((p) => p.q === active)) return placed;
  const others = items.filter((i) => i !== own);
  const first = arrange([own, ...others], sheet);
  if (first.some((p) => p.q === active)) return first;
  const last = arrange([{ ...own, needed: true, moved: textMoved }], sheet).map((p) => ({ ...p, item: own }))[0];
  return last ? [last, ...arrange(others, { ...sheet, kept: [...sheet.kept, last.label] })] : first;
}

/** A dimension with its text in another box; its lines stay. */
function textMoved(c: Candidate, label: LabelBox): Candidate {
  const [dx, dy] = [label.x - c.label.x, label.y - c.label.y];
  const moved = (m: Mark): Mark => (m.kind === "text" ? { ...m, place: { x: m.place.x + dx, y: m.place.y + dy } } : m);
  return { ...c, label, marks: () => c.marks().map(moved) };
}

/** Moves the dimensions that the lens covers; all others stay. */
function arrangedAroundLens(
  items: readonly HelpItem[],
  placed: readonly PlacedHelp[],
  lens: readonly LabelBox[],
  sheet: Sheet,
): PlacedHelp[] {
  const isCovered = (p: PlacedHelp) =>
    lens.some((l) => labelsOverlap(p.label, l) || p.lines.some((line) => runsThrough(line, l)));
  const standing = placed.filter((p) => !isCovered(p));
  const moved = items.filter((i) => placed.some((p) => p.item === i) && !standing.some((p) => p.item === i));
  return arrange(moved, { ...sheet, kept: [...sheet.kept, ...lens] }, standing);
}

/** Draws the contour of a cycle with its dimensions, the one of the active parameter strong. */
export function helpDrawing(request: HelpRequest): HelpDrawing {
  const { params, active, size, values, typed = values, isBorrowed = false, speech } = request;
  const topic = active === null ? null : shownAs(params, active);
  const choice = active === null ? undefined : params[active]?.choices;
  const strip = topic !== null && choice !== undefined && hasTiles(topic);
  const { c, column } = strip
    ? contextBesideTiles(request, choice.length)
    : { c: contextOf(request, size, 0), column: 0 };
  const shown = Object.keys(params).filter((q) => q === active || (strip ? CALM : ALWAYS).includes(shownAs(params, q)));
  const turn = new Map(request.outline.dimensions.map((d) => [d.q, placementOrder(d)] as const));
  const rank = (q: string) => ALWAYS.indexOf(shownAs(params, q)) * 4 + (turn.get(q) ?? 2);
  const order = [...shown].sort((a, b) => rank(a) - rank(b));
  const parts = order.map((q) => ({ q, ...explanations[shownAs(params, q)](c, c.letter(q)) }));
  const strong = strongPlaces(c);
  const chosen = active === null || typed[active] === undefined ? null : numberOf(typed, active);
  const row = strip && active !== null ? tiles(c.frame, topic, choice, { q: active, chosen }, size, column > 0) : [];
  const kept: LabelBox[] = column > 0 ? [{ x: 0, y: 0, width: column, height: size.height }] : [];
  const { width, height } = c.layout.size,
    room = { x: column, y: 0, width: width - column, height };
  const sheet = { width, height, room, avoid: strong, kept, crossing: CROSSING };
  const small = active === null ? null : smallFeature(c, active);
  const own = parts.flatMap((p) => (p.item && !(small && p.q === active) ? [p.item] : []));
  const items = [...own, ...(isBorrowed ? [] : explain.plainDimensions(c))].map((i): HelpItem =>
    i.q === active ? i : { ...i, most: i.most ?? QUIET_MOST },
  );
  let placed: readonly PlacedHelp[] = arranged(items, active, sheet);
  const lens = small && active ? detail(c, c.letter(active), small, placed, kept) : null;
  if (lens) placed = arrangedAroundLens(items, placed, lens.boxes, sheet);
  const back = (strong: boolean) => parts.filter((p) => (p.q === active) === strong).flatMap((p) => p.under);
  const marks: Mark[] = [
    ...ground(c),
    ...back(false),
    stroke({ q: null, active: false }, "contour", segmentPath(c.outline.contour, c.layout.camera)),
    ...back(true),
    ...placed.filter((p) => p.q !== active).flatMap((p) => p.marks()),
    ...placed.filter((p) => p.q === active).flatMap((p) => p.marks()),
    ...(lens?.marks ?? []),
    ...row,
  ];
  const labels = [...placed.map((p) => p.label), ...(lens ? [lens.label] : [])];
  const scaled = marks.some((m) => m.kind === "text" && m.active && m.underlined);
  const note = textBox({ x: 0, y: 0 }, speech.notToScale, 0, SIZE.caption);
  const corner = [
    [1, 1],
    [1, 0],
    [0, 1],
    [0, 0],
  ]
    .map(([right, low]) => ({
      x: right ? size.width - note.width / 2 - 2 : note.width / 2 + 2,
      y: low ? c.layout.size.height - FIRST / 2 - 1 : FIRST / 2 + 1,
    }))
    .find((p) => !labels.some((b) => labelsOverlap(b, textBox(p, speech.notToScale, 0, SIZE.caption))));
  const noted = scaled && active !== null && corner;
  return {
    size,
    marks: noted ? [...marks, caption({ q: active, active: true }, corner, speech.notToScale)] : marks,
    labels: noted ? [...labels, textBox(corner, speech.notToScale, 0, SIZE.caption)] : labels,
  };
}

/** The element that the active parameter sizes, if it is too small to see. */
function smallFeature(c: Context, active: string): { at: Parameters<typeof toScreen>[1]; mm: number } | null {
  const partner = partnerOf(c.params, active);
  const d = c.outline.dimensions.find((o) => o.q === active) ?? c.outline.dimensions.find((o) => o.q === partner);
  if (d?.form !== "leader") return null;
  const isType = c.params[active]?.kind === "choice";
  const mm = numberOf(c.values, isType ? partner : active);
  const type = isType ? numberOf(c.values, active) : partner ? numberOf(c.values, partner) : 2;
  return type !== 0 && isSmall(c, mm) ? { at: explain.elementAt(c, d.at)?.at ?? d.at, mm } : null;
}

import { at, part, type Pt } from "../../kernel/geometry/point.ts";
import type { Box } from "../../kernel/geometry/segments.ts";
import { toDiameter } from "../../kernel/units.ts";
import type { ContourChoice, Drawing, DrawingNote, DrawnContour, DrawnPiece } from "./drawing.ts";
import { componentsOf, degreesOf, divided, graphOf, type Edge, type Graph } from "./graph.ts";
import { backPlacingOf, halfOf, placingOf, TOUCHING, type Half, type HalfCurve } from "./halves.ts";
import { outlineOf, type Outline, type BoundaryRun } from "./outline.ts";
import { connected, rowsThrough } from "./rows.ts";

/** Nearer to the axis than this, a line shows where it is, mm. */
const ON_AXIS = 0.01;
/** The origin is at an end of the part when it is nearer to it than this share of the length: faces have an allowance. */
const AT_END = 0.1;
/** Most pieces to choose from. */
const MOST_PIECES = 200;
/** Open gaps are named up to this width, mm, or this many times the tolerance. */
const NAMED = 1,
  NAMED_TIMES = 20;

/** Curves that can be part of a contour under a choice, as indexes of the drawing. */
export function usedCurves(drawing: Drawing, choice: ContourChoice): number[] {
  const without = new Set(choice.withoutLayers);
  return drawing.curves.flatMap(({ role, layer }, i) =>
    !without.has(layer) && role !== "centre" && (choice.thin || role === "outline") ? [i] : [],
  );
}

interface Piece {
  readonly edges: readonly Edge[];
  readonly sources: readonly number[];
  readonly box: Box;
  readonly length: number;
  readonly score: number;
  readonly nodes: ReadonlySet<number>;
}

const joinBoxes = (a: Box, b: Box): Box => ({
  left: Math.min(a.left, b.left),
  right: Math.max(a.right, b.right),
  low: Math.min(a.low, b.low),
  high: Math.max(a.high, b.high),
});

/** How far a piece is from the half of a turned part: less for frames, views from the end, dimensions above the part. */
function scoreOf(edges: readonly Edge[], box: Box, { below }: Half, nodes: readonly Pt[]): number {
  const tall = new Map<number, number>();
  for (const e of edges)
    if (below.has(e.source)) tall.set(e.source, Math.max(tall.get(e.source) ?? 0, part.boxOf(e.segment).high));
  // What crosses the axis reaches as far on its other side, or it is no turned part but a frame.
  const isUneven = [...tall].some(([source, high]) => Math.abs(high - (below.get(source) ?? 0)) > 0.01 * high + 0.01);
  const isEndView = edges.every(
    ({ segment: s }) => s.kind === "arc" && Math.abs(s.centre.r) < 0.01 && part.sweepOf(s) > 1.5,
  );
  const far = 1 - (0.5 * Math.max(0, box.low)) / Math.max(box.high, TOUCHING);
  const isAlone = nodes.length === 0;
  return (
    (box.right - box.left + 0.1 * (box.high - box.low)) *
    far *
    (isUneven ? 0.02 : 1) *
    (isEndView && !isAlone ? 0.05 : 1)
  );
}

function piecesOf(graph: Graph, half: Half): Piece[] {
  const pieces = componentsOf(graph).map((edges): Piece => {
    const drawn = edges.filter((e) => !e.isAxis),
      box = drawn.map((e) => part.boxOf(e.segment)).reduce(joinBoxes);
    return {
      edges,
      sources: [...new Set(drawn.map((e) => e.source))],
      box,
      length: drawn.reduce((sum, e) => sum + part.lengthOf(e.segment), 0),
      score: scoreOf(drawn, box, half, graph.nodes),
      nodes: new Set(drawn.flatMap((e) => [e.from, e.to])),
    };
  });
  return pieces.toSorted((a, b) => b.score - a.score).slice(0, MOST_PIECES);
}

/** Places of ends near a piece that do not meet, with the distance. */
function openGaps(graph: Graph, piece: Piece, gap: number): { readonly width: number; readonly at: Pt }[] {
  const degree = degreesOf(graph.nodes, graph.edges),
    reach = Math.max(NAMED, NAMED_TIMES * gap);
  const loose = degree.flatMap((d, n) => (d === 1 && (graph.nodes[n]?.r ?? 0) > TOUCHING ? [n] : []));
  const own = loose.filter((n) => piece.nodes.has(n));
  const found = own.flatMap((n) => {
    const p = graph.nodes[n];
    if (!p) return [];
    let best: { width: number; at: Pt } | null = null;
    for (const m of loose) {
      const q = graph.nodes[m];
      if (m === n || !q || (piece.nodes.has(m) && m < n)) continue;
      const width = part.apart(p, q);
      if (width <= reach && (!best || width < best.width)) best = { width, at: part.scaled(part.sum(p, q), 1 / 2) };
    }
    return best ? [best] : [];
  });
  return found.slice(0, 20);
}

const none = (notes: readonly DrawingNote[]): DrawnContour => ({
  rows: [],
  segments: [],
  pieces: [],
  hasSides: false,
  notes,
});

/** What was joined, is open or was left out along a run, as notes. */
function notesOf(graph: Graph, piece: Piece, outline: Outline, run: BoundaryRun, choice: ContourChoice): DrawingNote[] {
  const back = backPlacingOf(choice),
    spot = (p: Pt) => ({ x: toDiameter(p.r), z: p.z });
  const onRun = new Set(run.nodes),
    inside = piece.sources.filter((source) => !outline.around.has(source)).length;
  return [
    ...openGaps(graph, piece, choice.gap).map(({ width, at }): DrawingNote => ({
      code: "gapOpen",
      severity: "warning",
      values: { width, ...spot(at) },
      at: back(at),
    })),
    ...graph.joins
      .filter((j) => onRun.has(j.node))
      .map((j): DrawingNote => ({
        code: "gapJoined",
        severity: "info",
        values: { width: j.width, ...spot(j.at) },
        at: back(j.at),
      })),
    ...(inside > 0 ? [{ code: "insideLines", severity: "info", values: { count: inside } } as const] : []),
    ...(outline.rearFace !== null && run === outline.outside
      ? [{ code: "rearFace", severity: "info", values: { z: outline.rearFace } } as const]
      : []),
  ];
}

interface Prepared {
  readonly half: Half;
  readonly curves: readonly HalfCurve[];
}
/** Halves that were looked at last: another side, piece, gap or direction needs no new one. */
const recent = new WeakMap<Drawing, Map<string, Prepared>>();
const MOST_RECENT = 4;

/** The half of a choice, divided at its crossings. */
function prepared(drawing: Drawing, used: readonly number[], choice: ContourChoice): Prepared {
  const { axis, axisAt, zero, mirrored, half, diameters, thin, withoutLayers } = choice,
    key = JSON.stringify([axis, axisAt, zero, mirrored, half, diameters, thin, withoutLayers]),
    known = recent.get(drawing) ?? new Map<string, Prepared>();
  let found = known.get(key);
  if (!found) {
    const made = halfOf(drawing.curves, used, choice);
    found = { half: made, curves: divided(made.curves) };
    const [oldest] = known.keys();
    if (known.size >= MOST_RECENT && oldest !== undefined) known.delete(oldest);
    recent.set(drawing, known.set(key, found));
  }
  return found;
}

/**
 * Whether the drawing shows where the axis is: by what lies on it or beyond it, or by its origin at an end of the part.
 * Otherwise its place is no more than a proposal.
 */
function isAxisDrawn(drawing: Drawing, { curves, axisLines, otherSide, below }: Half, choice: ContourChoice): boolean {
  const put = placingOf(choice),
    isOn = (p: Pt) => Math.abs(p.r) <= ON_AXIS,
    origin = put(at(0, 0)),
    { left, right } = curves.map(({ segment }) => part.boxOf(segment)).reduce(joinBoxes);
  return (
    (isOn(origin) &&
      [origin.z - left, right - origin.z].some((off) => off >= -ON_AXIS && off <= AT_END * (right - left))) ||
    axisLines + otherSide + below.size > 0 ||
    curves.some(({ segment }) => isOn(segment.from) || isOn(segment.to)) ||
    drawing.curves.some((c) => c.role === "centre" && isOn(put(c.segment.from)) && isOn(put(c.segment.to)))
  );
}

/** The contour of a turned part as chosen from a drawing, and the pieces that could be chosen instead. Never throws. */
export function drawnContour(drawing: Drawing, choice: ContourChoice): DrawnContour {
  const used = usedCurves(drawing, choice);
  if (used.length === 0) return none([{ code: "noContour", severity: "error", values: {} }]);
  const { half, curves } = prepared(drawing, used, choice),
    hidden = drawing.curves.filter((c) => c.role === "hidden" || c.role === "thin").length;
  const general: DrawingNote[] = [];
  if (half.axisLines > 0) general.push({ code: "axisLines", severity: "info", values: { count: half.axisLines } });
  if (half.otherSide > 0) general.push({ code: "otherHalf", severity: "info", values: { count: half.otherSide } });
  if (!choice.thin && hidden > 0) general.push({ code: "notOutline", severity: "info", values: { count: hidden } });
  if (half.curves.length === 0) {
    const code = half.axisLines > 0 && half.otherSide === 0 ? "onlyAxis" : "noContour";
    return none([{ code, severity: "error", values: {} }, ...general]);
  }
  const graph = graphOf(curves, choice.gap),
    pieces = piecesOf(graph, half),
    piece = pieces[choice.piece] ?? pieces[0],
    outline = piece && outlineOf(piece.edges, graph.nodes);
  if (!piece || !outline) return none([{ code: "noContour", severity: "error", values: {} }, ...general]);
  if (!isAxisDrawn(drawing, half, choice))
    general.push({ code: "axisUnmarked", severity: "warning", values: { x: toDiameter(at(0, piece.box.low).r) } });
  if (pieces.length > 1) general.push({ code: "otherPieces", severity: "info", values: { count: pieces.length - 1 } });
  const run = choice.side === "bore" && outline.bore ? outline.bore : outline.outside,
    made = connected(run.segments),
    segments = choice.reversed ? made.map(part.reversed).toReversed() : made;
  return {
    rows: rowsThrough(segments),
    segments,
    pieces: pieces.map(
      // Connected lines with as many edges as nodes have a loop.
      ({ sources, edges, length, nodes }): DrawnPiece => ({
        curves: sources,
        closed: edges.length >= nodes.size,
        length,
      }),
    ),
    hasSides: outline.bore !== null,
    notes: [...notesOf(graph, piece, outline, run, choice), ...general],
  };
}

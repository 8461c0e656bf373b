import type { Clamped } from "../../kernel/area/clamping.ts";
import { at, part, type Pt, type Ring, type Segment } from "../../kernel/geometry/point.ts";
import { boundsOf, joined, mirrored } from "../bounds.ts";
import type { Place } from "../camera.ts";
import type { DimensionRequest } from "../dimensions/placed-dimensions.ts";
import { circleAt, lineThrough, onPaperGrid } from "../dimensions/strokes.ts";
import { unstatedClamping } from "../unstated-clamping.ts";
import { mirroredAt } from "./body.ts";
import { clampingNear } from "./clamping-on-paper.ts";
import type { TurnedContour } from "./found-features.ts";
import type { PrintShape } from "./paper.ts";
import type { DrawnContent, PaperScene } from "./part-drawing.ts";
import { ONE_PLACE, setterSizes, type SetUpWords } from "./print-sizes.ts";

/** A set-up to draw. Part space, mm. */
export interface DrawnSetUp {
  readonly blank: readonly Ring[];
  /** The part at the end. */
  readonly finished: readonly Ring[];
  readonly contours: readonly TurnedContour[];
  /** The clamping; null or absent if not stated. */
  readonly clamping?: Clamped | null;
  /** Measurements on the part; none if absent. */
  readonly measured?: readonly DimensionRequest[];
}

/** Radius of the sign at the workpiece zero, mm on paper. */
const ZERO = 1.6;
/** Arcs stay this near to their circle, mm on paper. */
const CHORD_ON_PAPER = 0.05;

/** The sign of the workpiece zero: a circle, two opposite quarters of it filled. */
function zeroSign({ x, y }: Place): readonly PrintShape[] {
  const quarter = (fx: number, fy: number) =>
    `M${onPaperGrid(x)} ${onPaperGrid(y)}L${onPaperGrid(x + fx * ZERO)} ${onPaperGrid(y)}A${ZERO} ${ZERO} 0 0 ${fx * fy > 0 ? 1 : 0} ${onPaperGrid(x)} ${onPaperGrid(y + fy * ZERO)}Z`;
  return [
    { role: "zero", d: circleAt({ x, y }, ZERO) },
    { role: "zeroFilled", d: quarter(1, -1) + quarter(-1, 1) },
  ];
}

const bothHalves = (line: readonly Pt[], { onPaper }: PaperScene) =>
  lineThrough(line.map(onPaper)) + lineThrough(line.map((p) => onPaper(mirroredAt(p))));
const closed = (rings: readonly Ring[], { onPaper }: PaperScene) =>
  rings
    .filter((ring) => ring.length > 2)
    .map((ring) => `${lineThrough(ring.map(onPaper))}Z${lineThrough(ring.map((p) => onPaper(mirroredAt(p))))}Z`)
    .join("");

/**
 * A set-up for the person who clamps it: blank, chuck, finished part in section and zero; diameters in a column on the
 * right and positions from the zero in a row below, without deviations and notes. Null if there is nothing to draw.
 */
export function forSetter(work: DrawnSetUp, words: SetUpWords): DrawnContent | null {
  const material = boundsOf(work.blank.flat());
  const outline = boundsOf(work.contours.flatMap(({ segments }) => segments.flatMap(({ from, to }) => [from, to])));
  const body = joined(material, joined(boundsOf(work.finished.flat()), outline));
  if (!body) return null;
  const held = material && !work.clamping ? unstatedClamping(work.blank, material) : null;
  const clamping = material && work.clamping ? clampingNear(work.clamping, material) : { areas: [], edges: [] };
  const holding = boundsOf([...clamping.areas.flat(), ...(held?.hatch.flat() ?? [])]);
  const sizes = setterSizes(work.contours, work.finished, work.blank, words);
  const contourLine = (segments: readonly Segment[], scene: PaperScene) => {
    const line = part.flattenedChain(segments, CHORD_ON_PAPER / scene.scale);
    return line.length < 2 ? "" : bothHalves(line, scene);
  };
  return {
    body: work.finished,
    bounds: mirrored(joined(joined(body, holding), boundsOf([at(0, 0)])) ?? body),
    form: "coordinates",
    view: {
      broken: null,
      section: "whole",
      // Simulated threads have an edge at each tooth: only shoulders are drawn across the bore.
      hasEdge: ({ z }) => sizes.positions.some(({ from: p }) => Math.abs(p.z - z) < ONE_PLACE),
      threads: [],
    },
    behind: (scene) => [
      { role: "chuck", d: closed(clamping.areas, scene) },
      { role: "chuckEdge", d: clamping.edges.map((edge) => bothHalves(edge, scene)).join("") },
      { role: "edge", d: held ? [held.plane, ...held.hatch].map((line) => bothHalves(line, scene)).join("") : "" },
    ],
    around: (scene) => [
      { role: "blank", d: closed(work.blank, scene) },
      {
        role: "edge",
        d: work.finished.length === 0 ? work.contours.map(({ segments }) => contourLine(segments, scene)).join("") : "",
      },
    ],
    front: ({ onPaper }) => zeroSign(onPaper(at(0, 0))),
    across: () => ({ right: sizes.across, left: [], noted: [] }),
    below: sizes.positions,
    above: material
      ? [
          {
            size: { text: words.length(material.right - material.left) },
            from: at(material.right, material.high),
            extent: Infinity,
          },
        ]
      : [],
    zero: { below: at(0, 0), above: material ? at(material.left, material.high) : at(0, 0) },
    ...(work.measured && { measured: work.measured }),
  };
}

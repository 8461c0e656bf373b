import { part, type Segment } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { pathOf } from "../../kernel/time/time.ts";
import type { PathLoad } from "../../sim/load/along.ts";
import type { RoughStretch } from "../../sim/load/roughness.ts";
import { segmentData } from "../path.ts";
import { classAt, scaleOf, classTone, type Scale } from "./scale.ts";
import { hasLoad, type AlongPath } from "./values.ts";

/** All stretches of one class as one path in part space. */
export interface LoadLine {
  /** Tone of the scale; null where no value is known. */
  readonly tone: number | null;
  /** The spindle is at its limit. */
  readonly limited: boolean;
  readonly segments: readonly Segment[];
  readonly d: string;
}

/** A scale and its paths: one per class, and one more per class for stretches at a limit, however long the program. */
export interface LoadDrawing {
  readonly scale: Scale;
  readonly lines: readonly LoadLine[];
}

interface Drawn {
  readonly tone: number | null;
  readonly limited: boolean;
  readonly segments: Segment[];
}

/** The paths of segments, the strongest last, so that it lies on top. */
function linesOf(
  items: Iterable<{ readonly tone: number | null; readonly limited: boolean; readonly segments: readonly Segment[] }>,
): LoadLine[] {
  const drawn = new Map<string, Drawn>();
  for (const { tone, limited, segments } of items) {
    const key = `${tone} ${limited}`,
      line = drawn.get(key) ?? { tone, limited, segments: [] };
    drawn.set(key, line);
    for (const segment of segments) line.segments.push(segment);
  }
  const order = (line: Drawn) => (line.tone ?? -1) + (line.limited ? 0.5 : 0);
  return [...drawn.values()]
    .sort((a, b) => order(a) - order(b))
    .map(({ tone, limited, segments }) => ({
      tone,
      limited,
      segments,
      d: segmentData(segments),
    }));
}

/** The part of a path between two fractions of its way. */
function between(path: Segment, from: number, to: number): Segment {
  const [a, b] = [part.pointOn(path, from), part.pointOn(path, to)];
  return path.kind === "line" ? { kind: "line", from: a, to: b } : { ...path, from: a, to: b };
}

/**
 * A value along the path of the shown moves. Depth, chip and feed start at zero, the cutting speed at its minimum.
 * `size`: one display unit.
 */
export function drawingAlong(
  load: PathLoad,
  of: AlongPath,
  steps: readonly Step[],
  shown: (step: number) => boolean,
  size = 1,
): LoadDrawing {
  const rows = Array.from({ length: load.count }, (_, row) => row).filter((row) => hasLoad(load, of, row));
  const value = (row: number) => load[of][row] ?? 0;
  const most = rows.reduce((high, row) => Math.max(high, value(row)), 0);
  const scale = scaleOf(of === "speed" ? rows.reduce((low, row) => Math.min(low, value(row)), most) : 0, most, size);
  const lines = linesOf(
    (function* () {
      for (const row of rows) {
        const index = load.step[row] ?? -1,
          step = steps[index];
        if (!step || !shown(index)) continue;
        const segments = [between(pathOf(step.from, step.move), load.from[row] ?? 0, load.to[row] ?? 1)];
        yield {
          tone: classTone(scale, classAt(scale, value(row))),
          limited: of === "speed" && load.limited[row] === 1,
          segments,
        };
      }
    })(),
  );
  return { scale, lines };
}

/**
 * The roughness of the finished surface; where the nose radius does not determine it, the line has no tone. `size`: one
 * display unit, µm.
 */
export function drawingOfSurface(stretches: readonly RoughStretch[], size = 1): LoadDrawing {
  const scale = scaleOf(
    0,
    stretches.reduce((high, { rz }) => Math.max(high, rz ?? 0), 0),
    size,
  );
  const lines = linesOf(
    (function* () {
      for (const { points, rz } of stretches) {
        const segments = points.slice(1).map((to, i): Segment => ({ kind: "line", from: points[i] ?? to, to }));
        yield { tone: rz === null ? null : classTone(scale, classAt(scale, rz)), limited: false, segments };
      }
    })(),
  );
  return { scale, lines };
}

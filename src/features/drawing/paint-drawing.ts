import { part, type Segment } from "../../kernel/geometry/point.ts";
import type { Drawing, LineRole } from "../../program/drawing/drawing.ts";
import { matrix, toScreen, type Camera, type Size } from "../../view/camera.ts";

/** The curves of a drawing as paths in mm, made once. */
export type DrawingPaths = {
  readonly [role in LineRole]: Path2D;
};

/** A path through segments, in mm. */
export function pathOf(segments: readonly Segment[]): Path2D {
  const path = new Path2D();
  let last: Segment["to"] | null = null;
  for (const s of segments) {
    if (last?.z !== s.from.z || last.r !== s.from.r) path.moveTo(s.from.z, s.from.r);
    if (s.kind === "line") path.lineTo(s.to.z, s.to.r);
    else {
      const { start, sweep, startRadius } = part.polarOf(s);
      path.arc(s.centre.z, s.centre.r, startRadius, start, start + sweep, sweep < 0);
    }
    last = s.to;
  }
  return path;
}

export function drawingPaths({ curves }: Drawing): DrawingPaths {
  const of = (role: LineRole) => pathOf(curves.filter((c) => c.role === role).map((c) => c.segment));
  return { outline: of("outline"), centre: of("centre"), hidden: of("hidden"), thin: of("thin") };
}

export const DRAWING_COLOURS = {
  line: "--line-strong",
  piece: "--contour",
  text: "--text-soft",
} as const;
export type DrawingColours = Record<keyof typeof DRAWING_COLOURS, string>;

/** Size of the lettering, and least distance of two texts, units of the page. */
const LETTERS = 10,
  APART = { x: 60, y: 12 };
/** Most texts that are shown at once. */
const MOST = 200;

/** Paints all curves and texts: the chosen piece dark, everything else faint. */
export function paintDrawing(
  context: CanvasRenderingContext2D,
  {
    drawing,
    paths,
    piece,
    camera,
    size,
    ratio,
    colours,
  }: {
    readonly drawing: Drawing;
    readonly paths: DrawingPaths;
    readonly piece: Path2D;
    readonly camera: Camera;
    readonly size: Size;
    /** Pixels of the canvas per unit of the page. */
    readonly ratio: number;
    readonly colours: DrawingColours;
  },
): void {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, size.width * ratio, size.height * ratio);
  const [a, b, c, d, e, f] = matrix(camera);
  context.setTransform(a * ratio, b * ratio, c * ratio, d * ratio, e * ratio, f * ratio);
  const wide = (pixels: number) => pixels / camera.scale;
  const stroke = (path: Path2D, colour: string, width: number, dashes: readonly number[] = []) => {
    context.strokeStyle = colour;
    context.lineWidth = wide(width);
    context.setLineDash(dashes.map(wide));
    context.stroke(path);
  };
  stroke(paths.thin, colours.line, 0.5);
  stroke(paths.hidden, colours.line, 0.7, [5, 3]);
  stroke(paths.centre, colours.line, 0.7, [14, 3, 3, 3]);
  stroke(paths.outline, colours.line, 1);
  stroke(piece, colours.piece, 1.4);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillStyle = colours.text;
  context.font = `${LETTERS}px ${getComputedStyle(context.canvas).fontFamily}`;
  context.globalAlpha = 0.85;
  const taken = new Set<string>();
  for (const { text, at } of drawing.texts) {
    const place = toScreen(camera, at);
    if (place.x < 0 || place.y < 0 || place.x > size.width || place.y > size.height) continue;
    const key = `${Math.round(place.x / APART.x)} ${Math.round(place.y / APART.y)}`;
    if (taken.has(key)) continue;
    taken.add(key);
    context.fillText(text, place.x, place.y);
    if (taken.size >= MOST) break;
  }
  context.globalAlpha = 1;
}

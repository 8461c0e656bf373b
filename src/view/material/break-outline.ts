import type { Bounds, Place } from "../camera.ts";

/** A freehand break line: how far it bends to one side, and the lengths of its two waves, pixels. */
const BEND = 4,
  WAVES = [38, 23] as const;
/** Distance of its points, pixels. */
const STEP = 3;

/** How far a break line bends, pixels, at an angle of each of its waves. */
const bendAt = (angles: readonly number[]) => (BEND / 4) * angles.reduce((sum, angle) => sum + 1 - Math.cos(angle), 0);

/**
 * A break line from one place towards another, without the last point. It bends to the right of its way. `pixel`: the
 * length of a pixel.
 */
export function breakWave(a: Place, b: Place, pixel = 1): readonly Place[] {
  const long = Math.hypot(b.x - a.x, b.y - a.y);
  if (long === 0) return [a];
  const along = { x: (b.x - a.x) / long, y: (b.y - a.y) / long };
  return Array.from({ length: Math.ceil(long / (STEP * pixel)) }, (_, i): Place => {
    const s = i * STEP,
      off = pixel * bendAt(WAVES.map((wave) => (2 * Math.PI * s) / wave));
    return { x: a.x + along.x * s * pixel - along.y * off, y: a.y + along.y * s * pixel + along.x * off };
  });
}

/** The outline round what is drawn of a clamping, on both sides of the axis: x along Z, y along the radius. */
export function breakOutline({ left, right, high }: Bounds, pixel = 1): readonly Place[] {
  const corners = [
    { x: left, y: -high },
    { x: right, y: -high },
    { x: right, y: high },
    { x: left, y: high },
  ];
  return corners.flatMap((each, i) => breakWave(each, corners[(i + 1) % corners.length] ?? each, pixel));
}

/** A break line round a circle: how far it bends at an angle, and the chords that show it, a multiple of four. */
export interface RoundBreak {
  readonly bend: (angle: number) => number;
  readonly chords: number;
}

/** The break line round a circle of a radius; it closes with whole waves. */
export function roundBreak(radius: number, pixel: number): RoundBreak {
  const way = (2 * Math.PI * radius) / pixel,
    counts = WAVES.map((wave) => Math.max(2, Math.round(way / wave)));
  return {
    bend: (angle) => pixel * bendAt(counts.map((count) => count * angle)),
    chords: 4 * Math.ceil(way / STEP / 4),
  };
}

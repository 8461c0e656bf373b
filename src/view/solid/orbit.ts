import type { Bounds, Place, Size } from "../camera.ts";

/** A place or a direction in the axes of the machine, mm: x up, y towards the operator, z along the spindle. */
export type SpacePoint = readonly [x: number, y: number, z: number];

/** The position of the eye that looks at a body. */
export interface Orbit {
  /** The centre of rotation. */
  readonly centre: SpacePoint;
  /** Round the vertical: 0 looks from the operator, a quarter turn from the tailstock at the face. Radians. */
  readonly turn: number;
  /** Above the spindle; radians. */
  readonly rise: number;
  /** From the eye to the centre, mm. */
  readonly distance: number;
}

export const NAMED_VIEWS = ["iso", "front", "end"] as const;
export type NamedView = (typeof NAMED_VIEWS)[number];

/** Vertical field of view, radians: small, so that lengths stay comparable. */
export const FIELD = (16 * Math.PI) / 180;

const ANGLES: Readonly<Record<NamedView, { readonly turn: number; readonly rise: number }>> = {
  iso: { turn: 0.62, rise: 0.42 },
  front: { turn: 0, rise: 0 },
  end: { turn: Math.PI / 2, rise: 0 },
};

/** Just below straight above, where up and ahead are the same. */
const HIGHEST = Math.PI / 2 - 0.02;
const clamped = (n: number, low: number, high: number) => Math.min(high, Math.max(low, n));

/** Direction from the centre to the eye, to the right and upwards on the screen; each of length 1. */
export function axesOf({ turn, rise }: Pick<Orbit, "turn" | "rise">): {
  readonly eye: SpacePoint;
  readonly right: SpacePoint;
  readonly up: SpacePoint;
} {
  const [c, s, ct, st] = [Math.cos(rise), Math.sin(rise), Math.cos(turn), Math.sin(turn)];
  return { eye: [s, c * ct, c * st], right: [0, -st, ct], up: [c, -s * ct, -s * st] };
}

/** Where the eye is. */
export function eyeOf(orbit: Orbit): SpacePoint {
  const { eye } = axesOf(orbit),
    { centre, distance } = orbit;
  return [centre[0] + eye[0] * distance, centre[1] + eye[1] * distance, centre[2] + eye[2] * distance];
}

/** Turned by angles, radians, but not beyond straight above or below. */
export const orbited = (orbit: Orbit, turn: number, rise: number): Orbit => ({
  ...orbit,
  turn: orbit.turn + turn,
  rise: clamped(orbit.rise + rise, -HIGHEST, HIGHEST),
});

/** Nearest and farthest eye, mm. */
const DISTANCE = { nearest: 0.5, farthest: 50_000 } as const;

/** Moved nearer by a factor. */
export const zoomedOrbit = (orbit: Orbit, factor: number): Orbit => ({
  ...orbit,
  distance: clamped(orbit.distance / factor, DISTANCE.nearest, DISTANCE.farthest),
});

/** Size of one pixel at the centre, mm. */
export const pixelAt = ({ distance }: Orbit, size: Size): number =>
  (2 * distance * Math.tan(FIELD / 2)) / Math.max(1, size.height);

/**
 * The position of a place in a picture, pixels from its upper left corner; null for a place beside or behind the eye.
 */
export function projected(orbit: Orbit, size: Size, place: SpacePoint): Place | null {
  const { eye, right, up } = axesOf(orbit),
    { centre, distance } = orbit;
  const along = (way: SpacePoint) =>
    way[0] * (place[0] - centre[0]) + way[1] * (place[1] - centre[1]) + way[2] * (place[2] - centre[2]);
  const away = distance - along(eye);
  if (away <= 0) return null;
  const perMm = size.height / (2 * away * Math.tan(FIELD / 2));
  return { x: size.width / 2 + along(right) * perMm, y: size.height / 2 - along(up) * perMm };
}

/** From the same direction, but close to a box of the half plane: the body round it is visible as well. */
export function nearTo(orbit: Orbit, { left, right, low, high }: Bounds, down: boolean): Orbit {
  const size = Math.max(right - left, high - low),
    far = size * NEAR + NEAREST;
  const middle = (low + high) / 2;
  return { ...orbit, centre: [down ? -middle : middle, 0, (left + right) / 2], distance: far };
}

/** Moved by so many pixels. */
export function slid(orbit: Orbit, dx: number, dy: number, size: Size): Orbit {
  const { right, up } = axesOf(orbit),
    mm = pixelAt(orbit, size),
    { centre } = orbit;
  const moved = (k: 0 | 1 | 2) => centre[k] - right[k] * dx * mm + up[k] * dy * mm;
  return { ...orbit, centre: [moved(0), moved(1), moved(2)] };
}

/** The corners of bounds of the half plane, or of those round the body of revolution that fills them. */
function cornersOf({ left, right, low, high }: Bounds, isFlat: boolean): readonly SpacePoint[] {
  if (isFlat) return [left, right].flatMap((z) => [low, high].map((r): SpacePoint => [r, 0, z]));
  const sides = Array.from({ length: 8 }, (_, i) => (i * Math.PI) / 4);
  return [left, right].flatMap((z) => sides.map((a): SpacePoint => [high * Math.cos(a), high * Math.sin(a), z]));
}

/** Distance of the eye from a place that it moves to: in sizes of the place, and in mm at least. */
const NEAR = 9;
const NEAREST = 60;

/** Free space round a body, as a share of the picture. */
const AIR = 1.12;

/** How often a view is centred again: moving it sideways changes the perspective a little. */
const CENTRED = 3;

/**
 * A named view that shows all of a body of revolution, or of a flat thing, as large as the picture allows and in its
 * middle.
 */
export function namedView(view: NamedView, bounds: Bounds, size: Size, isFlat = false): Orbit {
  const { eye, right, up } = axesOf(ANGLES[view]),
    corners = cornersOf(bounds, isFlat);
  const tall = Math.tan(FIELD / 2) / AIR,
    wide = tall * Math.max(0.01, size.width / Math.max(1, size.height));
  let centre: SpacePoint = [0, 0, (bounds.left + bounds.right) / 2];
  let distance: number = DISTANCE.nearest;
  for (let i = 0; i < CENTRED; i += 1) {
    const seen = corners.map((p) => {
      const along = (way: SpacePoint) =>
        way[0] * (p[0] - centre[0]) + way[1] * (p[1] - centre[1]) + way[2] * (p[2] - centre[2]);
      return { near: along(eye), x: along(right), y: along(up) };
    });
    const far = seen.reduce(
      (most, p) => Math.max(most, p.near + Math.abs(p.x) / wide, p.near + Math.abs(p.y) / tall),
      distance,
    );
    if (i === CENTRED - 1) distance = far;
    else {
      const middle = (list: readonly number[]) => (Math.min(...list) + Math.max(...list)) / 2;
      const dx = middle(seen.map((p) => p.x / (far - p.near))) * far,
        dy = middle(seen.map((p) => p.y / (far - p.near))) * far;
      centre = [
        centre[0] + right[0] * dx + up[0] * dy,
        centre[1] + right[1] * dx + up[1] * dy,
        centre[2] + right[2] * dx + up[2] * dy,
      ];
    }
  }
  return { centre, ...ANGLES[view], distance };
}

/** Angle brought to within half a turn of another one. */
const nearAngle = (angle: number, other: number) => angle - 2 * Math.PI * Math.round((angle - other) / (2 * Math.PI));

/** A view on the way between two views, 0 … 1: it starts and stops gently and turns the shorter way round. */
export function viewBetween(from: Orbit, to: Orbit, share: number): Orbit {
  const k = clamped(share, 0, 1),
    eased = k * k * (3 - 2 * k),
    mix = (a: number, b: number) => a + (b - a) * eased;
  if (k >= 1) return to;
  const centre = (i: 0 | 1 | 2) => mix(from.centre[i], to.centre[i]);
  return {
    centre: [centre(0), centre(1), centre(2)],
    turn: mix(from.turn, nearAngle(to.turn, from.turn)),
    rise: mix(from.rise, to.rise),
    distance: mix(from.distance, to.distance),
  };
}

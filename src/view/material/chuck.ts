import { jawWidth, type Clamped } from "../../kernel/area/clamping.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { radiusOf } from "../../kernel/units.ts";
import { boundsOf, common, grownBounds, joined } from "../bounds.ts";
import type { Bounds } from "../camera.ts";
import { unstatedClamping, type UnstatedClamping } from "../unstated-clamping.ts";

/** A place beside the axis: r is positive on the tool's side, negative on the other, mm. */
export type ChuckPoint = readonly [z: number, r: number];

/**
 * The clamping seen from the side, with one jaw in the plane of the cut: the stated bodies to scale, and nothing else.
 */
export interface ChuckDrawing {
  /** The plane at the rear end, if no clamping is stated. */
  readonly unstated: UnstatedClamping | null;
  /** Chuck, collet, driver and tailstock: bodies of revolution, as outlines of one half. */
  readonly turned: readonly (readonly ChuckPoint[])[];
  /** The jaw on the tool's side. */
  readonly jaws: readonly (readonly ChuckPoint[])[];
  /** The jaw facing the viewer, a third of a turn on: its flank, and its outward faces, step by step. */
  readonly flanks: readonly (readonly ChuckPoint[])[];
  readonly backs: readonly (readonly ChuckPoint[])[];
  /** The limit that no tool may cross. */
  readonly limit: { readonly z?: number; readonly r?: number } | null;
  /** Where break lines cut the clamping off; null if nothing is cut. */
  readonly cut: Bounds | null;
  /** Everything that is drawn. */
  readonly all: Bounds;
  /** The part of the clamping that should be in the picture. */
  readonly seen: Bounds;
}

/** The jaw a third of a turn on is seen under this angle: its radius shortened by the cosine, its width by the sine. */
const [SHORT, WIDE] = [-Math.cos((2 * Math.PI) / 3), Math.sin((2 * Math.PI) / 3)];
/** Extent shown behind the grip and beside the blank, as a share of the blank's radius. */
const [BEHIND, BESIDE] = [0.35, 0.3];
/** Extent shown round a contact of the tool, as a share of the blank's radius. */
const ROUND_CONTACT = 0.2;

const placesOf = (ring: Ring): readonly ChuckPoint[] => ring.map(({ z, r }) => [z, r]);

/**
 * The drawing of a blank's clamping; a plane at the blank's rear end if none is stated. A chuck is far larger than most
 * parts, so break lines cut it off near the blank, and beyond all `contacts` with the tool.
 */
export function chuckDrawing(
  blank: readonly Ring[],
  material: Bounds,
  clamped: Clamped | null,
  contacts: Bounds | null = null,
): ChuckDrawing {
  if (!clamped) {
    const unstated = unstatedClamping(blank, material);
    const all = joined(material, boundsOf([...unstated.plane, ...unstated.hatch.flat()])) ?? material;
    return { unstated, turned: [], jaws: [], flanks: [], backs: [], limit: null, cut: null, all, seen: all };
  }
  const {
    clamping: { kind, face, length, size = 0, tailstock, limit },
    bodies,
  } = clamped;
  const rings = bodies.flatMap(({ part, rings }) =>
    part === "limit" ? [] : rings.map((ring) => ({ isJaw: part === "jaws", ring })),
  );
  const jaws = rings.flatMap(({ isJaw, ring }) => (isJaw ? [ring] : []));
  const half = (jawWidth(size) / 2) * WIDE,
    turned = (z: number, r: number, to: number): ChuckPoint => [z, -r * SHORT + to];
  // The outward faces of a jaw are visible on the jaw facing the viewer.
  const outwards = jaws.flatMap((ring) =>
    ring.flatMap((p, i) => {
      const q = ring[(i + 1) % ring.length] ?? p;
      return p.r === q.r && q.z < p.z ? [[p, q] as const] : [];
    }),
  );
  const whole = joined(material, boundsOf(rings.flatMap(({ ring }) => ring))) ?? material;
  const by = material.high * BEHIND,
    tip = kind === "centres" ? face : face - length;
  const seen = {
    left: Math.min(material.left, tip) - by,
    right: tailstock ? Math.max(material.right, tailstock.tip) + by : Math.max(material.right, face),
    low: 0,
    high: Math.min(whole.high, material.high * (1 + BESIDE)),
  };
  const cut = joined(seen, contacts && grownBounds(contacts, material.high * ROUND_CONTACT)) ?? seen;
  return {
    unstated: null,
    turned: rings.flatMap(({ isJaw, ring }) => (isJaw ? [] : [placesOf(ring)])),
    jaws: jaws.map(placesOf),
    flanks: jaws.map((ring) => ring.map(({ z, r }) => turned(z, r, half))),
    backs: outwards.map(([p, q]) => [
      turned(q.z, p.r, half),
      turned(p.z, p.r, half),
      turned(p.z, p.r, -half),
      turned(q.z, p.r, -half),
    ]),
    limit: limit
      ? { ...(limit.z !== undefined && { z: limit.z }), ...(limit.x !== undefined && { r: radiusOf(limit.x) }) }
      : null,
    cut,
    all: common(whole, cut),
    seen,
  };
}

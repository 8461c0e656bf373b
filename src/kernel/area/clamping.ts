import { areaOf } from "./area.ts";
import { boxAround } from "./box.ts";
import { difference, intersection } from "./clip.ts";
import { at, type Ring } from "../geometry/point.ts";
import { withoutSlivers } from "./real-area.ts";
import { radius, radiusOf, toDiameter } from "../units.ts";

/** How the workpiece is clamped. */
export type ClampingKind = "chuckOutside" | "chuckInside" | "softJaws" | "collet" | "centres";

/** The stated clamping, mm; angles in degrees. Anything not stated is unknown. */
export interface Clamping {
  readonly kind: ClampingKind;
  /** ⌀ at which jaws or collet grip; between centres that of the driver. */
  readonly diameter: number;
  /** Clamped length of the workpiece in the jaws or the collet, along Z; 0 between centres. */
  readonly length: number;
  /** Z of the front of jaws, collet or driver. */
  readonly face: number;
  /** ⌀ of the chuck, or of the nose of the collet chuck; absent between centres. */
  readonly size?: number;
  /** ⌀ of the quill or live centre, Z of its tip, and the angle of its point. */
  readonly tailstock?: { readonly quill: number; readonly tip: number; readonly angle: number };
  /** No tool may go to the left of this Z within this ⌀; if one of the two is absent, the other alone applies. */
  readonly limit?: { readonly z?: number; readonly x?: number };
}

/** Parts of a clamping that a tool can collide with. */
export type ClampPart = "jaws" | "chuck" | "collet" | "driver" | "tailstock" | "limit";

/** A body of revolution, by its outlines in the half plane. */
export interface ClampBody {
  readonly part: ClampPart;
  readonly rings: readonly Ring[];
}

/** A stated clamping with its bodies, without the blank. */
export interface Clamped {
  readonly clamping: Clamping;
  readonly bodies: readonly ClampBody[];
}

/**
 * Common three-jaw power chucks, mm: ⌀, bore, depth of the body, and the top jaws: height over the face, length along
 * the radius, width.
 */
const CHUCKS = [
  { size: 160, bore: 45, deep: 81, high: 36, long: 66, wide: 31 },
  { size: 200, bore: 52, deep: 91, high: 40, long: 80, wide: 35 },
  { size: 250, bore: 75, deep: 104, high: 44, long: 95, wide: 40 },
  { size: 315, bore: 91, deep: 112, high: 50, long: 112, wide: 50 },
] as const;
/** Common chuck diameters, mm. */
export const CHUCK_SIZES: readonly number[] = CHUCKS.map(({ size }) => size);

/** The chuck of a diameter: the next larger one of the list, scaled. */
function chuckOf(size: number) {
  const of = CHUCKS.find((c) => c.size >= size) ?? CHUCKS[CHUCKS.length - 1] ?? CHUCKS[0],
    k = size / of.size;
  return { bore: of.bore * k, deep: of.deep * k, high: of.high * k, long: of.long * k, wide: of.wide * k };
}

/** Width of a jaw of a chuck, mm. */
export const jawWidth = (size: number): number => chuckOf(size).wide;

/**
 * Steps of a hard jaw, starting at the workpiece: share of its length along the radius, and of its height over the
 * chuck.
 */
const STEPS = [
  [0.36, 1],
  [0.7, 0.62],
  [1, 0.3],
] as const;
/** A soft jaw is one block. */
const BLOCK = [[1, 1]] as const;
/** The shoulder of a jaw that the workpiece rests against: across, and at least behind it, mm. */
const SHOULDER = { across: 3, behind: 6 } as const;
/** Largest reach of a jaw as a factor of the chuck ⌀, and its shortest length as a share of its usual length. */
const [BEYOND, SHORTEST] = [1.1, 0.3];
/** Collet chuck: wall at the nose and least depth; depth of a driver; length drawn of a quill; mm. */
const [WALL, DEEP, DRIVER, QUILL] = [6, 60, 40, 160];
/** Farther than any machine reaches, mm. */
const FAR = 5000;

const box = (left: number, right: number, low: number, high: number): Ring => [
  at(left, low),
  at(right, low),
  at(right, high),
  at(left, high),
];

/** The jaws of a chuck that grips at a radius, and Z of the face that they are mounted on. */
function jawsOf(
  { kind, diameter: d, length, face }: Clamping,
  size: number,
): { readonly ring: Ring; readonly foot: number } {
  const { high, long } = chuckOf(size),
    grip = radiusOf(d),
    inside = kind === "chuckInside";
  const foot = face - Math.max(high, length + SHOULDER.behind),
    tall = face - foot;
  const most = inside ? grip : radiusOf(size) * BEYOND - grip,
    reach = Math.max(SHORTEST * long, Math.min(long, most));
  // Measured from the gripped surface, away from the workpiece.
  const r = (away: number) => Math.max(0, grip + (inside ? -away : away));
  const back = face - length;
  const profile = (kind === "softJaws" ? BLOCK : STEPS).flatMap(([share, height], i, all) => {
    const z = foot + tall * height;
    return [at(z, r(reach * (all[i - 1]?.[0] ?? 0))), at(z, r(reach * share))];
  });
  const ring = [
    at(foot, r(-SHOULDER.across)),
    at(back, r(-SHOULDER.across)),
    at(back, r(0)),
    ...profile,
    at(foot, r(reach)),
  ];
  return { ring: inside ? ring.reverse() : ring, foot };
}

/** The bodies that grip the workpiece at its rear end. */
function gripBodies(c: Clamping): ClampBody[] {
  const { kind, face, size, length } = c,
    r = radiusOf(c.diameter);
  if (kind === "centres") return [{ part: "driver", rings: [box(face - DRIVER, face, 0, r)] }];
  if (size === undefined) return [];
  if (kind === "collet") {
    const back = face - Math.max(DEEP, length + SHOULDER.behind),
      outer = radiusOf(size),
      nose = Math.min(outer, r + WALL);
    const ring = [at(back, r), at(face, r), at(face, nose), at(face - (outer - nose) / 2, outer), at(back, outer)];
    return [{ part: "collet", rings: [ring] }];
  }
  const { ring, foot } = jawsOf(c, size),
    { bore, deep } = chuckOf(size);
  return [
    { part: "jaws", rings: [ring] },
    { part: "chuck", rings: [box(foot - deep, foot, radiusOf(bore), radiusOf(size))] },
  ];
}

function centreOf({ quill, tip, angle }: NonNullable<Clamping["tailstock"]>): Ring {
  const r = radiusOf(quill),
    full = tip + r / Math.tan(((angle / 2) * Math.PI) / 180);
  return [at(tip, 0), at(full + QUILL, 0), at(full + QUILL, r), at(full, r)];
}

/**
 * Bodies that tool and holder must not touch: jaws and chuck, collet or driver, tailstock, each without the blank, and
 * everything behind a stated limit. Jaws count all round, because they rotate.
 */
export function clampingBodies(c: Clamping, blank: readonly Ring[]): readonly ClampBody[] {
  const tailstock: readonly ClampBody[] = c.tailstock ? [{ part: "tailstock", rings: [centreOf(c.tailstock)] }] : [];
  const bodies = [...gripBodies(c), ...tailstock].map(({ part, rings }) => ({ part, rings: difference(rings, blank) }));
  const { z = FAR, x = toDiameter(radius(FAR)) } = c.limit ?? {};
  return c.limit ? [...bodies, { part: "limit", rings: [box(-FAR, z, 0, radiusOf(x))] }] : bodies;
}

/** Greatest distance of the gripped ⌀ from the surface of the blank, as a radius, mm. */
const NEAR = 0.5;

/** True when jaws or collet do not grip the blank: it has no material at their ⌀, or material inside them. */
export function missesBlank({ kind, diameter: d, length, face }: Clamping, blank: readonly Ring[]): boolean {
  if (kind === "centres" || blank.length === 0) return false;
  const r = radiusOf(d),
    [back, inside] = [face - length, kind === "chuckInside"];
  const has = (low: number, high: number) =>
    areaOf(withoutSlivers(intersection(blank, [box(back, face, Math.max(0, low), high)]))) > 0;
  return inside ? !has(r, r + NEAR) || has(0, r - NEAR) : !has(r - NEAR, r) || has(r + NEAR, FAR);
}

/**
 * Zones where a clamping grips the workpiece: a piece that reaches into one of them is held. Between centres both ends
 * are held; a tailstock in front of a chuck only supports.
 */
export function gripZones(c: Clamping, blank: readonly Ring[]): readonly Ring[] {
  const { kind, diameter: d, length, face, tailstock } = c,
    r = radiusOf(d);
  if (kind !== "centres") return [box(face - length, face, Math.max(0, r - NEAR), r + NEAR)];
  const { left, high } = boxAround(blank),
    driven = box(left, left + NEAR, 0, high);
  return tailstock ? [driven, centreOf({ ...tailstock, tip: tailstock.tip - NEAR })] : [driven];
}

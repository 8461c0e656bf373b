import { at, type Pt, type Ring } from "../../kernel/geometry/point.ts";
import { trianglesOf } from "./fill.ts";
import { encodedLook, partedBy, type StockLooks } from "./finish.ts";
import { joinedMeshes, MeshBuilder, NO_MESH, type Mesh } from "./mesh.ts";
import { profileOf, type Profile } from "./profile.ts";

/** A solid of revolution, ready to be shown or written. Surface and section together are closed. */
export interface Solid {
  /** The revolved outlines. */
  readonly surface: Mesh;
  /** The two faces of the cut; empty in a whole body. */
  readonly section: Mesh;
  /** Edges seen as lines: x, y, z of both ends of each piece. */
  readonly edges: Float32Array;
}

/** How a body is revolved. */
export interface Turning {
  /** Chords of a full turn, a multiple of four. */
  readonly chords: number;
  /** The quarter between X up and the operator is cut away. */
  readonly quarterCut: boolean;
  /** The look of the stock's surfaces; absent if not needed. */
  readonly finish?: StockLooks;
}

/** How far a chord of a revolved body may leave its circle, mm. */
export const SOLID_CHORD = 0.02;
/** Fewest and most chords of a full turn. */
const CHORDS = { least: 32, most: 720 } as const;

/**
 * Chords of a full turn that stay within a length (mm) of a circle: a multiple of four, so that quarters end on one.
 */
export function chordsFor(size: number, chord: number = SOLID_CHORD): number {
  const half = Math.acos(Math.max(0, 1 - chord / Math.max(size, chord)));
  const needed = 4 * Math.ceil(Math.PI / half / 4);
  return Math.min(CHORDS.most, Math.max(CHORDS.least, needed));
}

/** Directions round the axis, from X up over the operator; the four main ones are exact. */
export function directionsOf(chords: number): readonly (readonly [number, number])[] {
  const quarter = chords / 4;
  const first = Array.from({ length: quarter }, (_, i) => {
    const a = (i / chords) * 2 * Math.PI;
    return i === 0 ? ([1, 0] as const) : ([Math.cos(a), Math.sin(a)] as const);
  });
  const turned = (list: readonly (readonly [number, number])[]) => list.map(([x, y]) => [-y, x] as const);
  const second = turned(first),
    third = turned(second);
  return [...first, ...second, ...third, ...turned(third)];
}

const UP = [1, 0] as const;
const AXIS = at(0, 0);

/** Where the turn begins and over how many chords it goes. */
export const spanOf = ({ chords, quarterCut }: Turning) =>
  quarterCut ? { first: chords / 4, count: (3 * chords) / 4 } : { first: 0, count: chords };

function surfaceOf(profile: Profile, turning: Turning, directions: ReturnType<typeof directionsOf>): Mesh {
  const { first, count } = spanOf(turning),
    { points, sides, looks: known } = profile;
  const rows = turning.quarterCut ? count + 1 : count;
  const positions = new Float32Array(3 * points.length * rows),
    normals = new Float32Array(positions.length);
  const ways = Array.from({ length: rows }, (_, row) => directions[(first + row) % turning.chords] ?? UP);
  let place = 0;
  for (const { p, nz, nr } of points) {
    for (const [x, y] of ways) {
      // Zero is never negative, so that equal corners are equal to the bit.
      positions[place] = p.r * x + 0;
      normals[place++] = nr * x;
      positions[place] = p.r * y + 0;
      normals[place++] = nr * y;
      positions[place] = p.z + 0;
      normals[place++] = nz;
    }
  }
  const index = new Uint32Array(6 * sides.length * count);
  let n = 0;
  for (const [a, b] of sides) {
    const [fromAxis, toAxis] = [points[a]?.p.r === 0, points[b]?.p.r === 0];
    if (fromAxis && toAxis) continue;
    for (let row = 0; row < count; row += 1) {
      const next = (row + 1) % rows;
      const p = a * rows + row,
        q = b * rows + row,
        far = b * rows + next,
        over = a * rows + next;
      // A triangle with two corners at one place on the axis is empty.
      if (!toAxis) {
        index[n++] = p;
        index[n++] = q;
        index[n++] = far;
      }
      if (!fromAxis) {
        index[n++] = p;
        index[n++] = far;
        index[n++] = over;
      }
    }
  }
  const mesh = { positions, normals, index: index.slice(0, n) };
  if (!turning.finish) return mesh;
  const looks = new Float32Array(2 * points.length * rows);
  sides.forEach((ends, side) => {
    for (const end of ends) {
      const [texture, turn] = encodedLook(known[side], points[end]?.p ?? AXIS);
      for (let row = 0; row < rows; row += 1) looks.set([texture, turn], 2 * (end * rows + row));
    }
  });
  return { ...mesh, looks };
}

/** Both faces of the cut: outlines of the upright one, and of the one towards the operator. */
export function cutFaces(standing: readonly Ring[], lying: readonly Ring[]): Mesh {
  const build = new MeshBuilder();
  for (const [rings, upright] of [
    [standing, true],
    [lying, false],
  ] as const) {
    const triangles = trianglesOf(rings),
      points = rings.flat();
    const corners = points.map((p) =>
      upright ? build.corner(p.r, 0, p.z, 0, 1, 0) : build.corner(0, p.r, p.z, 1, 0, 0),
    );
    for (let i = 0; i < triangles.length; i += 3) {
      const [a = 0, b = 0, c = 0] = [0, 1, 2].map((k) => corners[triangles[i + k] ?? 0]);
      if (upright) build.triangle(a, b, c);
      else build.triangle(a, c, b);
    }
  }
  return build.mesh();
}

function edgesOf(
  profiles: readonly Profile[],
  turning: Turning,
  directions: ReturnType<typeof directionsOf>,
): Float32Array {
  const { first, count } = spanOf(turning),
    out: number[] = [];
  const piece = (a: readonly [number, number, number], b: readonly [number, number, number]) => out.push(...a, ...b);
  const on = ({ r, z }: Pt, row: number) => {
    const [x, y] = directions[row % turning.chords] ?? UP;
    return [r * x, r * y, z] as const;
  };
  for (const { points, sides, sharp } of profiles) {
    for (const place of sharp) {
      const p = points[place]?.p;
      for (let row = first; p && row < first + count; row += 1) piece(on(p, row), on(p, row + 1));
    }
    if (!turning.quarterCut) continue;
    for (const [a, b] of sides) {
      const [p, q] = [points[a]?.p, points[b]?.p];
      if (p && q) {
        for (const row of [0, first]) piece(on(p, row), on(q, row));
      }
    }
  }
  return Float32Array.from(out);
}

/**
 * The body that rings of the half plane make when they turn round the spindle axis: outer rings counter-clockwise,
 * holes clockwise, several rings several bodies. Outlines on the axis are closed there; places beyond it count as on
 * it.
 */
export function revolved(rings: readonly Ring[], turning: Turning): Solid {
  const profiles = rings.flatMap(
    (ring) => profileOf(turning.finish ? partedBy(turning.finish, ring) : ring, turning.finish) ?? [],
  );
  if (profiles.length === 0) return { surface: NO_MESH, section: NO_MESH, edges: new Float32Array() };
  const directions = directionsOf(turning.chords);
  const outlines = profiles.map(({ points, sides }) => sides.flatMap(([a]): Pt[] => (points[a] ? [points[a].p] : [])));
  return {
    surface: joinedMeshes(profiles.map((p) => surfaceOf(p, turning, directions))),
    section: turning.quarterCut ? cutFaces(outlines, outlines) : NO_MESH,
    edges: edgesOf(profiles, turning, directions),
  };
}

/** All of a solid as one closed surface. */
export const wholeMesh = ({ surface, section }: Solid): Mesh => joinedMeshes([surface, section]);

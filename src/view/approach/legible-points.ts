import { plane, type PlanePoint } from "../../kernel/plane/plane.ts";
import type { NamedPoints } from "../../kernel/plane/approach.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { Camera } from "../camera.ts";

const { apart } = plane;

/** Dots nearer than this overlap, pixels. */
const NEAREST = 9;

/** Approaches whose points are apart at this zoom; when zoomed out, the points of an approach are hidden together. */
export const withLegiblePoints = <A extends { readonly points: NamedPoints }>(
  approaches: readonly A[],
  camera: Camera,
): readonly A[] =>
  approaches.filter(({ points }) => {
    const all: readonly PlanePoint[] = Object.values(points);
    return all.every((p, i) =>
      all.slice(0, i).every((q) => apart(p, q) <= SAME || apart(p, q) * camera.scale >= NEAREST),
    );
  });

import type { Bounds } from "../camera.ts";
import { chuckRings } from "../chuck.ts";

/** A place beside the axis: r is positive on the tool's side, negative on the other, mm. */
export type ChuckPoint = readonly [z: number, r: number];

/** A three-jaw chuck with soft jaws as it is seen from the side, one jaw in the plane of the cut. It decides nothing. */
export interface ChuckDrawing {
  /** The turned body: from its face to the left, with the leg of its chamfer. */
  readonly body: { readonly face: number; readonly back: number; readonly radius: number; readonly chamfer: number };
  /** Radius of the circle of bolts in the face. */
  readonly bolts: number;
  /** Turned grooves round the body. */
  readonly grooves: readonly number[];
  /** The jaw on the tool's side: the soft jaw, the base jaw under it, and the axis of its screw. */
  readonly jaw: readonly ChuckPoint[];
  readonly base: readonly ChuckPoint[];
  readonly screw: readonly [ChuckPoint, ChuckPoint];
  /** Where the soft jaw stands on its base: serrated, one tooth a pitch. */
  readonly joint: { readonly z: number; readonly from: number; readonly to: number };
  /** The jaw that stands to the viewer, a third of a turn on: its flank, and its stepped back from the work outwards. */
  readonly flank: readonly ChuckPoint[];
  readonly backs: readonly (readonly ChuckPoint[])[];
  /** What of it all should be in the picture. */
  readonly seen: Bounds;
}

/** Diameters in which chucks are made, mm. */
const SIZES = [63, 80, 100, 125, 160, 200, 250, 315, 400, 500, 630, 1000, 1250] as const;
/** A tooth of the serration is so long, mm. */
export const SERRATION = 1.5;

const within = (low: number, value: number, high: number) => Math.min(high, Math.max(low, value));

/** Steps of the jaw, from the work outwards: share of its size across, and of its height over the joint. */
const STEPS = [[0.36, 1], [0.7, 0.62], [1, 0.3]] as const;

/** The jaw a third of a turn on is seen under this angle: its radius shortened by the cosine, its width by the sine. */
const [SHORT, WIDE] = [-Math.cos((2 * Math.PI) / 3), Math.sin((2 * Math.PI) / 3)];

/** A chuck for the work, gripping it where `chuckRings` says; `busy` is where contour and tool go. */
export function chuckDrawing(blank: Bounds, busy: Bounds | null): ChuckDrawing {
  const { jaw: grip } = chuckRings(blank, busy);
  const outer = blank.high, work = blank.left, tip = Math.max(...grip.map((p) => p.z));
  const across = within(7, outer * 0.45, 70), rise = within(5, outer * 0.26, 30);
  const radius = (SIZES.find((size) => size / 2 >= outer + across * 1.05) ?? 2 * (outer + across * 1.05)) / 2;
  const face = work - rise, joint = face + rise * 0.3, inner = outer - within(1.2, outer * 0.14, 9);
  const steps = STEPS.map(([size, height]) => ({ r: outer + across * size, z: joint + (tip - joint) * height }));
  const ends = steps.flatMap(({ r, z }, i): ChuckPoint[] => [[z, steps[i - 1]?.r ?? outer], [z, r]]);
  const jaw: ChuckPoint[] = [[joint, inner], [work, inner], [work, outer], ...ends, [joint, outer + across]];
  const foot = outer + across * 0.94;
  const half = (within(8, outer * 0.42, 60) / 2) * WIDE;
  const turned = ([z, r]: ChuckPoint, to: number): ChuckPoint => [z, -r * SHORT + to];
  return {
    body: { face, back: face - radius * 1.1, radius, chamfer: radius * 0.035 },
    bolts: radius * 0.7,
    grooves: [face - radius * 0.14, face - radius * 0.17],
    jaw,
    base: [[face, inner + across * 0.12], [joint, inner + across * 0.12], [joint, foot], [face, foot]],
    screw: [[face - rise * 0.3, outer + across * 0.53], [(steps[1]?.z ?? tip) + rise * 0.15, outer + across * 0.53]],
    joint: { z: joint, from: inner + across * 0.12, to: foot },
    flank: jaw.map((p) => turned(p, half)),
    backs: steps.map(({ r, z }, i) => {
      const low = steps[i + 1]?.z ?? face;
      return ([[low, r], [z, r]] as const).map((p) => turned(p, half)).concat(([[z, r], [low, r]] as const).map((p) => turned(p, -half)));
    }),
    seen: { left: face - rise * 0.6, right: tip, low: 0, high: outer + across * 0.5 },
  };
}

/** A line of teeth across from one radius to another, pointing to the free end. */
export function serration({ z, from, to }: ChuckDrawing["joint"]): readonly ChuckPoint[] {
  const count = Math.max(1, Math.round((to - from) / SERRATION)), tooth = (to - from) / count;
  return Array.from({ length: count }, (_, i): ChuckPoint[] => {
    const r = from + i * tooth;
    return [[z, r], [z + tooth * 0.45, r + tooth / 2]];
  }).flat().concat([[z, to]]);
}

import {
  cutThread,
  noseOfRoot,
  type Aim,
  type CutThread,
  type NamedThread,
  type ThreadSide,
} from "../kernel/thread/named-thread.ts";
import { radians, rounded } from "../kernel/units.ts";
import type { ThreadRoles } from "./define.ts";

/** What a cycle has where a thread is put: numbers by Q, mm and degrees; "auto" and missing ones count as unknown. */
export type TypedValues = Readonly<Partial<Record<string, number | "auto">>>;

/** How a thread is cut: where in its tolerance, and by the nose radius (mm) of which insert; null: of its full profile. */
export interface ThreadAim {
  readonly aim: Aim;
  readonly nose: number | null;
}

/** The values of a thread for a cycle. */
export interface ThreadFill {
  readonly inside: boolean;
  readonly cut: CutThread;
  /** Cylinder before the thread, ⌀ mm; the one around a taper. */
  readonly before: number;
  /** By Q, mm and degrees. */
  readonly values: Readonly<Record<string, number>>;
}

/** Why a thread has no values for a cycle: it is a taper, or does not exist on that side. */
export type ThreadRefusal = "taper" | "side";

/** The number of a value; null where it has none. */
export const numberAt = (typed: TypedValues, q: string | undefined): number | null => {
  const value = q === undefined ? undefined : typed[q];
  return typeof value === "number" ? value : null;
};

/** Further depth that puts the flanks of an insert with another nose radius in the same place, mm. */
export function depthForNose(thread: NamedThread, inside: boolean, nose: number): number {
  const side = thread[inside ? "inside" : "outside"];
  if (!side || thread.flatRoot) return 0;
  return (noseOfRoot(thread, side) - nose) * (1 / Math.sin(radians(thread.angle) / 2) - 1);
}

/** The thread with the root that a nose radius leaves. */
function withNose(thread: NamedThread, inside: boolean, cut: CutThread, nose: number | null): CutThread {
  const deeper = nose === null ? 0 : depthForNose(thread, inside, nose);
  const root = cut.root + (inside ? deeper : -deeper) * 2;
  return { ...cut, root: rounded(root), depth: rounded(Math.abs(root - cut.crest) / 2) };
}

/** Which side a thread is put on: the one that its name says, or else the one of the cycle. */
export function sideOf(thread: NamedThread, roles: ThreadRoles, typed: TypedValues): "outside" | "inside" {
  if (thread.side) return thread.side;
  return numberAt(typed, roles.position) === 1 ? "inside" : "outside";
}

/** Diameter and Z of both ends of a taper, from its end face; in cutting direction. */
function taperEnds(
  thread: NamedThread,
  inside: boolean,
  across: number,
  { line }: ThreadRoles,
  typed: TypedValues,
): { readonly from: number; readonly to: number; readonly z: readonly [number, number] } | null {
  const { gauge, taper } = thread;
  if (!gauge || !line) return null;
  const [start, end] = [numberAt(typed, line.startZ) ?? 0, numberAt(typed, line.endZ)];
  const long = inside ? gauge.usefulInside : gauge.useful;
  // The face is the right end; the thread runs into it or out of it.
  const isInwards = end === null || end <= start;
  const face = isInwards ? start : end;
  const atFace = inside ? across : across - gauge.length * taper;
  const behind = atFace + (inside ? -1 : 1) * long * taper;
  const back = face - long;
  return isInwards ? { from: atFace, to: behind, z: [face, back] } : { from: behind, to: atFace, z: [back, face] };
}

/** The values of a thread for a cycle, or why it has none. */
export function valuesOfThread(
  thread: NamedThread,
  roles: ThreadRoles,
  typed: TypedValues,
  { aim, nose }: ThreadAim,
): ThreadFill | ThreadRefusal {
  const side = sideOf(thread, roles, typed);
  const found: ThreadSide | null = thread[side];
  if (!found) return "side";
  const inside = side === "inside";
  const cut = withNose(thread, inside, cutThread(found, aim), nose);
  // The cycle counts from the crest outside and from the root inside.
  const across = inside ? cut.root : cut.crest;
  const ends = thread.taper > 0 ? taperEnds(thread, inside, across, roles, typed) : null;
  if (thread.taper > 0 && roles.diameters.length > 0 && !ends) return "taper";
  const { line, diameters } = roles;
  const half = steepestInfeed(thread);
  const infeed = numberAt(typed, roles.flank);
  return {
    inside,
    cut,
    before: !ends
      ? cut.crest
      : inside
        ? rounded(Math.min(ends.from, ends.to) - cut.root + cut.crest)
        : rounded(Math.max(ends.from, ends.to)),
    values: {
      ...(numberAt(typed, roles.position) !== Number(inside) && { [roles.position]: Number(inside) }),
      [roles.pitch]: rounded(thread.pitch * thread.starts),
      [roles.depth]: cut.depth,
      [roles.starts]: thread.starts,
      ...Object.fromEntries(
        diameters.map((q, i) => [q, rounded(ends ? (i === 0 ? ends.from : ends.to) : across)] as const),
      ),
      ...(line && { [line.form]: 0 }),
      ...(line && ends && { [line.startZ]: rounded(ends.z[0]), [line.endZ]: rounded(ends.z[1]) }),
      ...(infeed !== null && infeed > half && { [roles.flank]: half }),
    },
  };
}

/** Steepest infeed that leaves the flank undamaged: half the angle, or the flatter flank. */
const steepestInfeed = ({ angle, flanks }: NamedThread): number => (flanks ? Math.min(...flanks) : angle / 2);

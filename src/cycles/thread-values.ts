import {
  cutThread,
  noseOfRoot,
  type Aim,
  type CutThread,
  type NamedThread,
  type ThreadSide,
} from "../kernel/thread/named-thread.ts";
import { readThread, THREAD_STANDARDS } from "../kernel/thread/threads.ts";
import { INCH_ROUNDED } from "../kernel/tolerance.ts";
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

const numberAt = (typed: TypedValues, q: string | undefined): number | null => {
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

/** A value of a cycle that is not the one of a thread. */
export interface ThreadDifference {
  readonly q: string;
  readonly is: number;
  readonly should: number;
}

/** A thread found in the values of a cycle, with the values that are not its own. */
export interface FoundThread {
  readonly thread: NamedThread;
  readonly aim: Aim;
  readonly nose: number | null;
  readonly inside: boolean;
  readonly differences: readonly ThreadDifference[];
}

/** Values that an inch program states rounded count as equal. */
const isSame = (a: number, b: number): boolean => Math.abs(a - b) <= INCH_ROUNDED / 2;
/** Farthest a diameter may be from that of a thread that the values are compared with, in pitches. */
const NEAR = 0.25;

/** The values of a cycle that differ from those of a thread; a depth of 0 is the basic depth of a metric one. */
export function differencesFrom(
  thread: NamedThread,
  roles: ThreadRoles,
  typed: TypedValues,
  aim: ThreadAim,
): readonly ThreadDifference[] {
  const fill = valuesOfThread(thread, roles, typed, aim);
  if (typeof fill === "string") return [];
  return Object.entries(fill.values).flatMap(([q, should]) => {
    const is = numberAt(typed, q);
    // Its length is not what makes a thread.
    if (is === null || isSame(is, should) || q === roles.line?.startZ || q === roles.line?.endZ) return [];
    if (q === roles.depth && is === 0 && thread.standard === "metric" && aim.aim === "basic") return [];
    return [{ q, is, should }];
  });
}

/** Usual classes of each standard, tried besides the one where no class is named. */
const CLASSES: Readonly<Record<string, readonly string[]>> = {
  metric: ["-6h", "-4h", "-4g6g", "-6f", "-6e", "-8g", "-6G", "-5H", "-4H", "-7H"],
  unified: ["-3A", "-1A", "-3B", "-1B"],
  pipe: ["B"],
};

let tables: readonly NamedThread[] | null = null;
/** Every thread of the tables. */
const listed = (): readonly NamedThread[] =>
  (tables ??= THREAD_STANDARDS.flatMap(({ names }) => names.flatMap((name) => readThread(name) ?? [])));

/** Names that the values may say: sizes of the tables with this pitch, and a metric size of its own. */
function candidates(across: number, pitch: number, starts: number): NamedThread[] {
  const near = listed().filter(
    (t) => isSame(t.pitch, pitch) && Math.abs(t.nominal - across) <= Math.max(1, NEAR * 4 * pitch),
  );
  const single = [
    ...near.map(({ name }) => name),
    ...[0, 1].map((up) => `M${Math.round(across * 2 + up) / 2}x${pitch}`),
  ];
  if (starts === 1) return single.flatMap((name) => readThread(name) ?? []);
  const lead = rounded(pitch * starts);
  return [Math.round(across), Math.ceil(across)].flatMap((d) =>
    [`Tr${d}x${lead}P${pitch}`, `M${d}xPh${lead}P${pitch}`, `S${d}x${lead}P${pitch}`].flatMap(
      (name) => readThread(name) ?? [],
    ),
  );
}

/** The thread that the values of a cycle make, or are near to; null for none. `nose`: of the insert in use, mm. */
export function threadOfValues(roles: ThreadRoles, typed: TypedValues, nose: number | null): FoundThread | null {
  const [across, lead] = [numberAt(typed, roles.diameters[0]), numberAt(typed, roles.pitch)];
  const starts = Math.max(1, numberAt(typed, roles.starts) ?? 1);
  if (across === null || lead === null || !(lead > 0) || !(across > 0)) return null;
  const pitch = lead / starts;
  const inside = numberAt(typed, roles.position) === 1;
  let best: FoundThread | null = null;
  const look = (thread: NamedThread) => {
    const side = inside ? "inside" : "outside";
    if (!thread[side] || (thread.side && thread.side !== side)) return;
    const aims: readonly Aim[] = thread[side].tolerance ? ["middle", "basic"] : ["basic"];
    if (typeof valuesOfThread(thread, roles, typed, { aim: "basic", nose: null }) === "string") return;
    for (const aim of aims)
      for (const radius of [null, nose]) {
        const differences = differencesFrom(thread, roles, typed, { aim, nose: radius });
        const wrong = differences.filter(({ q }) => roles.diameters.includes(q) || q === roles.pitch);
        if (wrong.length > 0 || (best && differences.length >= best.differences.length)) continue;
        best = { thread, aim, nose: radius, inside, differences };
      }
  };
  const named = candidates(across, pitch, starts);
  named.forEach(look);
  const isFound = () => best !== null && best.differences.length === 0;
  for (const { name, standard } of named)
    for (const behind of isFound() ? [] : (CLASSES[standard] ?? [])) {
      const thread = readThread(`${name}${behind}`);
      if (thread) look(thread);
    }
  return best;
}

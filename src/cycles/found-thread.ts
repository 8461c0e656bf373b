import type { Aim, NamedThread } from "../kernel/thread/named-thread.ts";
import { readThread, THREAD_STANDARDS } from "../kernel/thread/threads.ts";
import { INCH_ROUNDED } from "../kernel/tolerance.ts";
import { rounded } from "../kernel/units.ts";
import type { ThreadRoles } from "./define.ts";
import { numberAt, valuesOfThread, type ThreadAim, type TypedValues } from "./thread-values.ts";

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

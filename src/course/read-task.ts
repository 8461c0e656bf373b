import { cycleByNumber } from "../cycles/index.ts";
import { areaOf } from "../kernel/area/area.ts";
import { taskSchema, type Task } from "./task.ts";
import { targetPart } from "./target-part.ts";
import { setSchema, type TaskSet } from "./task-set.ts";

/*
 * Reads a task from outside, perhaps written by hand: faults are reported field by field, so that its author can fix
 * them.
 */

/**
 * A fault that keeps a file from being a task. `path`: named as in docs/tasks.md, with the index in a list:
 * "sizes[2].upper".
 */
export interface FieldFault {
  readonly path: string;
  readonly kind: "missing" | "type" | "large" | "small" | "form" | "oneOf" | "count" | "unknown" | "contour";
  /** The required type, the limit, the count, or the allowed values. */
  readonly wanted: string;
}

/** A task with the paths of unknown fields that were left out; or its faults. */
export type ReadTask =
  | { readonly task: Task; readonly left: readonly string[] }
  | { readonly faults: readonly FieldFault[] };

/** A schema issue of one field. */
interface SchemaIssue {
  readonly code?: string | undefined;
  readonly path: readonly PropertyKey[];
  readonly expected?: unknown;
  readonly maximum?: unknown;
  readonly minimum?: unknown;
  readonly values?: readonly unknown[] | undefined;
  readonly errors?: readonly (readonly SchemaIssue[])[] | undefined;
}

/** A path as text: `["sizes", 2, "upper"]` is "sizes[2].upper". */
const written = (path: readonly PropertyKey[]): string =>
  path.reduce<string>(
    (so, key) => (typeof key === "number" ? `${so}[${key}]` : `${so}${so === "" ? "" : "."}${String(key)}`),
    "",
  );

const within = (raw: unknown, path: readonly PropertyKey[]): unknown =>
  path.reduce<unknown>(
    (now, key) => (typeof now === "object" && now !== null ? (now as Record<PropertyKey, unknown>)[key] : undefined),
    raw,
  );

const fault = (path: readonly PropertyKey[], kind: FieldFault["kind"], wanted: unknown = ""): FieldFault => ({
  path: written(path),
  kind,
  wanted: String(wanted),
});

/** Finds the branch of a union that was probably meant: a wrong name weighs more than any number of missing fields. */
const WRONG_NAME = 100;
const weight = (faults: readonly FieldFault[]): number =>
  faults.reduce((sum, { kind }) => sum + (kind === "oneOf" ? WRONG_NAME : 1), 0);

function ofUnion(
  raw: unknown,
  path: readonly PropertyKey[],
  errors: readonly (readonly SchemaIssue[])[],
): readonly FieldFault[] {
  const branches = errors.map((told) =>
    told.flatMap((each) => faultsOf(raw, { ...each, path: [...path, ...each.path] })),
  );
  // All branches require another name at one place: report the allowed names.
  const named = branches.map((each) => each.find(({ kind }) => kind === "oneOf"));
  if (named.every((each) => each !== undefined && each.path === named[0]?.path))
    return [{ path: named[0]?.path ?? "", kind: "oneOf", wanted: named.map((each) => each?.wanted).join(", ") }];
  const least = Math.min(...branches.map(weight)),
    best = branches.filter((each) => weight(each) === least);
  const [first = []] = best,
    all = best.flat();
  if (best.length === 1) return first;
  if (all.every(({ kind }) => kind === "missing")) {
    const names = new Set(all.map(({ path: at }) => at.slice(written(path).length + 1)));
    return [fault(path, "oneOf", [...names].join(", "))];
  }
  return first;
}

function faultsOf(raw: unknown, told: SchemaIssue): readonly FieldFault[] {
  const { code, path, expected, maximum, minimum, values, errors } = told;
  const is = within(raw, path);
  if (code === "invalid_union") return ofUnion(raw, path, errors ?? []);
  if (is === undefined && path.length > 0) return [fault(path, "missing")];
  switch (code) {
    case "invalid_type":
      return [fault(path, "type", expected)];
    case "too_big":
      return [fault(path, "large", maximum)];
    case "too_small":
      return [fault(path, "small", minimum)];
    case "invalid_value":
      return [fault(path, "oneOf", (values ?? []).map(String).join(", "))];
    case "invalid_key":
      return [fault(path, "unknown")];
    default:
      return [fault(path, "form")];
  }
}

/** Paths of fields that a schema dropped. */
function leftOut(raw: unknown, taken: unknown, path: readonly PropertyKey[] = []): readonly string[] {
  if (Array.isArray(raw) && Array.isArray(taken))
    return raw.flatMap((each, i) => leftOut(each, taken[i], [...path, i]));
  if (typeof raw !== "object" || raw === null || typeof taken !== "object" || taken === null) return [];
  return Object.keys(raw).flatMap((key) =>
    Object.hasOwn(taken, key)
      ? leftOut((raw as Record<string, unknown>)[key], (taken as Record<string, unknown>)[key], [...path, key])
      : [written([...path, key])],
  );
}

/** Parameters that the starting cycle does not have, or an unknown cycle. */
function unknownParameters(start: Task["start"]): readonly FieldFault[] {
  if (!("cycle" in start)) return [];
  const cycle = cycleByNumber(start.cycle);
  if (!cycle) return [fault(["start", "cycle"], "unknown")];
  return Object.keys(start.values)
    .filter((q) => !Object.hasOwn(cycle.params, q))
    .map((q) => fault(["start", "values", q], "unknown"));
}

/** Fields of a task that contradict each other. */
function contradictions({ kind, words, predict = [], start, part }: Task): readonly FieldFault[] {
  const told = Object.entries(words).flatMap(([language, said]) => {
    const path = ["words", language],
      { questions = [], choices = [] } = said ?? {};
    return [
      ...(questions.length === predict.length ? [] : [fault([...path, "questions"], "count", predict.length)]),
      ...predict.flatMap((asked, i) => {
        const offered = choices[i]?.length ?? 0;
        if (asked.ask !== "choice") return offered === 0 ? [] : [fault([...path, "choices", i], "count", 0)];
        if (offered < 2) return [fault([...path, "choices", i], "small", 2)];
        return asked.right === undefined || (asked.right >= 0 && asked.right < offered)
          ? []
          : [fault(["predict", i, "right"], "large", offered - 1)];
      }),
    ];
  });
  const wanted = part ? targetPart(part) : null;
  return [
    ...(Object.keys(words).length === 0 ? [fault(["words"], "missing")] : []),
    ...(kind === "predict" && predict.length === 0 ? [fault(["predict"], "missing")] : []),
    ...told,
    ...unknownParameters(start),
    ...(wanted && (wanted.issues.length > 0 || areaOf(wanted.rings) === 0) ? [fault(["part"], "contour")] : []),
  ];
}

/** Reads a task. Never throws on plain data. */
export function readTask(raw: unknown): ReadTask {
  const read = taskSchema.safeParse(raw);
  if (!read.success) return { faults: read.error.issues.flatMap((told) => faultsOf(raw, told as SchemaIssue)) };
  const faults = contradictions(read.data);
  return faults.length > 0 ? { faults } : { task: read.data, left: leftOut(raw, read.data) };
}

/** A set with the paths of unknown fields that were left out; or its faults. */
export type ReadSet =
  | { readonly set: TaskSet; readonly left: readonly string[] }
  | { readonly faults: readonly FieldFault[] };

/** Reads a set: its own fields, and each of its tasks. Never throws on plain data. */
export function readSet(raw: unknown): ReadSet {
  const read = setSchema.safeParse(raw);
  if (!read.success) return { faults: read.error.issues.flatMap((told) => faultsOf(raw, told as SchemaIssue)) };
  const set = read.data;
  const ids = set.tasks.map(({ id }) => id);
  const faults = [
    ...(Object.keys(set.words).length === 0 ? [fault(["words"], "missing")] : []),
    ...(set.tasks.length === 0 ? [fault(["tasks"], "small", 1)] : []),
    ...set.tasks.flatMap((task, i) => [
      ...(ids.indexOf(task.id) < i ? [fault(["tasks", i, "id"], "form")] : []),
      ...contradictions(task).map((each) => ({ ...each, path: `tasks[${i}].${each.path}` })),
    ]),
  ];
  return faults.length > 0 ? { faults } : { set, left: leftOut(raw, set) };
}

/** The format stated in a file; null without one. */
export const formatOf = (raw: unknown): string | null =>
  typeof raw === "object" && raw !== null && "format" in raw && typeof raw.format === "string" ? raw.format : null;

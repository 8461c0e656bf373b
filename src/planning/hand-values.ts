import { cycleByNumber } from "../cycles/index.ts";
import { hasNoEffect } from "../cycles/effect.ts";
import type { Param } from "../cycles/params.ts";
import type { Statement } from "../nc/statement.ts";
import { promptField, readDraft } from "../program/job/read-draft.ts";
import { SETUP_FIELDS } from "../program/job/setup-fields.ts";
import { anyNumber, type Field } from "../program/values/field.ts";
import { positionAsTyped } from "../program/values/typed-value.ts";
import type { Action, HandValues, ReasonedValue } from "./types.ts";

/*
 * Values of an operation that an operator sets: parameters of its cycle by Q, and places of the set-up: "speed", "limit",
 * "feed" of path blocks, "start.x" (⌀) and "start.z". mm, mm/rev, m/min or rpm as the program has them.
 */

/** Where a value of an operation is stored: it is a number there, or missing. */
interface Place {
  readonly field: Field;
  readonly read: (action: Action) => number | null;
  readonly write: (action: Action, value: number) => Action;
}

/** A value of an operation that can be set. */
export interface SettableValue {
  readonly q: string;
  readonly field: Field;
  readonly value: number;
  /** What was planned, and why; without a reason it follows from the operation. */
  readonly planned: number;
  readonly reason: ReasonedValue | null;
}

const numberOf = (text: string | undefined): number | null => {
  const n = Number(text);
  return text === undefined || text.trim() === "" || Number.isNaN(n) ? null : n;
};

const withJob = (action: Action, change: Partial<Action["job"]>): Action => ({
  ...action,
  job: { ...action.job, ...change },
});

/** A member of the spindle or of the start point. */
const spindlePlace = (of: (action: Action) => "speed" | "cuttingSpeed" | "limit"): Place => ({
  field: SETUP_FIELDS.speed,
  read: (action) => numberOf(action.job.spindle[of(action)]),
  write: (action, n) => withJob(action, { spindle: { ...action.job.spindle, [of(action)]: String(n) } }),
});
const startPlace = (axis: "x" | "z", field: Field): Place => ({
  field,
  // Path blocks contain their start.
  read: ({ cut, job }) => (cut ? null : numberOf(job.start[axis])),
  write: (action, n) => withJob(action, { start: { ...action.job.start, [axis]: positionAsTyped(n) } }),
});

/** A block with another feed in place of one that is a number; unchanged where it has none, or not this one. */
function withFeed(s: Statement, before: number | null, value: number): Statement {
  if (s.kind !== "path" || typeof s.words.feed !== "object" || s.words.feed.value !== before) return s;
  return { ...s, words: { ...s.words, feed: { ...s.words.feed, value } } };
}

/** The feed of path blocks: the first one, and those that are the same. */
const feedPlace: Place = {
  field: { ...anyNumber, id: "feed", kind: "feed", range: [Number.MIN_VALUE, Infinity], optional: false },
  read({ cut = [] }) {
    const feeds = cut.flatMap((s) => (s.kind === "path" && typeof s.words.feed === "object" ? s.words.feed.value : []));
    return feeds.find((f) => typeof f === "number") ?? null;
  },
  write(action, value) {
    const before = this.read(action);
    return action.cut ? { ...action, cut: action.cut.map((s) => withFeed(s, before, value)) } : action;
  },
};

const SETUP: Readonly<Record<string, Place>> = {
  speed: spindlePlace(({ job }) => (job.spindle.mode === "constant" ? "speed" : "cuttingSpeed")),
  limit: {
    ...spindlePlace(() => "limit"),
    read: ({ job: { spindle } }) => (spindle.mode === "constant" ? null : numberOf(spindle.limit)),
  },
  feed: feedPlace,
  "start.x": startPlace("x", SETUP_FIELDS.startX),
  "start.z": startPlace("z", SETUP_FIELDS.startZ),
};

/** The prompt of a turning cycle. */
const promptPlace = (q: string, param: Param): Place => ({
  field: promptField(q, param),
  read: ({ job }) => numberOf(job.drafts[job.cycle]?.[q]),
  write: (action, n) => {
    const { drafts, cycle } = action.job;
    return withJob(action, { drafts: { ...drafts, [cycle]: { ...drafts[cycle], [q]: String(n) } } });
  },
});

/** A parameter of a cycle among the blocks of an operation. */
const parameterPlace = (q: string): Place => ({
  field: { ...anyNumber, id: q, range: [Number.MIN_VALUE, Infinity], optional: false },
  read({ cut = [] }) {
    const all = cut.flatMap((s) => (s.kind === "cycle" ? s.parameters : []));
    const value = all.find((p) => p.q === q)?.value;
    return typeof value === "number" ? value : null;
  },
  write: (action, value) =>
    action.cut
      ? {
          ...action,
          cut: action.cut.map((s) =>
            s.kind === "cycle" ? { ...s, parameters: s.parameters.map((p) => (p.q === q ? { ...p, value } : p)) } : s,
          ),
        }
      : action,
});

function placeOf({ cut, cycle }: Action, q: string): Place | null {
  if (Object.hasOwn(SETUP, q)) return SETUP[q] ?? null;
  if (cut) return parameterPlace(q);
  const param = cycle === null ? undefined : cycleByNumber(cycle)?.params[q];
  return param && !param.reserved ? promptPlace(q, param) : null;
}

const written = (action: Action, values: HandValues): Action =>
  Object.entries(values).reduce((made, [q, n]) => placeOf(made, q)?.write(made, n) ?? made, action);

/** An operation as it was planned. */
function asPlanned({ planned, ...action }: Action): Action {
  return planned ? written(action, planned) : action;
}

/** An operation with exactly these values set by hand; those that it does not have are left out. */
export function withHandValues(action: Action, set: HandValues): Action {
  const own = asPlanned(action);
  const planned = Object.fromEntries(
    Object.keys(set).flatMap((q) => {
      const value = placeOf(own, q)?.read(own) ?? null;
      return value === null ? [] : [[q, value] as const];
    }),
  );
  const known = Object.fromEntries(Object.entries(set).filter(([q]) => q in planned));
  return Object.keys(planned).length === 0 ? own : { ...written(own, known), planned };
}

/** The values of an operation that were set by hand. */
export function handValuesOf(action: Action): HandValues {
  const all = Object.keys(action.planned ?? {}).map((q) => [q, placeOf(action, q)?.read(action) ?? 0] as const);
  return Object.fromEntries(all);
}

/** The values of an operation that can be set: first those with a reason, then those of its set-up and its cycle. */
export function settableValues(action: Action): readonly SettableValue[] {
  const { job, cut, values } = action;
  const cycle = cut || action.cycle === null ? undefined : cycleByNumber(action.cycle);
  const partial = cycle ? readDraft(cycle, job.drafts[job.cycle] ?? {}).partial : {};
  const own = Object.entries<Param>(cycle?.params ?? {}).flatMap(([q, param]) =>
    hasNoEffect(param, partial) ? [] : [q],
  );
  const all = new Set([...values.map(({ q }) => q), ...Object.keys(SETUP), ...own]);
  return [...all].flatMap((q) => {
    const place = placeOf(action, q),
      value = place?.read(action) ?? null;
    if (!place || value === null) return [];
    const reason = values.find((each) => each.q === q) ?? null;
    return [{ q, field: place.field, value, planned: action.planned?.[q] ?? value, reason }];
  });
}

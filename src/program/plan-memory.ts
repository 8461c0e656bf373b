import type { Cycle } from "../cycles/define.ts";

/** Remembers what cycles make of values from one run to the next: the same question has the same answer. */
export interface PlanMemory {
  /** The cycle, whose plans and outlines are made once. */
  of(cycle: Cycle): Cycle;
  /** Another run begins: what the one before has not asked for is forgotten. */
  next(): void;
}

/** Begins to remember. Questions are told apart by their values, written as JSON. */
export function planMemory(): PlanMemory {
  let [now, before] = [new Map<string, unknown>(), new Map<string, unknown>()];
  const once = <Asked extends readonly unknown[], Answer>(name: string, make: (...asked: Asked) => Answer) => (...asked: Asked): Answer => {
    const key = `${name} ${JSON.stringify(asked)}`;
    const known = now.has(key) ? now.get(key) : before.has(key) ? before.get(key) : make(...asked);
    now.set(key, known);
    return known as Answer;
  };
  const cycles = new WeakMap<Cycle, Cycle>();
  return {
    of(cycle) {
      const known = cycles.get(cycle)
        ?? { ...cycle, plan: once(`plan ${cycle.number}`, cycle.plan), outline: once(`outline ${cycle.number}`, cycle.outline) };
      cycles.set(cycle, known);
      return known;
    },
    next() {
      [now, before] = [new Map(), now];
    },
  };
}

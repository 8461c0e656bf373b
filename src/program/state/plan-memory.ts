import type { Cycle } from "../../cycles/define.ts";

/** Remembers what is made of values from one run to the next: the same question has the same answer. */
export interface PlanMemory {
  /** The cycle, whose plans and outlines are made once. */
  of(cycle: Cycle): Cycle;
  /**
   * What is made of a question, which its text tells apart from all others; it is made with a name that no other answer
   * has. `size` says how many objects an answer holds; answers of runs long ago are kept as long as all of them are
   * small.
   */
  once<Answer>(question: string, make: (name: string) => Answer, size?: (answer: Answer) => number): Answer;
  /**
   * What is made of elements that are small and plain: the same object for elements that are alike, as long as it was
   * not long ago.
   */
  alike<Made extends object>(elements: readonly unknown[], make: () => Made): Made;
  /** A value that never changes, as the same object each time: the first that was written as this one is. */
  same<Value extends object>(value: Value): Value;
  /** What stands for such a value in questions. */
  nameOf(value: object): string;
  /** How many different answers this run has asked for. */
  asked(): number;
  /** A run that goes on from where the one before had asked for so many answers: they count as asked for. */
  again(count: number): void;
  /**
   * Another run begins. What the one before has asked for is kept in any case, older answers within bounds: steps are
   * taken back.
   */
  next(): void;
}

/** What was made of elements last, the newest last. */
interface Made {
  readonly elements: readonly unknown[];
  readonly made: object;
}

/**
 * Lists of elements whose result is remembered: a program has few contours that are as many blocks as a key waits for.
 */
const MOST_MADE = 12;

/** A list with more entries is written once, and called by its name from then on. */
const LONG_LIST = 50;

/** Whether two plain values hold the same. */
function holdSame(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) return false;
  const keys = Object.keys(a);
  if (keys.length !== Object.keys(b).length) return false;
  return keys.every(
    (key) => key in b && holdSame((a as Record<string, unknown>)[key], (b as Record<string, unknown>)[key]),
  );
}

interface Named {
  readonly value: object;
  readonly name: string;
}

interface Kept {
  readonly answer: unknown;
  readonly size: number;
  /** The run that asked for it last. */
  run: number;
}

/** Runs after which an answer that nobody asked for is forgotten, and what all answers together may hold, objects. */
const [MOST_RUNS, MOST_KEPT] = [20, 250_000];

/** A number as JSON, in which −0 is another one than 0. */
export const exactly = (n: number): string => (Object.is(n, -0) ? "-0" : String(n));

/** Begins to remember. Questions to cycles are told apart by their values, written as JSON. */
export function planMemory(): PlanMemory {
  /** The answer that was asked for longest ago comes first. */
  const kept = new Map<string, Kept>();
  const named = new WeakMap<object, Named>();
  const cycles = new WeakMap<Cycle, Cycle>();
  let [run, held, names] = [0, 0, 0];
  /** What this run has asked, and the one before, in that order. */
  let [asking, former]: [string[], readonly string[]] = [[], []];

  /** An answer that this run asks for, unless it has done so before. */
  const touch = (question: string, known: Kept): void => {
    if (known.run === run) return;
    known.run = run;
    kept.delete(question);
    kept.set(question, known);
    asking.push(question);
  };

  const once: PlanMemory["once"] = <Answer>(
    question: string,
    make: (name: string) => Answer,
    size: (answer: Answer) => number = () => 1,
  ): Answer => {
    const known = kept.get(question);
    if (known) {
      touch(question, known);
      return known.answer as Answer;
    }
    names += 1;
    const answer = make(`#${names}`);
    const made = { answer, size: size(answer), run };
    held += made.size;
    kept.set(question, made);
    asking.push(question);
    return answer;
  };
  const first = (value: object): Named => {
    const known = named.get(value) ?? once(`value ${JSON.stringify(value)}`, (name) => ({ value, name }));
    named.set(value, known);
    return known;
  };
  /** In a question a long list, as a contour is one, stands by its name. */
  const shortened = (_: string, value: unknown): unknown =>
    Array.isArray(value) && value.length > LONG_LIST ? first(value).name : value;
  const askedOf =
    <Asked extends readonly unknown[], Answer>(name: string, make: (...values: Asked) => Answer) =>
    (...values: Asked): Answer =>
      once(`${name} ${JSON.stringify(values, shortened)}`, () => make(...values));
  let made: readonly Made[] = [];
  return {
    alike: <Answer extends object>(elements: readonly unknown[], make: () => Answer): Answer => {
      const known = made.find((each) => each.elements.length === elements.length && holdSame(each.elements, elements));
      const answer = (known?.made as Answer | undefined) ?? make();
      made = [...made.filter((each) => each !== known).slice(1 - MOST_MADE), known ?? { elements, made: answer }];
      return answer;
    },
    of(cycle) {
      const known = cycles.get(cycle) ?? {
        ...cycle,
        plan: askedOf(`plan ${cycle.number}`, cycle.plan),
        outline: askedOf(`outline ${cycle.number}`, cycle.outline),
      };
      cycles.set(cycle, known);
      return known;
    },
    once,
    same: <Value extends object>(value: Value) => first(value).value as Value,
    nameOf: (value) => first(value).name,
    asked: () => asking.length,
    again(count) {
      for (const question of former.slice(0, count)) {
        const known = kept.get(question);
        if (known) touch(question, known);
      }
    },
    next() {
      for (const [question, answer] of kept) {
        if (answer.run === run || (answer.run > run - MOST_RUNS && held <= MOST_KEPT)) break;
        kept.delete(question);
        held -= answer.size;
      }
      run += 1;
      [asking, former] = [[], asking];
    },
  };
}

/** About what an object of an answer takes in memory, and what all answers may take together, bytes. */
const [OBJECT, MOST] = [150, 50_000_000];

/** A list with more entries is written out once, and stands by its name in other questions. */
const LONG_LIST = 50;

interface Kept {
  readonly answer: unknown;
  readonly bytes: number;
}

/**
 * Remembers what pure functions gave: the same question has the same answer, as the same object. A question is text
 * that holds everything the answer depends on. When all of them take too much memory, those that were asked for longest
 * ago are forgotten.
 */
export class Answers {
  /** The answer that was asked for longest ago comes first. */
  private readonly kept = new Map<string, Kept>();
  private readonly values = new WeakMap<object, { readonly first: object; readonly name: string }>();
  private readonly labels = new WeakMap<object, string>();
  private bytes = 0;
  private count = 0;

  constructor(private readonly most = MOST) {}

  /** `size`: how many objects an answer holds. */
  once<Answer>(question: string, make: () => Answer, size: (answer: Answer) => number = () => 1): Answer {
    const known = this.kept.get(question);
    if (known) {
      this.kept.delete(question);
      this.kept.set(question, known);
      return known.answer as Answer;
    }
    const answer = make(),
      bytes = question.length + OBJECT * size(answer);
    this.kept.set(question, { answer, bytes });
    this.bytes += bytes;
    for (const [oldest, { bytes: freed }] of this.kept) {
      if (this.bytes <= this.most || oldest === question) break;
      this.kept.delete(oldest);
      this.bytes -= freed;
    }
    return answer;
  }

  /** A plain value that never changes, as the first object that was equal to it. */
  same<Value extends object>(value: Value): Value {
    return this.known(value).first as Value;
  }

  /** What stands for a plain value in questions: equal values have the same name. */
  nameOf(value: object): string {
    return this.known(value).name;
  }

  /** What stands for an object in questions: each object has a label of its own, whatever it holds. */
  labelOf(value: object): string {
    const label = this.labels.get(value) ?? this.next();
    this.labels.set(value, label);
    return label;
  }

  /** A plain value as text, in which −0 differs from 0. */
  written(value: unknown): string {
    return JSON.stringify(value, (_, each: unknown) => {
      if (Array.isArray(each) && each !== value && each.length > LONG_LIST) return this.nameOf(each);
      return Object.is(each, -0) ? "-0" : each;
    });
  }

  private known(value: object) {
    const known =
      this.values.get(value) ?? this.once(`value ${this.written(value)}`, () => ({ first: value, name: this.next() }));
    this.values.set(value, known);
    return known;
  }

  private next(): string {
    this.count += 1;
    return `#${this.count}`;
  }
}

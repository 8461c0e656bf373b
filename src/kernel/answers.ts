/** About what an object of an answer takes in memory, bytes. */
const OBJECT = 150;
/**
 * What all answers may take together, bytes, and how many times what the largest run has asked for: an edit at the end
 * of a long program must not cost the answers of its beginning.
 */
const [MOST, RUNS] = [1_000_000, 2];

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
  /** Bytes that this run has asked for, and the most that one has. */
  private asked = 0;
  private largest = 0;

  constructor(private readonly most = MOST) {}

  /** `size`: how many objects an answer holds. */
  once<Answer>(question: string, make: () => Answer, size: (answer: Answer) => number = () => 1): Answer {
    const known = this.kept.get(question);
    if (known) {
      this.asked += known.bytes;
      this.kept.delete(question);
      this.kept.set(question, known);
      return known.answer as Answer;
    }
    const answer = make(),
      bytes = question.length + OBJECT * size(answer);
    this.kept.set(question, { answer, bytes });
    this.bytes += bytes;
    this.asked += bytes;
    const most = this.most + RUNS * Math.max(this.largest, this.asked);
    for (const [oldest, { bytes: freed }] of this.kept) {
      if (this.bytes <= most || oldest === question) break;
      this.kept.delete(oldest);
      this.bytes -= freed;
    }
    return answer;
  }

  /** A run has come to its end: what it asked for is known together. */
  runEnded(): void {
    this.largest = Math.max(this.largest, this.asked);
    this.asked = 0;
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

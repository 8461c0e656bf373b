/** Approximate memory of one object of an answer, bytes. */
const OBJECT = 150;
/**
 * Memory of all answers together, bytes, plus this many times the memory of the largest run: an edit at the end of a
 * long program must not evict the answers of its beginning.
 */
const [MOST, RUNS] = [1_000_000, 2];

/** A longer list is serialized once; other questions contain its name instead. */
const LONG_LIST = 50;

interface CachedAnswer {
  readonly answer: unknown;
  readonly bytes: number;
}

/**
 * Caches the results of pure functions: the same question returns the same object. A question is text that contains
 * everything the answer depends on. Above the memory limit, the least recently used answers are dropped.
 */
export class AnswerCache {
  /** Least recently used first. */
  private readonly entries = new Map<string, CachedAnswer>();
  private readonly values = new WeakMap<object, { readonly first: object; readonly name: string }>();
  private readonly labels = new WeakMap<object, string>();
  private bytes = 0;
  private count = 0;
  /** Bytes used by the current run, and by the largest run. */
  private runBytes = 0;
  private largest = 0;

  constructor(private readonly most = MOST) {}

  /** Cached answer to `question`, else the result of `make`. `size`: number of objects in an answer. */
  cached<Answer>(question: string, make: () => Answer, size: (answer: Answer) => number = () => 1): Answer {
    const known = this.entries.get(question);
    if (known) {
      this.runBytes += known.bytes;
      this.entries.delete(question);
      this.entries.set(question, known);
      return known.answer as Answer;
    }
    const answer = make(),
      bytes = question.length + OBJECT * size(answer);
    this.entries.set(question, { answer, bytes });
    this.bytes += bytes;
    this.runBytes += bytes;
    const most = this.most + RUNS * Math.max(this.largest, this.runBytes);
    for (const [oldest, { bytes: freed }] of this.entries) {
      if (this.bytes <= most || oldest === question) break;
      this.entries.delete(oldest);
      this.bytes -= freed;
    }
    return answer;
  }

  /** Ends a run, so that its total memory can be compared with the largest run. */
  runEnded(): void {
    this.largest = Math.max(this.largest, this.runBytes);
    this.runBytes = 0;
  }

  /** The first object that was equal to this plain, immutable value. */
  canonical<Value extends object>(value: Value): Value {
    return this.known(value).first as Value;
  }

  /** Name of a plain value in questions: equal values have the same name. */
  nameOf(value: object): string {
    return this.known(value).name;
  }

  /** Label of an object in questions: each object has its own, whatever it contains. */
  labelOf(value: object): string {
    const label = this.labels.get(value) ?? this.next();
    this.labels.set(value, label);
    return label;
  }

  /** A plain value as text, in which −0 differs from 0. */
  serialized(value: unknown): string {
    return JSON.stringify(value, (_, each: unknown) => {
      if (Array.isArray(each) && each !== value && each.length > LONG_LIST) return this.nameOf(each);
      return Object.is(each, -0) ? "-0" : each;
    });
  }

  private known(value: object) {
    const known =
      this.values.get(value) ??
      this.cached(`value ${this.serialized(value)}`, () => ({ first: value, name: this.next() }));
    this.values.set(value, known);
    return known;
  }

  private next(): string {
    this.count += 1;
    return `#${this.count}`;
  }
}

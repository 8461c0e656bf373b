/* Collections that never change: one that is added to is another one, and both share what they have in common. */

/** A value of its own that is changed, until it is as it stays. */
export type Changing<State> = { -readonly [Key in keyof State]: State[Key] };

/** Items that lists share; none is added any more once they were handed out. */
interface Shared<T> {
  readonly items: T[];
  isHandedOut?: true;
}

/** A list that is only added to. Lists that have grown from one another share their items. */
export class Grown<T> {
  constructor(
    private readonly shared: Shared<T> = { items: [] },
    readonly length = 0,
  ) {}

  get last(): T | undefined {
    return this.shared.items[this.length - 1];
  }

  with(item: T): Grown<T> {
    return this.withAll([item]);
  }

  withAll(added: readonly T[]): Grown<T> {
    const { items, isHandedOut } = this.shared;
    // Where another list has grown from this one already, the items behind it are not of this one.
    const isOwn = items.length === this.length && !isHandedOut;
    const shared = isOwn ? this.shared : { items: items.slice(0, this.length) };
    for (const item of added) shared.items.push(item);
    return new Grown(shared, shared.items.length);
  }

  withoutLast(): Grown<T> {
    return new Grown(this.shared, Math.max(0, this.length - 1));
  }

  /** A copy of the items from one on. */
  slice(from = 0): T[] {
    return this.shared.items.slice(from, this.length);
  }

  /** All items, for those who do not change them. */
  all(): readonly T[] {
    if (this.shared.items.length > this.length) return this.slice();
    this.shared.isHandedOut = true;
    return this.shared.items;
  }
}

/** A set that is only added to, in the order of its values. */
export class GrownSet<T> {
  constructor(
    private readonly order = new Map<T, number>(),
    private readonly size = 0,
  ) {}

  has(value: T): boolean {
    const at = this.order.get(value);
    return at !== undefined && at < this.size;
  }

  with(value: T): GrownSet<T> {
    if (this.has(value)) return this;
    const order = this.order.size === this.size ? this.order : new Map([...this.order].slice(0, this.size));
    order.set(value, this.size);
    return new GrownSet(order, order.size);
  }

  values(): readonly T[] {
    return [...this.order.keys()].slice(0, this.size);
  }
}

/** An entry that was set, or taken away, since a map was copied. */
interface Entry<K, V> {
  readonly key: K;
  readonly value: V | undefined;
  readonly before: Entry<K, V> | null;
  readonly count: number;
}

/** Entries that are looked through one by one; with more of them the map is copied. */
const MOST_ENTRIES = 32;

/** A map of which some entries change often. */
export class Table<K, V> {
  constructor(
    private readonly base: ReadonlyMap<K, V> = new Map(),
    private readonly since: Entry<K, V> | null = null,
  ) {}

  get(key: K): V | undefined {
    for (let each = this.since; each; each = each.before) if (each.key === key) return each.value;
    return this.base.get(key);
  }

  has(key: K): boolean {
    return this.get(key) !== undefined;
  }

  with(key: K, value: V | undefined): Table<K, V> {
    if (Object.is(this.get(key), value)) return this;
    const made = new Table(this.base, { key, value, before: this.since, count: (this.since?.count ?? 0) + 1 });
    return (made.since?.count ?? 0) < MOST_ENTRIES ? made : new Table(made.toMap());
  }

  toMap(): ReadonlyMap<K, V> {
    const map = new Map(this.base),
      seen = new Set<K>();
    for (let each = this.since; each; each = each.before) {
      if (seen.has(each.key)) continue;
      seen.add(each.key);
      if (each.value === undefined) map.delete(each.key);
      else map.set(each.key, each.value);
    }
    return map;
  }
}

/* Persistent collections: adding returns a new collection that shares its items with the old one. */

/** A writable copy of a state, until it is finished. */
export type Mutable<State> = { -readonly [Key in keyof State]: State[Key] };

/** Items shared by lists; frozen once they were handed out. */
interface Shared<T> {
  readonly items: T[];
  isHandedOut?: true;
}

/** An append-only list. Its versions share their items. */
export class AppendList<T> {
  constructor(
    private readonly shared: Shared<T> = { items: [] },
    readonly length = 0,
  ) {}

  get last(): T | undefined {
    return this.shared.items[this.length - 1];
  }

  with(item: T): AppendList<T> {
    return this.withAll([item]);
  }

  withAll(added: readonly T[]): AppendList<T> {
    const { items, isHandedOut } = this.shared;
    // The items beyond this list's length belong to another version.
    const isOwn = items.length === this.length && !isHandedOut;
    const shared = isOwn ? this.shared : { items: items.slice(0, this.length) };
    for (const item of added) shared.items.push(item);
    return new AppendList(shared, shared.items.length);
  }

  withoutLast(): AppendList<T> {
    return new AppendList(this.shared, Math.max(0, this.length - 1));
  }

  /** A copy of the items from an index on. */
  slice(from = 0): T[] {
    return this.shared.items.slice(from, this.length);
  }

  /** All items without copying; callers must not change them. */
  all(): readonly T[] {
    if (this.shared.items.length > this.length) return this.slice();
    this.shared.isHandedOut = true;
    return this.shared.items;
  }
}

/** An append-only set, in insertion order. */
export class AppendSet<T> {
  constructor(
    private readonly order = new Map<T, number>(),
    private readonly size = 0,
  ) {}

  has(value: T): boolean {
    const at = this.order.get(value);
    return at !== undefined && at < this.size;
  }

  with(value: T): AppendSet<T> {
    if (this.has(value)) return this;
    const order = this.order.size === this.size ? this.order : new Map([...this.order].slice(0, this.size));
    order.set(value, this.size);
    return new AppendSet(order, order.size);
  }

  values(): readonly T[] {
    return [...this.order.keys()].slice(0, this.size);
  }
}

/** An entry set or deleted since the last copy of the map. */
interface Entry<K, V> {
  readonly key: K;
  readonly value: V | undefined;
  readonly before: Entry<K, V> | null;
  readonly count: number;
}

/** Entries searched linearly; beyond this number the map is copied. */
const MOST_ENTRIES = 32;

/** A persistent map with a few frequently changed entries. */
export class PersistentMap<K, V> {
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

  with(key: K, value: V | undefined): PersistentMap<K, V> {
    if (Object.is(this.get(key), value)) return this;
    const made = new PersistentMap(this.base, { key, value, before: this.since, count: (this.since?.count ?? 0) + 1 });
    return (made.since?.count ?? 0) < MOST_ENTRIES ? made : new PersistentMap(made.toMap());
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

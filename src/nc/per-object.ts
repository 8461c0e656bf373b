/** A function that works once for each object: its answers are kept as long as the objects are. */
export function perObject<K extends object, T>(make: (key: K) => T): (key: K) => T {
  const known = new WeakMap<K, { readonly answer: T }>();
  return (key) => {
    const before = known.get(key);
    if (before) return before.answer;
    const answer = make(key);
    known.set(key, { answer });
    return answer;
  };
}

/** Answers by a text that holds what they depend on. */
export type PerText<T> = (text: string, make: () => T) => T;

/** The same by a text: asks `make` once for each. */
export function perText<T>(): PerText<T> {
  const known = new Map<string, { readonly answer: T }>();
  return (text, make) => {
    const before = known.get(text);
    if (before) return before.answer;
    const answer = make();
    known.set(text, { answer });
    return answer;
  };
}

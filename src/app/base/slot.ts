/** A part that a lower room shows and a higher one gives: who shows it knows its shape, and not where it comes from. */
export interface Slot<T> {
  /** What was given; it fails where nothing was. */
  fetch(): Promise<T>;
  /** From now on the part comes from there. */
  fill(fetchPart: () => Promise<T>): void;
}

/** An empty slot. `name` is said where nothing was given. */
export function slot<T>(name: string): Slot<T> {
  let given: () => Promise<T> = () => Promise.reject(new Error(`nothing was given for ${name}`));
  return {
    fetch: () => given(),
    fill: (fetchPart) => {
      given = fetchPart;
    },
  };
}

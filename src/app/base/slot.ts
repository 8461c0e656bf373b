/** A component that a lower layer shows and a higher layer provides: the lower layer knows its type, not its origin. */
export interface Slot<T> {
  /** The provided part; fails if there is none. */
  fetch(): Promise<T>;
  /** Sets where the part comes from. */
  fill(fetchPart: () => Promise<T>): void;
}

/** An empty slot. `name` appears in the error if nothing was provided. */
export function slot<T>(name: string): Slot<T> {
  let given: () => Promise<T> = () => Promise.reject(new Error(`nothing was given for ${name}`));
  return {
    fetch: () => given(),
    fill: (fetchPart) => {
      given = fetchPart;
    },
  };
}

/** Throws, with the values, in a state that no input can cause. Active in production too. */
export function never(why: string, ...seen: unknown[]): never {
  throw new Error(`${why}: ${seen.map(String).join(", ")}`);
}

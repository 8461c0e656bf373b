/** For what cannot happen, whatever the user types. Always on; says the values. */
export function never(why: string, ...seen: unknown[]): never {
  throw new Error(`${why}: ${seen.map(String).join(", ")}`);
}

/** The series R 40 of preferred numbers (ISO 3), in which ISO 965-1 states tolerances. */
const R40 = [
  1, 1.06, 1.12, 1.18, 1.25, 1.32, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2, 2.12, 2.24, 2.36, 2.5, 2.65, 2.8, 3, 3.15, 3.35,
  3.55, 3.75, 4, 4.25, 4.5, 4.75, 5, 5.3, 5.6, 6, 6.3, 6.7, 7.1, 7.5, 8, 8.5, 9, 9.5,
] as const;

/** The number of R 40 nearest to a positive one, and `steps` further; rounded to whole numbers. */
export function preferred(value: number, steps = 0): number {
  const at = (i: number): number => {
    const decade = Math.floor(i / R40.length);
    return (R40[i - decade * R40.length] as number) * 10 ** decade;
  };
  const near = Math.round(Math.log10(value) * R40.length);
  const best = [near - 1, near, near + 1].reduce((a, b) => (Math.abs(at(b) - value) < Math.abs(at(a) - value) ? b : a));
  return Math.round(at(best + steps));
}

/** The series R 40 of preferred numbers (ISO 3), in which ISO 965-1 states tolerances. */
const R40 = [
  100, 106, 112, 118, 125, 132, 140, 150, 160, 170, 180, 190, 200, 212, 224, 236, 250, 265, 280, 300, 315, 335, 355,
  375, 400, 425, 450, 475, 500, 530, 560, 600, 630, 670, 710, 750, 800, 850, 900, 950,
] as const;

/** The number of R 40 nearest to a positive one, and `steps` further; rounded to whole numbers. */
export function preferred(value: number, steps = 0): number {
  const at = (i: number): number => {
    const decade = Math.floor(i / R40.length);
    return (R40[i - decade * R40.length] as number) * 10 ** (decade - 2);
  };
  const near = Math.round(Math.log10(value) * R40.length);
  const best = [near - 1, near, near + 1].reduce((a, b) => (Math.abs(at(b) - value) < Math.abs(at(a) - value) ? b : a));
  return Math.round(at(best + steps));
}

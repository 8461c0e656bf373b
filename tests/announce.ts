/** Prints the seed of the random cases before any test runs, so that a failure can be repeated. */
export default function announce(): void {
  console.log(`LAW_SEED=${process.env["LAW_SEED"]}`);
}

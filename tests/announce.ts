/** Before any test runs: prints the seed of the random cases, so that a failure can be repeated. */
export function setup(): void {
  console.log(`LAW_SEED=${process.env["LAW_SEED"]}`);
}

import type { TestSpecification, Vitest } from "vitest/node";

/** The slowest test files, slowest first. Vitest otherwise starts with the largest files, and these are small. */
const LONGEST = [
  "/tests/course/slips.test.ts",
  "/tests/laws/cut.test.ts",
  "/tests/dimension-laws.test.ts",
  "/tests/planning/missing.test.ts",
  "/tests/help/help.test.ts",
  "/tests/laws/",
];

const rank = ({ moduleId }: TestSpecification): number => {
  const found = LONGEST.findIndex((part) => moduleId.includes(part));
  return found < 0 ? LONGEST.length : found;
};

/**
 * The usual order of test files, but the slowest start first: if they started last, one core would wait for the other.
 */
export class LongestFirst {
  constructor(private readonly run: Vitest) {}

  private async usual() {
    const { BaseSequencer } = await import("vitest/node");
    return new BaseSequencer(this.run);
  }

  async shard(files: TestSpecification[]): Promise<TestSpecification[]> {
    return (await this.usual()).shard(files);
  }

  async sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    const sorted = await (await this.usual()).sort(files),
      projects = new Set(sorted.map(({ project }) => project));
    return [...projects].flatMap((each) =>
      sorted.filter(({ project }) => project === each).sort((a, b) => rank(a) - rank(b)),
    );
  }
}

/** Tests that put another module in the place of one: each file has modules of its own, all others share theirs. */
export const REPLACING: readonly string[] = [
  "src/app/records/device.test.ts",
  "src/features/course/teach/hand-in.test.ts",
  "src/shell/resume.test.ts",
  "tests/made-up/made-up-cycle.test.ts",
];

import { z } from "zod/mini";
import { resultShape } from "../../../course/made/result.ts";
import type { LearnerFile } from "./result-rows.ts";

/** Most files of results that are gathered. */
export const MOST_GATHERED = 500;
const kept = z.object({
  version: z.literal(1),
  files: z.array(z.object({ file: z.string().check(z.maxLength(300)), result: resultShape })).check(z.maxLength(MOST_GATHERED)),
});

/** The text that is kept; null where there is nothing to keep. */
export const writeGathered = (files: readonly LearnerFile[]): string | null =>
  files.length === 0 ? null : JSON.stringify({ version: 1, files });

/** Kept results; null where they are damaged. Never throws. */
export function readGathered(text: string): readonly LearnerFile[] | null {
  try {
    const read = kept.safeParse(JSON.parse(text));
    return read.success ? read.data.files : null;
  } catch {
    return null;
  }
}

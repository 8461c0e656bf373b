import { z } from "zod/mini";
import { resultShape } from "../../../course/made/result.ts";
import { record } from "../../base/record.ts";
import { editRecord } from "../../document/edit-record.ts";
import { isAmong, type LearnerFile } from "./result-rows.ts";

/** Most files of results that are gathered. */
const MOST = 500;
const file = z.object({ file: z.string().check(z.maxLength(300)), result: resultShape });
const NONE: readonly LearnerFile[] = [];

/** The results of learners that were opened on this device, in the order in which they came. */
export const resultRecord = record({
  key: "course-results",
  version: 1,
  schema: z.object({ files: z.array(file).check(z.maxLength(MOST)) }),
  from: ({ files }): readonly LearnerFile[] => files,
  to: (files) => ({ files }),
  first: NONE,
});
export const useGathered = resultRecord.use;

/** Puts results beside those that are there; what goes can be taken back. */
export function gather(files: readonly LearnerFile[]): void {
  if (files.length > 0) resultRecord.put([...resultRecord.now(), ...files].slice(-MOST));
}

/** Lets one file, or all of them, go from the table. */
export const dropGathered = (gone: LearnerFile | null): void =>
  editRecord(resultRecord, (list) => (gone === null ? NONE : list.filter((each) => each !== gone)));

/** Results of another device that are not here beside those that are. */
export const mergedResults = (mine: readonly LearnerFile[], brought: readonly LearnerFile[]): readonly LearnerFile[] =>
  [...mine, ...brought.filter(({ result }) => !isAmong(mine, result))].slice(-MOST);

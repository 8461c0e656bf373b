import { z } from "zod/mini";
import { resultShape } from "../../../course/made/result.ts";
import { record } from "../../base/record.ts";
import { COURSE } from "../../document/documents.ts";
import { editRecord } from "../../document/edit-record.ts";
import { hasResult, type LearnerFile } from "./result-rows.ts";

/** Most files of results in the table. */
const MOST = 500;
const file = z.object({ file: z.string().check(z.maxLength(300)), result: resultShape });
const NONE: readonly LearnerFile[] = [];

/** Learner results opened on this device, in order of arrival. */
export const resultRecord = record({
  key: "course-results",
  version: 1,
  schema: z.object({ files: z.array(file) }),
  rows: { of: "files", each: file, most: MOST },
  from: ({ files }): readonly LearnerFile[] => files,
  to: (files) => ({ files }),
  first: NONE,
  document: COURSE,
});
export const useCollectedResults = resultRecord.use;

/** Adds results; they can be removed again. */
export function collectResults(files: readonly LearnerFile[]): void {
  if (files.length > 0) resultRecord.put([...resultRecord.now(), ...files].slice(-MOST));
}

/** Removes one file, or all, from the table. */
export const removeResults = (gone: LearnerFile | null): void =>
  editRecord(resultRecord, (list) => (gone === null ? NONE : list.filter((each) => each !== gone)));

/** Results of this device, plus the missing ones of another. */
export const mergedResults = (mine: readonly LearnerFile[], brought: readonly LearnerFile[]): readonly LearnerFile[] =>
  [...mine, ...brought.filter(({ result }) => !hasResult(mine, result))].slice(-MOST);

import type { HandedResult } from "../../../course/made/result.ts";
import { collectResults, resultRecord } from "./collected-results.ts";
import { useOpenedCourseFile, type FileLeftOut } from "./opened-course-file.ts";
import { hasResult, type LearnerFile } from "./result-rows.ts";

/** Results of a named file, or why it has none. */
export type NamedResult = { readonly file: string; readonly result: HandedResult } | FileLeftOut;

/** Adds the new results and shows the table with the files left out, each once. Files left out before stay listed. */
export function showResults(come: readonly NamedResult[] = []): void {
  const { shown } = useOpenedCourseFile.getState();
  const list = resultRecord.now();
  const fresh: LearnerFile[] = [],
    leftOut: FileLeftOut[] = shown?.kind === "results" ? [...shown.leftOut] : [];
  for (const one of come) {
    if ("why" in one) leftOut.push(one);
    else if (hasResult([...list, ...fresh], one.result)) leftOut.push({ file: one.file, why: { kind: "twice" } });
    else fresh.push(one);
  }
  collectResults(fresh);
  const known = new Set<string>();
  const each = leftOut.filter((one) => {
    const key = JSON.stringify(one),
      isNew = !known.has(key);
    known.add(key);
    return isNew;
  });
  useOpenedCourseFile.setState({ shown: { kind: "results", leftOut: each } });
}

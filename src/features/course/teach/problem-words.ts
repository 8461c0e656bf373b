import type { FieldFault } from "../../../course/read-task.ts";
import type { CourseFileProblem } from "../../../app/records/course/opened-course-file.ts";
import { LARGEST_TAUGHT } from "./taught-files.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/** Most faults listed. */
const MAX_FAULTS = 10;
const MEGABYTE = 1_000_000;

/** Why a file or a link opens nothing: a sentence, and the fault of each field. */
export function useProblemWords(): (problem: CourseFileProblem) => readonly string[] {
  const { problem: words } = useTexts("course-teach");
  const ofField = ({ path, kind, wanted }: FieldFault): string => {
    if (kind === "type") return words.fault.type(path, words.types[wanted as keyof typeof words.types] ?? wanted);
    return words.fault[kind](path, wanted);
  };
  return (problem) => {
    switch (problem.kind) {
      case "notJson":
        return [problem.line === null ? words.notJson : words.notJsonAt(String(problem.line))];
      case "tooLarge":
        return [words.tooLarge(String(LARGEST_TAUGHT / MEGABYTE))];
      case "fields": {
        const { faults } = problem,
          more = faults.length - MAX_FAULTS;
        return [
          words.fields,
          ...faults.slice(0, MAX_FAULTS).map(ofField),
          ...(more > 0 ? [words.more(String(more))] : []),
        ];
      }
      default:
        return [words[problem.kind]];
    }
  };
}

import { useEditor } from "../../../app/document/store.ts";
import { openText } from "../../../app/fields/open/open-program.ts";
import { useOpenedCourseFile } from "../../../app/records/course/opened-course-file.ts";

/** Opens a learner's program from the table of results, which the line above the program leads back to. */
export function openSubmission(program: string, said: string): void {
  openText(program);
  useOpenedCourseFile.setState({ shown: null, submission: { work: useEditor.getState().work, said } });
}

import { useEditor } from "../../../app/document/store.ts";
import { openText } from "../../../app/fields/open/open-program.ts";
import { viewTask } from "../task/task-view.ts";
import { useOpenedCourseFile } from "../../../app/records/course/opened-course-file.ts";

/** Opens a learner's program from the table of results, which the line above the program leads back to. */
export function openSubmission(program: string, said: string, task: string): void {
  openText(program);
  const { work } = useEditor.getState();
  if (work !== null) viewTask(work);
  useOpenedCourseFile.setState({ shown: null, submission: { work, said, task } });
}

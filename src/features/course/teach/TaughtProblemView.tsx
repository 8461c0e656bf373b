import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { useProblemWords } from "./problem-words.ts";
import type { CourseFileProblem } from "../../../app/records/course/opened-course-file.ts";
import { closeCourseFile } from "../../../app/records/course/opened-course-file.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/** Why a file or a link opens nothing; for a task written by hand, field by field. */
export function TaughtProblemView({ file, problem }: { readonly file: string; readonly problem: CourseFileProblem }) {
  const t = useTexts("course-teach"),
    { problem: words } = t;
  const [why = "", ...faults] = useProblemWords()(problem);
  return (
    <ModalDialog title={file === "" ? words.link : words.file(file)} done={closeCourseFile}>
      <Message role="alert" tone="warning">
        {why}
      </Message>
      {faults.length > 0 && (
        <ul className="taught-faults">
          {faults.map((each, i) => (
            <li key={i}>{each}</li>
          ))}
        </ul>
      )}
      <p className="soft">{words.asBefore}</p>
      <div className="modal-ways">
        <button type="button" className="button primary modal-first" onClick={closeCourseFile}>
          {t.close}
        </button>
      </div>
    </ModalDialog>
  );
}

import { canBegin } from "../../../course/exam.ts";
import type { TaskSet } from "../../../course/task-set.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { time } from "../../../app/base/clock.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { startExam } from "../../../app/records/course/exams.ts";
import { resumeOrStartTask } from "../task/begin.ts";
import { termsOf } from "./exam-words.ts";
import { LearnerFields, useLearnerEntry } from "./LearnerFields.tsx";
import "./teach.css";

/** What applies in an exam, before its clock starts. */
export function ExamStart({ set, done }: { readonly set: TaskSet; readonly done: () => void }) {
  const t = useTexts("course-teach"),
    words = useTexts("course-set");
  const language = useSettings((s) => s.language);
  const isAnonymous = set.exam?.anonymous === true;
  const entry = useLearnerEntry(!isAnonymous);
  const isOpen = canBegin(set, time());
  const [first] = set.tasks;
  return (
    <ModalDialog title={words.exam.title(inScreenLanguage(set.words, language)?.title ?? set.id)} done={done}>
      <ul className="set-terms">
        {termsOf(set, words, language).map((term) => (
          <li key={term}>{term}</li>
        ))}
      </ul>
      {isOpen ? (
        <>
          <p>{words.exam.once}</p>
          <LearnerFields entry={entry} optional={isAnonymous} />
          <div className="modal-ways">
            <button
              type="button"
              className="button primary"
              onClick={() => {
                if (!entry.confirm()) return;
                const { name, group } = entry.learner;
                startExam(set, name, group);
                done();
                if (first) void resumeOrStartTask(first, true);
              }}
            >
              <Icon name="play" /> {words.exam.start}
            </button>
            <button type="button" className="button modal-first" onClick={done}>
              {t.incoming.not}
            </button>
          </div>
        </>
      ) : (
        <Message tone="warning">{words.exam.tooLate}</Message>
      )}
    </ModalDialog>
  );
}

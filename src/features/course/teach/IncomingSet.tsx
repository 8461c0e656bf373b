import { formatNumber } from "../../../i18n/number.ts";
import { isForLearners, type TaskSet } from "../../../course/task-set.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { Message } from "../../../app/base/Message.tsx";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { closeCourseFile, showExamTerms } from "../../../app/records/course/opened-course-file.ts";
import { takeSet, useSavedSets } from "../../../app/records/course/saved-sets.ts";
import { resumeOrStartTask } from "../task/begin.ts";
import { termsOf } from "./exam-words.ts";
import { taughtFile } from "./taught-files.ts";

/** Most fields named at once. */
const MAX_UNKNOWN_FIELDS = 12;

/** A received set, before it is kept: its tasks in order, and what applies. */
export function IncomingSet({ set, left }: { readonly set: TaskSet; readonly left: readonly string[] }) {
  const t = useTexts("course-teach"),
    words = useTexts("course-set");
  const language = useSettings((s) => s.language);
  const known = useSavedSets((s) => s.list.find(({ id }) => id === set.id));
  const isHere = known !== undefined && JSON.stringify(known) === JSON.stringify(set);
  // The instructor opens what was handed out: the copy with the answers must stay.
  const isOwn = known !== undefined && isForLearners(set) && !isForLearners(known);
  const said = inScreenLanguage(set.words, language);
  const keep = () => {
    if (!isOwn) takeSet(set);
    closeCourseFile();
  };
  const [first] = set.tasks;
  return (
    <ModalDialog title={words.incoming.title(said?.title ?? set.id)} done={closeCourseFile}>
      <p>{words.incoming.lead}</p>
      {isOwn && <Message tone="info">{words.incoming.isOwn}</Message>}
      {isHere && <Message tone="info">{words.incoming.isHere}</Message>}
      {left.length > 0 && (
        <Message tone="warning">{t.problem.leftOut(left.slice(0, MAX_UNKNOWN_FIELDS).join(", "))}</Message>
      )}
      {said?.about !== undefined && <p className="taught-ask">{said.about}</p>}
      <ol className="set-order">
        {set.tasks.map((task) => (
          <li key={task.id}>
            {inScreenLanguage(task.words, language)?.title ?? task.id}{" "}
            <span className="soft small">{t.kinds[task.kind]}</span>
          </li>
        ))}
      </ol>
      <section aria-label={words.terms.title}>
        <h3>{words.terms.title}</h3>
        <ul className="set-terms">
          {termsOf(set, words, language).map((term) => (
            <li key={term}>{term}</li>
          ))}
        </ul>
      </section>
      <p className="soft small">{t.kilobytes(formatNumber(language, taughtFile(set).length / 1000, 1))}</p>
      <div className="modal-ways">
        <button
          type="button"
          className="button primary modal-first"
          onClick={() => {
            keep();
            if (set.exam) showExamTerms(set.id);
            else if (first) void resumeOrStartTask(first, true);
          }}
        >
          {set.exam ? words.incoming.keepExam : t.incoming.take}
        </button>
        <button type="button" className="button" onClick={keep}>
          {t.incoming.keep}
        </button>
        <button type="button" className="button" onClick={closeCourseFile}>
          {t.incoming.not}
        </button>
      </div>
    </ModalDialog>
  );
}

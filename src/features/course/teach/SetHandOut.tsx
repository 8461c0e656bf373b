import { useEffect, useMemo, useState } from "react";
import { isForLearners, setForLearners, setInLanguage, type TaskSet } from "../../../course/task-set.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { lessonLanguageOf, SCREEN_LANGUAGES } from "../../../i18n/languages.ts";
import { downloadText } from "../../../app/base/download.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { lazyPart } from "../../../app/base/parts.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { pageAddress } from "../../../app/records/local-address.ts";
import { termsOf } from "./exam-words.ts";
import { LinkBox } from "./LinkBox.tsx";
import { courseTasksIn, setLink, taughtFile } from "./taught-files.ts";
import { takeAnswer } from "../../../app/base/until-gone.ts";

const TaskPaper = lazyPart(async () => ({ default: (await import("./TaskPaper.tsx")).TaskPaper }));

/** The tasks of a set that its link only names, since they are those of the course; null until they are known. */
function useCourseTasksIn({ id, tasks }: TaskSet): ReadonlyMap<string, string> | null {
  const [found, find] = useState<{ readonly in: TaskSet["tasks"]; readonly ids: ReadonlyMap<string, string> } | null>(
    null,
  );
  useEffect(
    () =>
      takeAnswer(
        () => courseTasksIn({ id, tasks }),
        (ids) => find({ in: tasks, ids }),
      ),
    [id, tasks],
  );
  return found?.in === tasks ? found.ids : null;
}

/** What learners are told, and the ways to hand a set out: without what they must not read. */
export function SetHandOut({ set }: { readonly set: TaskSet }) {
  const t = useTexts("course-set"),
    teach = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const [isOnPaper, print] = useState(false);
  const own = lessonLanguageOf(language);
  const [isInOne, speakOne] = useState(false);
  const whole = useMemo(() => setForLearners(set), [set]);
  const given = useMemo(() => (isInOne ? setInLanguage(whole, own) : whole), [whole, isInOne, own]);
  const ofCourse = useCourseTasksIn(set);
  // The link of a task of the course is as short in all languages.
  const isManifold = whole.tasks.some(
    ({ id, words }) => !ofCourse?.has(id) && Object.values(words).filter(Boolean).length > 1,
  );
  const title = inScreenLanguage(set.words, language)?.title ?? set.id;
  const isStripped = JSON.stringify(whole) !== JSON.stringify(set);
  return (
    <section className="teach-shown" aria-label={teach.handOut}>
      <h3>{t.terms.told}</h3>
      <ul className="set-terms">
        {termsOf(set, t, language).map((term) => (
          <li key={term}>{term}</li>
        ))}
      </ul>
      <h3>{teach.handOut}</h3>
      {set.tasks.length === 0 ? (
        <Message tone="info">{t.noTasks}</Message>
      ) : (
        <>
          <p>{isStripped || isForLearners(set) ? (set.exam ? t.withoutExam : t.without[set.help]) : t.withAnswers}</p>
          {isStripped && ofCourse !== null && ofCourse.size > 0 && <Message tone="info">{t.courseHasAnswers}</Message>}
          {isManifold && (
            <label className="teach-check">
              <input type="checkbox" checked={isInOne} onChange={() => speakOne(!isInOne)} />
              {t.onlyIn(SCREEN_LANGUAGES[own].name)}
            </label>
          )}
          {ofCourse && (
            <LinkBox
              link={setLink(pageAddress(), given, ofCourse)}
              name={title}
              file={{ name: `${set.id}.turnwise-set.json`, text: taughtFile(given), label: teach.saveTask }}
            />
          )}
          <div className="modal-ways">
            <button type="button" className="button" aria-haspopup="dialog" onClick={() => print(true)}>
              <Icon name="print" /> {t.paper.open}
            </button>
            {isStripped && (
              <button
                type="button"
                className="button"
                onClick={() => downloadText(taughtFile(set), `${set.id}-${t.answersFile}.turnwise-set.json`)}
              >
                <Icon name="download" /> {t.saveOwn}
              </button>
            )}
          </div>
          {isStripped && <p className="soft small">{t.saveOwnHint}</p>}
        </>
      )}
      {isOnPaper && <TaskPaper set={set} tasks={set.tasks} done={() => print(false)} />}
    </section>
  );
}

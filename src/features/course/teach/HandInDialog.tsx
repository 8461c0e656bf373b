import { useEffect, useState } from "react";
import type { Exam } from "../../../course/exam.ts";
import { progressOfTask, stateOfTask } from "../../../course/progress.ts";
import type { HandedResult } from "../../../course/made/result.ts";
import type { TaskSet } from "../../../course/task-set.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { useCourseIndex } from "../../../app/records/course/content.ts";
import { useExams } from "../../../app/records/course/exams.ts";
import { useLearning } from "../../../app/records/course/progress.ts";
import { useSavedSets } from "../../../app/records/course/saved-sets.ts";
import { examStateText } from "./exam-words.ts";
import { finishExam } from "./exam-watch.ts";
import { resultsToHandIn } from "./hand-in.ts";
import { pageAddress } from "../../../app/records/local-address.ts";
import { LinkBox } from "./LinkBox.tsx";
import { resultLink, taughtFile } from "./taught-files.ts";
import { useSavedTasks } from "../../../app/records/course/saved-tasks.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { LearnerFields, useLearnerEntry } from "./LearnerFields.tsx";
import { takeAnswer } from "../../../app/base/until-gone.ts";
import "./teach.css";

/** A name, made safe for a file name. */
const fileNamePart = (name: string): string =>
  name
    .trim()
    .replace(/[^\p{L}\p{N}]+/gu, "-")
    .replace(/^-|-$/g, "")
    .slice(0, 40) || "results";

interface Props {
  readonly set?: TaskSet | undefined;
  /** The one task that is chosen first; by default all. */
  readonly task?: string | undefined;
  readonly done: () => void;
}

/** Hands in results: of a set, of an exam, or of the tasks that the learner chooses. */
export function HandInDialog({ set, task, done }: Props) {
  const exam = useExams(({ list }) => (set ? list[set.id] : undefined));
  return exam ? <HandInExam exam={exam} done={done} /> : <HandInTasks set={set} task={task} done={done} />;
}

/** The ways to give a result to the instructor. */
function HandOver({ result, before }: { readonly result: HandedResult; readonly before?: () => void }) {
  const t = useTexts("course-teach");
  const name = fileNamePart(result.name);
  return (
    <LinkBox
      link={resultLink(pageAddress(), result)}
      name={t.results.title(result.name)}
      {...(before && { before })}
      file={{ name: `${name}.turnwise-result.json`, text: taughtFile(result), label: t.hand.save }}
    />
  );
}

/** Hands in an exam: what counts is what there is now, or was when it ended. */
function HandInExam({ exam, done }: { readonly exam: Exam; readonly done: () => void }) {
  const t = useTexts("course-teach"),
    words = useTexts("course-set");
  const language = useSettings((s) => s.language);
  const isAnonymous = exam.set.exam?.anonymous === true;
  const entry = useLearnerEntry(!isAnonymous, exam);
  const [ends, end] = useState(false);
  const { ended } = exam;
  return (
    <ModalDialog title={t.hand.title} done={done}>
      {ended ? (
        <>
          <Message role="status" tone="info">
            {examStateText(exam, words, language)}
          </Message>
          <p>{words.exam.giveIt}</p>
          <HandOver result={ended.result} />
        </>
      ) : (
        <>
          <p>{words.exam.lead}</p>
          <LearnerFields entry={entry} optional={isAnonymous} />
          <div className="modal-ways">
            <button
              type="button"
              className="button primary"
              aria-disabled={ends}
              onClick={() => {
                if (ends || !entry.confirm()) return;
                end(true);
                void finishExam(exam, "learner", entry.learner);
              }}
            >
              {ends ? t.hand.making : words.exam.end}
            </button>
            <button type="button" className="button" onClick={done}>
              {words.exam.goOn}
            </button>
          </div>
        </>
      )}
    </ModalDialog>
  );
}

/** The tasks that can be handed in: those of a set, or all that were begun. */
function useNamedTasks(set: TaskSet | undefined) {
  const language = useSettings((s) => s.language);
  const progress = useLearning((s) => s.list);
  const own = useSavedTasks((s) => s.list);
  const sets = useSavedSets((s) => s.list);
  const { lessons } = useCourseIndex();
  const titled = (tasks: TaskSet["tasks"] | typeof own) =>
    tasks.map(({ id, words }) => ({ id, title: inScreenLanguage(words, language)?.title ?? id }));
  if (set) return titled(set.tasks);
  const others = sets.filter(({ exam }) => !exam).flatMap(({ tasks }) => tasks);
  return [...titled(own), ...titled(others), ...lessons.flatMap(({ tasks }) => tasks)].filter(
    ({ id }) => stateOfTask(progressOfTask(progress, id)) !== "new",
  );
}

function HandInTasks({ set, task, done }: Props) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const progress = useLearning((s) => s.list);
  const begun = useNamedTasks(set);
  const [left, leave] = useState<readonly string[]>(() =>
    task === undefined ? [] : begun.map(({ id }) => id).filter((id) => id !== task),
  );
  const entry = useLearnerEntry(false);
  const { name, group } = entry.learner;
  const [made, make] = useState<{ readonly key: string; readonly result: HandedResult } | null>(null);
  const ids = begun.map(({ id }) => id).filter((id) => !left.includes(id)),
    key = ids.join(" ");
  useEffect(() => {
    const chosen = key.split(" ").filter((id) => id !== "");
    return takeAnswer(
      () => resultsToHandIn(chosen, { name: "", group: "" }, progress, language, { set }),
      (result) => make({ key, result }),
    );
  }, [key, progress, language, set]);
  const result =
    made?.key === key
      ? { ...made.result, name: name.trim(), ...(group.trim() !== "" && { group: group.trim() }) }
      : null;
  return (
    <ModalDialog title={t.hand.title} done={done}>
      <p>{t.hand.lead}</p>
      <p>{t.hand.noProof}</p>
      {begun.length === 0 ? (
        <Message tone="info">{t.hand.none}</Message>
      ) : (
        <>
          <LearnerFields entry={entry} optional />
          <div role="group" aria-label={t.hand.choose} className="teach-list">
            {begun.map(({ id, title }) => (
              <label key={id} className="teach-check">
                <input
                  type="checkbox"
                  checked={!left.includes(id)}
                  onChange={() => leave((now) => (now.includes(id) ? now.filter((each) => each !== id) : [...now, id]))}
                />
                {title}
              </label>
            ))}
          </div>
          {!result && (
            <p role="status" className="soft">
              {t.hand.making}
            </p>
          )}
          {result && ids.length > 0 && <HandOver result={result} before={() => void entry.confirm()} />}
        </>
      )}
    </ModalDialog>
  );
}

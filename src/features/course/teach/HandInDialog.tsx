import { useEffect, useState } from "react";
import { progressOfTask, stateOfTask } from "../../../course/progress.ts";
import type { HandedResult } from "../../../course/made/result.ts";
import { downloadText } from "../../../app/base/download.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { inScreenLanguage } from "../../../course/words.ts";
import { useCourseIndex } from "../../../app/records/course/content.ts";
import { useLearning } from "../../../app/records/course/progress.ts";
import { resultsToHandIn } from "./hand-in.ts";
import { pageAddress } from "../../../app/records/local-address.ts";
import { LinkBox } from "./LinkBox.tsx";
import { resultLink, taughtFile } from "./taught-files.ts";
import { useSavedTasks } from "../../../app/records/course/saved-tasks.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { TeachText } from "./WordFields.tsx";
import "./teach.css";

/** A name, made safe for a file name. */
const fileNamePart = (name: string): string =>
  name
    .trim()
    .replace(/[^\p{L}\p{N}]+/gu, "-")
    .replace(/^-|-$/g, "")
    .slice(0, 40) || "results";

/** Collects the results of tasks in a file or a link, to hand in. */
export function HandInDialog({ done }: { readonly done: () => void }) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const progress = useLearning((s) => s.list);
  const own = useSavedTasks((s) => s.list);
  const { lessons } = useCourseIndex();
  const named = [
    ...own.map(({ id, words }) => ({ id, title: inScreenLanguage(words, language)?.title ?? id })),
    ...lessons.flatMap(({ tasks }) => tasks),
  ];
  const begun = named.filter(({ id }) => stateOfTask(progressOfTask(progress, id)) !== "new");
  const [left, leave] = useState<readonly string[]>([]);
  const [name, call] = useState("");
  const [made, make] = useState<{ readonly key: string; readonly result: HandedResult } | null>(null);
  const ids = begun.map(({ id }) => id).filter((id) => !left.includes(id)),
    key = ids.join(" ");
  useEffect(() => {
    let gone = false;
    void resultsToHandIn(
      key.split(" ").filter((id) => id !== ""),
      "",
      progress,
      language,
    ).then((result) => {
      if (!gone) make({ key, result });
    });
    return () => {
      gone = true;
    };
  }, [key, progress, language]);
  const result = made?.key === key ? { ...made.result, name: name.trim() } : null;
  return (
    <ModalDialog title={t.hand.title} done={done}>
      <p>{t.hand.lead}</p>
      <p>{t.hand.noProof}</p>
      {begun.length === 0 ? (
        <Message tone="info">{t.hand.none}</Message>
      ) : (
        <>
          <TeachText label={t.hand.name} value={name} change={call} />
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
          {result && ids.length > 0 && (
            <>
              <div className="modal-ways">
                <button
                  type="button"
                  className="button primary"
                  onClick={() => downloadText(taughtFile(result), `${fileNamePart(name)}.turnwise-result.json`)}
                >
                  <Icon name="download" /> {t.hand.save}
                </button>
              </div>
              <LinkBox link={resultLink(pageAddress(), result)} />
            </>
          )}
        </>
      )}
    </ModalDialog>
  );
}

import { useState } from "react";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { recorded, undo, useIsLastStep, type HistoryStep } from "../../../app/document/steps.ts";
import { removeResults } from "../../../app/records/course/collected-results.ts";
import { useProblemWords } from "./problem-words.ts";
import { plainName, type LearnerFile, type ResultRow } from "../../../app/records/course/result-rows.ts";
import type { FileLeftOut } from "../../../app/records/course/opened-course-file.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/** Files without a result, each with its reason. */
export function LeftOut({ leftOut }: { readonly leftOut: readonly FileLeftOut[] }) {
  const { results: words } = useTexts("course-teach");
  const problemOf = useProblemWords();
  return (
    <ul role="status" className="taught-said">
      {leftOut.map(({ file, why }, i) => {
        const isProblem = why.kind !== "twice";
        const reason = why.kind === "twice" || why.kind === "task" ? words.left[why.kind] : problemOf(why).join(" ");
        const said = words.leftOut(file === "" ? words.aLink : file, reason);
        return (
          <Message as="li" key={i} tone={isProblem ? "warning" : "info"}>
            {said}
          </Message>
        );
      })}
    </ul>
  );
}

interface FilesProps {
  readonly files: readonly LearnerFile[];
  readonly rows: readonly ResultRow[];
  readonly day: (made: number) => string;
}

/** The files of the table: their contents, which results count, and a button to remove each. */
export function ResultFiles({ files, rows, day }: FilesProps) {
  const t = useTexts("course-teach"),
    { results: words } = t;
  const [gone, say] = useState<{ readonly file: string; readonly step: HistoryStep } | null>(null);
  const isLast = useIsLastStep(gone?.step);
  const drop = (each: LearnerFile | null) => {
    const step = recorded(() => removeResults(each));
    say(step && { file: each ? nameOf(each) : "", step });
  };
  const nameOf = ({ file }: LearnerFile) => (file === "" ? words.aLink : file);
  return (
    <div className="taught-files">
      {files.length > 0 && (
        <details>
          <summary>{words.files(String(files.length))}</summary>
          <ul className="taught-list">
            {files.map((each, i) => {
              const { name, made, tasks } = each.result,
                told = plainName(name) || words.noName;
              const earlier = rows.filter((row) => row.earlier && row.key.startsWith(`${i} `)).length;
              return (
                <li key={i}>
                  <span className="taught-name">
                    <b>{nameOf(each)}</b> {words.fileHas(told, String(tasks.length), day(made))}
                    {earlier > 0 && ` ${words.fileEarlier(String(earlier))}`}
                  </span>
                  <button
                    type="button"
                    className="button plain"
                    aria-label={words.remove(nameOf(each))}
                    onClick={() => drop(each)}
                  >
                    <Icon name="remove" />
                  </button>
                </li>
              );
            })}
          </ul>
          {files.length > 1 && (
            <button type="button" className="button" onClick={() => drop(null)}>
              <Icon name="remove" /> {words.removeAll}
            </button>
          )}
        </details>
      )}
      <div role="status">
        {gone && isLast && (
          <Message tone="info" className="taught-gone">
            <span>{gone.file === "" ? words.allGone : words.gone(gone.file)}</span>
            <button type="button" className="button" onClick={() => undo(gone.step.document)}>
              <Icon name="undo" /> {t.own.undo}
            </button>
          </Message>
        )}
      </div>
    </div>
  );
}

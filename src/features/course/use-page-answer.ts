import { useEffect, useRef, useState } from "react";
import type { PageQuestion } from "../../course/lesson.ts";
import type { JudgedAnswer } from "../../course/judge/page-answer.ts";
import { programOfQuestion } from "../../course/page-question.ts";
import { programOfLines } from "../../course/task-start.ts";
import { retryImport } from "../../app/base/parts.ts";
import { runOfLesson } from "./use-lesson-run.ts";

/** The last answer to the question of a page, as typed, and its result; null while it is judged. */
export interface PageAnswer {
  readonly text: string;
  readonly judged: JudgedAnswer | "failed" | "unreadable" | null;
}

/** Judges answers to a question by the run of its program. The newest answer counts. */
export function usePageAnswer(
  question: PageQuestion,
  lines: readonly string[],
  onJudged: (isRight: boolean) => void,
): { readonly given: PageAnswer | null; readonly answer: (text: string) => void; readonly clear: () => void } {
  const [given, put] = useState<PageAnswer | null>(null);
  const newest = useRef(0);
  useEffect(
    () => () => {
      newest.current = -1;
    },
    [],
  );
  const judge = async (text: string, number: number) => {
    try {
      const { judgePageAnswer } = await retryImport(() => import("../../course/judge/page-answer.ts"));
      const outcome = await runOfLesson(programOfLines(programOfQuestion(question, lines)));
      if (newest.current !== number) return;
      const judged = judgePageAnswer(question, text, outcome);
      put({ text, judged: judged ?? "unreadable" });
      if (judged) onJudged(judged.right);
    } catch {
      if (newest.current === number) put({ text, judged: "failed" });
    }
  };
  return {
    given,
    answer(text) {
      put({ text, judged: null });
      newest.current += 1;
      void judge(text, newest.current);
    },
    clear: () => put(null),
  };
}

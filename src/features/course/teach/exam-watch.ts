import { useEffect, useReducer } from "react";
import type { Exam } from "../../../course/exam.ts";
import { once } from "../../../app/base/once.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { endExam, overdueExams, timeLeftNow } from "../../../app/records/course/exams.ts";
import { progressRecord } from "../../../app/records/course/progress.ts";
import { resultsToHandIn, type Learner } from "./hand-in.ts";

const SECOND = 1000;
const finishing = new Set<string>();

/** Ends an exam with what there is at this moment, whether the learner hands it in or time has run out. */
export async function finishExam(exam: Exam, by: "learner" | "time", learner: Learner = exam): Promise<void> {
  const { set } = exam;
  if (exam.ended || finishing.has(set.id)) return;
  finishing.add(set.id);
  const { language } = useSettings.getState();
  const ids = set.tasks.map(({ id }) => id);
  try {
    endExam(set.id, by, await resultsToHandIn(ids, learner, progressRecord.now(), language, { set, exam, by }));
  } finally {
    finishing.delete(set.id);
  }
}

/** Ends each exam whose time runs out, or ran out while the page was closed. Called by all that show an exam. */
export const watchExams = once(() => {
  const look = () => {
    for (const exam of overdueExams()) void finishExam(exam, "time");
  };
  look();
  setInterval(look, SECOND);
});

/** Time left in an exam, ms, each second; null without a limit, or when it is over. */
export function useTimeLeft(exam: Exam | null): number | null {
  const [, tick] = useReducer((ticks: number) => ticks + 1, 0);
  const left = exam === null || exam.ended ? null : timeLeftNow(exam);
  const isRunning = left !== null;
  useEffect(() => {
    if (!isRunning) return undefined;
    const timer = setInterval(tick, SECOND);
    return () => clearInterval(timer);
  }, [isRunning]);
  return left;
}

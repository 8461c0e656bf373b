import { momentWriter } from "../../../app/base/clock-text.ts";
import { endOfExam, type Exam } from "../../../course/exam.ts";
import type { TaskSet } from "../../../course/task-set.ts";
import type { CourseSetTexts } from "../../../i18n/en/course-set.ts";
import type { Language } from "../../../i18n/languages.ts";

const MINUTE = 60,
  SECOND = 1000;

/** Day and time in the screen language. */
export const momentText = (language: Language, at: number): string => momentWriter(language)(at);

/** Time left as a clock: 1:07:30, or 4:09. */
export function clockText(ms: number): string {
  const all = Math.ceil(ms / SECOND);
  const two = (n: number) => String(n).padStart(2, "0");
  const [hours, minutes, seconds] = [
    Math.floor(all / MINUTE / MINUTE),
    Math.floor(all / MINUTE) % MINUTE,
    all % MINUTE,
  ];
  return hours > 0 ? `${hours}:${two(minutes)}:${two(seconds)}` : `${minutes}:${two(seconds)}`;
}

/** What applies in a set, one sentence each: told before an exam begins, and where the set is made. */
export function termsOf({ exam, help, due }: TaskSet, t: CourseSetTexts, language: Language): readonly string[] {
  const until = due === undefined ? [] : [t.terms.due(momentText(language, due))];
  if (!exam) return [...until, t.terms.help[help]];
  const { minutes, tries, reports } = exam;
  return [
    minutes === undefined ? t.terms.noLimit : t.terms.minutes(String(minutes)),
    ...until,
    ...(minutes === undefined && due === undefined ? [] : [t.terms.runsOut]),
    t.terms.noHelp,
    t.terms.reports[reports],
    ...(reports === "nothing" || tries === undefined ? [] : [t.terms.tries(tries)]),
    t.terms.judged,
  ];
}

/** What applies to an exam on paper: its time, and until when it is due. */
export const termsOnPaper = ({ exam, due }: TaskSet, t: CourseSetTexts, language: Language): readonly string[] => [
  ...(exam?.minutes === undefined ? [] : [t.paper.minutes(String(exam.minutes))]),
  ...(due === undefined ? [] : [t.terms.due(momentText(language, due))]),
];

/** How an exam ended, or until when it runs; "" without a limit. */
export function examStateText(exam: Exam, t: CourseSetTexts, language: Language): string {
  const { ended } = exam;
  if (ended) return t.exam.ended[ended.by](momentText(language, ended.result.made));
  const end = endOfExam(exam);
  return end === null ? t.exam.running : t.exam.runningUntil(momentText(language, end));
}

import { Suspense } from "react";
import { lazyWithin } from "../../../app/base/parts.ts";
import { fetchShownTexts } from "../../../app/base/settings/use-texts.ts";
import { useEditor } from "../../../app/document/store.ts";
import { taskOfWork } from "../../../app/document/work-task.ts";
import { useOpenedCourseFile } from "../../../app/records/course/opened-course-file.ts";

/** Loaded with the texts of the workplace when a task is open. */
const TaskBar = lazyWithin(async () => {
  const [{ TaskBar: bar }] = await Promise.all([import("./TaskBar.tsx"), fetchShownTexts()]);
  return { default: bar };
});

const SubmissionBar = lazyWithin(async () => ({
  default: (await import("../teach/SubmissionBar.tsx")).SubmissionBar,
}));

/** The line of a task above its work, or of a learner's program that was handed in. */
export function TaskLine() {
  const work = useEditor((s) => s.work);
  const isTask = useEditor((s) => taskOfWork(s) !== undefined);
  const submission = useOpenedCourseFile(({ submission: opened }) => (opened?.work === work ? opened : null));
  return (
    <Suspense>
      {isTask && work !== null && <TaskBar key={work} work={work} />}
      {!isTask && submission && <SubmissionBar key={submission.work} said={submission.said} task={submission.task} />}
    </Suspense>
  );
}

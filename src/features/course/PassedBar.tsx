import { passedOf } from "../../course/path.ts";
import type { LessonEntry } from "../../app/records/course/content.ts";
import { useLearning } from "../../app/records/course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** The exercises passed in some lessons, in words and as a bar. */
export function PassedBar({ lessons }: { readonly lessons: readonly LessonEntry[] }) {
  const t = useTexts("course");
  const progress = useLearning((s) => s.list);
  const { passed, of } = passedOf(lessons, progress);
  return (
    <span className="passed-bar small">
      <span className="passed-track" aria-hidden="true">
        <span style={{ width: `${of === 0 ? 0 : (passed / of) * 100}%` }} />
      </span>
      <span>{t.passed(String(passed), String(of))}</span>
    </span>
  );
}

import { Icon } from "../Icon.tsx";
import { openToTry } from "./open-example.ts";
import { useCourseTexts } from "./use-course-texts.ts";

/** The program that the picture is made from, to be read and to be taken into the editor. */
export function LessonProgram({ lines }: { readonly lines: readonly string[] }) {
  const t = useCourseTexts().picture;
  return (
    <details className="lesson-program">
      <summary>{t.program}</summary>
      <pre className="number" role="group" tabIndex={0} aria-label={t.program}>{lines.join("\n")}</pre>
      <button type="button" className="button" onClick={() => openToTry(lines)}>
        <Icon name="rename" /> {t.openProgram}
      </button>
    </details>
  );
}

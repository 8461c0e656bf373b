import { useState } from "react";
import { isEmptyProgress } from "../../course/progress.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { restartCourse, useLearning } from "../../app/records/course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Restarts the course at once, because undo restores it; shows trouble with the stored progress. */
export function RestartCourse() {
  const t = useTexts("course");
  const isEmpty = useLearning((s) => isEmptyProgress(s.list));
  const trouble = useLearning((s) => s.trouble);
  const [begun, setBegun] = useState(false);
  return (
    <div className="course-foot">
      {!isEmpty && (
        <button
          type="button"
          className="button plain"
          onClick={() => {
            restartCourse();
            setBegun(true);
          }}
        >
          {t.restart}
        </button>
      )}
      <p role="status" className="small">
        {isEmpty && begun && t.restarted}
        {trouble !== "none" && (
          <>
            <Icon name="info" /> {t[trouble]}
          </>
        )}
      </p>
    </div>
  );
}

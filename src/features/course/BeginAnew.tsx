import { useState } from "react";
import { isEmptyProgress } from "../../course/progress.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { beginCourseAnew, useLearning } from "../../app/records/course/progress.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Restarts the course at once, because undo restores it; shows trouble with the stored progress. */
export function BeginAnew() {
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
            beginCourseAnew();
            setBegun(true);
          }}
        >
          {t.anew}
        </button>
      )}
      <p role="status" className="small">
        {isEmpty && begun && t.begunAnew}
        {trouble !== "none" && (
          <>
            <Icon name="info" /> {t[trouble]}
          </>
        )}
      </p>
    </div>
  );
}

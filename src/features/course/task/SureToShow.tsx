import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import { noteSolution } from "../../../app/records/course/progress.ts";

interface Props {
  /** Id of the exercise. */
  readonly id: string;
  readonly t: CourseTaskTexts;
  /** What is shown, and what that counts as. */
  readonly label: string;
  readonly question: string;
  readonly show: () => void;
  /** The question was answered, either way. */
  readonly done: () => void;
}

/** Asks before something is shown that counts like the solution, and notes it. */
export const SureToShow = ({ id, t, label, question, show, done }: Props) => (
  <div className="task-sure" role="group" aria-label={label}>
    <p>{question}</p>
    <div className="task-ways">
      <button
        type="button"
        className="button primary"
        onClick={() => {
          noteSolution(id);
          done();
          show();
        }}
      >
        {t.confirmShow}
      </button>
      <button type="button" className="button" autoFocus onClick={done}>
        {t.cancelShow}
      </button>
    </div>
  </div>
);

import { Icon } from "../../../app/base/Icon.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { showResults } from "../../../app/records/course/show-results.ts";
import "./set.css";

/** Whose program is open, and the way back to the table of results. */
export function SubmissionBar({ said }: { readonly said: string }) {
  const { table: words } = useTexts("course-set");
  return (
    <section className="set-bar" aria-label={words.submission}>
      <span className="set-place">{said}</span>
      <button type="button" className="button" aria-haspopup="dialog" onClick={() => showResults()}>
        <Icon name="unfold" /> {words.back}
      </button>
    </section>
  );
}

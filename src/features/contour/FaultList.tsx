import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import type { RowIssue } from "../../program/job/contour-rows.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Unbroken } from "../../app/base/Unbroken.tsx";
import { issueText } from "../../app/calculation/issue-text.ts";

interface Props {
  readonly issues: readonly RowIssue[];
  readonly language: Language;
  readonly onPick: (row: number) => void;
}

/** Most findings listed under the drawing; the others stand at their elements. */
const MOST = 3;

/** The faults, right under the drawing that marks them; each leads to its element. */
export function FaultList({ issues, language, onPick }: Props) {
  const all = texts(language);
  const faults = issues.filter(({ issue }) => issue.severity !== "info");
  if (faults.length === 0) return null;
  return (
    <ul className="contour-faults" aria-label={all.contour.faults}>
      {faults.slice(0, MOST).map((found, i) => (
        <li key={i}>
          <button type="button" className="button plain small" onClick={() => onPick(found.row)}>
            <Icon name="error" /> <span className="number">{found.row + 1}!</span>{" "}
            <span>
              <Unbroken text={issueText(all, language, found.issue, null)} />
            </span>
          </button>
        </li>
      ))}
    </ul>
  );
}

import { blockAt } from "../../nc/reread.ts";
import type { Finding } from "../../program/run-types.ts";
import { Icon } from "../Icon.tsx";
import { issueText } from "../issue-text.ts";
import { showSection } from "../place.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { cycleOf, fixOf, placeOf } from "./diagnostics.ts";
import { dispatchEdit, openBlock, sessionView, useSession } from "./session.ts";
import { useFindings } from "./use-findings.ts";

/** Rows beyond these would say no more. */
const MOST = 300;

/** The field that a finding names; those of the reader name none. */
const fieldOf = ({ issue }: Finding): string | null => ("at" in issue ? (issue.at ?? null) : null);

function go(finding: Finding): void {
  const view = sessionView();
  const place = view && placeOf(view.state, finding);
  if (!place) return;
  openBlock(blockAt(useSession.getState().reading, place.from), fieldOf(finding));
  showSection("block");
}

/** All findings of the program, worst first, each with the way to its block and what corrects it. */
export function FindingsPanel() {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const findings = useFindings();
  useSession((s) => s.reading);
  const view = sessionView();
  if (findings.length === 0) return <p className="no-problems"><Icon name="check" /> {t.page.problem.none}</p>;
  return (
    <ul className="problem-list">
      {findings.slice(0, MOST).map((finding, i) => {
        const { issue, block } = finding;
        const place = view && placeOf(view.state, finding);
        const fix = view && fixOf(view.state, finding);
        return (
          <li key={i} className={`problem ${issue.severity}`}>
            <Icon name={issue.severity} />
            <div>
              <p className="small problem-head">
                <b>{t.page.problem.severities[issue.severity]}</b>
                {fieldOf(finding) !== null && <span> · {fieldOf(finding)}</span>}
                {block !== null && <span className="soft"> · {t.page.problem.inBlock(block)}</span>}
              </p>
              <p>{issueText(t, language, issue, view && place ? cycleOf(view.state, place.from) : null)}</p>
              {block !== null && <button type="button" className="button small" onClick={() => go(finding)}>{t.editor.goToBlock(String(block))}</button>}
              {fix && <button type="button" className="button small" onClick={() => dispatchEdit(fix, null)}>{t.editor.fix}</button>}
            </div>
          </li>
        );
      })}
    </ul>
  );
}

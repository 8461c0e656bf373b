import { enterSection } from "../../place/place.ts";
import { Icon } from "../../base/Icon.tsx";
import { issueText, placeInFile } from "../../calculation/issue-text.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { FindingsHost } from "../../findings/host.ts";
import { verdictReasons } from "../../findings/verdict-words.ts";
import { Unbroken } from "../../base/Unbroken.tsx";
import type { ExportRequest } from "./confirm-export.ts";

/** Most faults listed; the findings have all of them. */
const MOST = 4;

/** The workplace knows which cycle a finding is about. */
type Props = Pick<FindingsHost, "cycleOf">;

/** Faults of a program about to be exported, and the choices. */
export function ConfirmExportQuestion({
  asking: { way, verdict, faults, unchecked, answer },
  id,
  cycleOf,
}: Props & { readonly asking: ExportRequest; readonly id: string }) {
  const t = useTexts();
  const lengths = useLengths();
  const words = t.findings.leaving;
  const doubts = verdictReasons(t.findings.verdict, verdict).slice(0, MOST);
  return (
    <>
      <h2 id={`${id}-title`}>
        <Icon name="error" /> {unchecked && faults.length === 0 ? words.unchecked : words.title}
      </h2>
      <div id={`${id}-what`} className="leaving-what">
        {unchecked && <p>{words.uncheckedLead}</p>}
        {faults.length > 0 && <p>{words.lead(faults.length)}</p>}
        <ul>
          {faults.slice(0, MOST).map((entry) => (
            <li key={entry.id}>
              <Unbroken text={issueText(t, lengths, entry.issue, cycleOf(entry))} />
              {entry.block !== null && (
                <span className="soft">
                  ({entry.inFile ? placeInFile(t, entry.inFile) : t.findings.inBlock(String(entry.block))})
                </span>
              )}
            </li>
          ))}
          {verdict.open > 0 && <li>{t.dialog.done.open(verdict.open)}</li>}
        </ul>
        {faults.length > MOST && <p className="small soft">{t.findings.more(faults.length - MOST)}</p>}
        {doubts.map((doubt) => (
          <p key={doubt} className="small">
            {doubt}
          </p>
        ))}
      </div>
      <div className="leaving-ways">
        <button
          type="button"
          className="button primary"
          autoFocus
          onClick={() => {
            answer(false);
            enterSection("findings");
          }}
        >
          {words.look}
        </button>
        <button type="button" className="button" onClick={() => answer(false)}>
          {words.cancel}
        </button>
        <button type="button" className="button danger" onClick={() => answer(true)}>
          {words.go[way]}
        </button>
      </div>
    </>
  );
}

import { useEffect, useRef } from "react";
import { Icon } from "../base/Icon.tsx";
import { issueText, placeInFile } from "../calculation/issue-text.ts";
import { useLengths } from "../calculation/lengths.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import { chooseFinding, useChosenFinding } from "../document/chosen-finding.ts";
import type { FindingEntry } from "./entry.ts";
import type { FindingsHost } from "./host.ts";
import { ResidueTools } from "./ResidueTools.tsx";
import { ToolOffer } from "./ToolOffer.tsx";
import { useListed, useVerdict } from "./use-findings.ts";
import { VerdictText } from "./VerdictText.tsx";

/** More rows would say no more. */
const MOST = 300;

/** One finding: its message and place, with buttons that go there or fix it. */
function Row({
  entry,
  host,
  chosen,
}: {
  readonly entry: FindingEntry;
  readonly host: FindingsHost;
  readonly chosen: boolean;
}) {
  const t = useTexts();
  const lengths = useLengths();
  const row = useRef<HTMLLIElement>(null);
  const { issue, block, spot } = entry;
  const target = host.targetOf(entry);
  const where = entry.inFile ? placeInFile(t, entry.inFile) : block === null ? null : t.findings.inBlock(String(block));

  useEffect(() => {
    if (chosen) row.current?.scrollIntoView?.({ block: "nearest" });
  }, [chosen]);

  return (
    <li
      ref={row}
      className={`finding ${issue.severity}${spot ? ` on-${spot.kind}` : ""}`}
      aria-current={chosen ? "true" : undefined}
    >
      {spot ? (
        <button
          type="button"
          className={`badge badge-${spot.kind}`}
          aria-label={t.findings.show(spot.mark)}
          title={t.findings.show(spot.mark)}
          aria-pressed={chosen}
          onClick={() => {
            chooseFinding(chosen ? null : entry.id);
            if (!chosen) host.point(entry);
          }}
        >
          {spot.mark}
        </button>
      ) : (
        <Icon name={issue.severity} />
      )}
      <div>
        <p className="small finding-head">
          <b>{t.findings.severities[issue.severity]}</b>
          {target && <span>{` · ${target.name}`}</span>}
          {where !== null && target?.name !== where && <span className="soft">{` · ${where}`}</span>}
        </p>
        <p>
          {issueText(t, lengths, issue, host.cycleOf(entry))}
          {entry.thickness !== null && ` ${lengths.words(t.findings.residue.thick(lengths.number(entry.thickness)))}`}
        </p>
        <div className="finding-ways">
          {host.fixesOf(entry).map(({ name, apply }) => (
            <button key={name} type="button" className="button small mend" onClick={apply}>
              {name}
            </button>
          ))}
          <ToolOffer entry={entry} host={host} />
          <ResidueTools entry={entry} host={host} />
          {target && (
            <button
              type="button"
              className="button small"
              onClick={() => {
                if (spot) chooseFinding(entry.id);
                target.go();
              }}
            >
              {t.findings.goTo(target.name)}
            </button>
          )}
        </div>
      </div>
    </li>
  );
}

/** The verdict and all findings of the open work, worst first. Prompts and whole programs share this list. */
export function FindingsPanel({ host }: { readonly host: FindingsHost }) {
  const {
    findings: t,
    dialog: { done },
  } = useTexts();
  const entries = useListed();
  const verdict = useVerdict();
  const chosen = useChosenFinding((c) => c.id);
  return (
    <div className="findings">
      <p className="findings-verdict">
        <VerdictText verdict={verdict} reasons={4} />
      </p>
      {verdict.open > 0 && (
        <p className="findings-open">
          <Icon name="info" /> <span>{done.open(verdict.open)}</span>
          <button type="button" className="button small" onClick={host.toFirstOpen}>
            {done.firstOpen}
          </button>
        </p>
      )}
      {entries.length === 0 ? (
        verdict.open === 0 && verdict.state !== "none" && <p className="no-findings soft">{t.none}</p>
      ) : (
        <ul aria-label={t.list}>
          {entries.slice(0, MOST).map((entry) => (
            <Row key={entry.id} entry={entry} host={host} chosen={entry.id === chosen} />
          ))}
        </ul>
      )}
      {entries.length > MOST && <p className="small soft">{t.more(entries.length - MOST)}</p>}
    </div>
  );
}

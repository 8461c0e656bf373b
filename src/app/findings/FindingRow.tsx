import { useEffect, useId, useRef, useState } from "react";
import { Icon } from "../base/Icon.tsx";
import { useTexts } from "../base/settings/use-texts.ts";
import { issueText, placeInFile } from "../calculation/issue-text.ts";
import { useLengths } from "../calculation/lengths.ts";
import { chooseFinding } from "../document/chosen-finding.ts";
import type { FindingEntry } from "./entry.ts";
import type { FindingsHost } from "./host.ts";
import { useToolOffers, useTriedFixes } from "./offers.ts";
import { isLeftByTool, ResidueTools } from "./ResidueTools.tsx";
import { Unbroken } from "../base/Unbroken.tsx";
import { useFixesHeldBack } from "./task-result.ts";

/** One finding: a row that leads to its place, with the most certain fix as a button and the others folded away. */
export function FindingRow({
  entry,
  all,
  host,
  chosen,
}: {
  readonly entry: FindingEntry;
  readonly all: readonly FindingEntry[];
  readonly host: FindingsHost;
  readonly chosen: boolean;
}) {
  const t = useTexts();
  const lengths = useLengths();
  const id = useId();
  const row = useRef<HTMLLIElement>(null);
  const [isOpen, open] = useState(false);
  const { issue, at, block, spot } = entry;
  const target = host.targetOf(entry);
  // In a program the way leads to the block; a parameter is named too, since messages like "Enter a value." leave it out.
  const parameter = at !== null && /^Q\d+$/.test(at) && target?.name !== at ? at : null;
  const where = entry.inFile ? placeInFile(t, entry.inFile) : block === null ? null : t.findings.inBlock(String(block));
  const [tried, tools] = [useTriedFixes(entry, host, all), useToolOffers(entry, host)];
  const isHeldBack = useFixesHeldBack();
  const [first, ...others] = [...tools, ...host.fixesOf(entry), ...tried];

  useEffect(() => {
    if (chosen) row.current?.scrollIntoView?.({ block: "nearest" });
  }, [chosen]);

  return (
    <li
      ref={row}
      className={`finding ${issue.severity}${spot ? ` on-${spot.kind}` : ""}${target ? " leads" : ""}`}
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
          {target && (
            <>
              {" · "}
              <button
                type="button"
                className="finding-go"
                aria-label={t.findings.goTo(target.name)}
                aria-describedby={id}
                onClick={() => {
                  if (spot) chooseFinding(entry.id);
                  target.go();
                }}
              >
                {target.name}
              </button>
            </>
          )}
          {where !== null && target?.name !== where && <span className="soft">{` · ${where}`}</span>}
          {parameter !== null && <span className="soft number">{` · ${parameter}`}</span>}
        </p>
        <p id={id}>
          <Unbroken text={issueText(t, lengths, issue, host.cycleOf(entry))} />
          {entry.thickness !== null && ` ${lengths.words(t.findings.residue.thick(lengths.number(entry.thickness)))}`}
        </p>
        {!isHeldBack && (
          <div className="finding-ways">
            {first && (
              <button type="button" className="button small mend" onClick={first.apply}>
                {first.name}
              </button>
            )}
            <ResidueTools entry={entry} host={host} isOpen={isOpen} />
            {(others.length > 0 || isLeftByTool(entry)) && (
              <button type="button" className="button small" aria-expanded={isOpen} onClick={() => open(!isOpen)}>
                {t.findings.otherFixes}
              </button>
            )}
            {isOpen &&
              others.map(({ name, apply }) => (
                <button key={name} type="button" className="button small mend" onClick={apply}>
                  {name}
                </button>
              ))}
          </div>
        )}
      </div>
    </li>
  );
}

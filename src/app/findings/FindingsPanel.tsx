import { useLayoutEffect, useRef } from "react";
import { Icon } from "../base/Icon.tsx";
import { useTexts } from "../base/settings/use-texts.ts";
import { useChosenFinding } from "../document/chosen-finding.ts";
import type { FindingsHost } from "./host.ts";
import { FindingRow } from "./FindingRow.tsx";
import { useTaskResult } from "./task-result.ts";
import { TaskRows } from "./TaskRows.tsx";
import { useListed, useVerdict } from "./use-findings.ts";
import { VerdictText } from "./VerdictText.tsx";

/** More rows would say no more. */
const MOST = 300;

/** The verdict and all findings of the open work, worst first. Prompts and whole programs share this list. */
export function FindingsPanel({ host }: { readonly host: FindingsHost }) {
  const {
    findings: t,
    dialog: { done },
  } = useTexts();
  const entries = useListed();
  const verdict = useVerdict();
  const chosen = useChosenFinding((c) => c.id);
  const task = useTaskResult((s) => s.result);
  const top = useRef<HTMLParagraphElement>(null);
  const hasFocus = useRef(false);
  // The button of a fix disappears with its finding: the keyboard then goes on at the top of the list.
  useLayoutEffect(() => {
    if (hasFocus.current && document.activeElement === document.body) top.current?.focus({ preventScroll: true });
  }, [entries]);
  return (
    <div
      className="findings"
      onClickCapture={() => {
        hasFocus.current = true;
      }}
      onBlur={(event) => {
        hasFocus.current = event.relatedTarget === null || event.currentTarget.contains(event.relatedTarget);
      }}
    >
      <p className="findings-verdict" ref={top} tabIndex={-1}>
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
      {task && <TaskRows task={task} chosen={chosen} />}
      {entries.length === 0 ? (
        !task?.rows.length &&
        verdict.open === 0 &&
        verdict.state !== "none" && <p className="no-findings soft">{t.none}</p>
      ) : (
        <ul aria-label={t.list}>
          {entries.slice(0, MOST).map((entry) => (
            <FindingRow key={entry.id} entry={entry} all={entries} host={host} chosen={entry.id === chosen} />
          ))}
        </ul>
      )}
      {entries.length > MOST && <p className="small soft">{t.more(entries.length - MOST)}</p>}
      {host.improve && verdict.state !== "none" && (
        <button type="button" className="button findings-improve" onClick={host.improve}>
          <Icon name="compare" /> {t.betterWays}
        </button>
      )}
    </div>
  );
}

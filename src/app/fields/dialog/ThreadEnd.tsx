import { useContext } from "react";
import { Message } from "../../base/Message.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { issueText } from "../../calculation/issue-text.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { useShownOtherFile } from "../../document/shown-file.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import { FindingsHostContext } from "../../findings/host-context.ts";
import type { FindingsHost } from "../../findings/host.ts";
import { useTriedFixes } from "../../findings/offers.ts";
import { useFixesHeldBack } from "../../findings/task-result.ts";
import { useListed } from "../../findings/use-findings.ts";
import { Unbroken } from "../../base/Unbroken.tsx";
import { indexOfThread } from "./thread-operation.ts";

/** What a thread needs of the part around it: a place for its overrun, and material for its crest. */
const ABOUT_PART: ReadonlySet<string> = new Set(["threadOverruns", "crestMissing"]);

/** What the part around a thread lacks, each with the fixes that a run has shown to help. */
export function ThreadEnd({ line }: { readonly line: number | null }) {
  const host = useContext(FindingsHostContext);
  const all = useListed();
  const operations = useOutcome((s) => s.newest?.run.operations);
  const own = indexOfThread(operations ?? [], line, useShownOtherFile());
  if (!host || own < 0) return null;
  return all
    .filter(({ issue, operation }) => operation === own && ABOUT_PART.has(issue.code))
    .map((entry) => <PartFinding key={entry.id} entry={entry} all={all} host={host} />);
}

function PartFinding({
  entry,
  all,
  host,
}: {
  readonly entry: FindingEntry;
  readonly all: readonly FindingEntry[];
  readonly host: FindingsHost;
}) {
  const t = useTexts();
  const lengths = useLengths();
  const tried = useTriedFixes(entry, host, all);
  const isHeldBack = useFixesHeldBack();
  return (
    <Message tone={entry.issue.severity} as="div" className="thread-note small">
      <div>
        <p>
          <Unbroken text={issueText(t, lengths, entry.issue, host.cycleOf(entry))} />
        </p>
        {!isHeldBack &&
          tried.map(({ name, apply }) => (
            <button key={name} type="button" className="button small" onClick={apply}>
              {name}
            </button>
          ))}
      </div>
    </Message>
  );
}

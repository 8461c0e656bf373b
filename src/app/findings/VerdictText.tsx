import { Icon, type IconName } from "../base/Icon.tsx";
import { useLengths } from "../calculation/lengths.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import { toneOf, type ShownVerdict } from "./verdict.ts";
import { useTaskResult } from "./task-result.ts";
import { verdictReasons, verdictTitle } from "./verdict-words.ts";
import "./findings.css";

const icons: Readonly<Record<ReturnType<typeof toneOf>, IconName | null>> = {
  good: "check",
  plain: "check",
  doubt: "warning",
  bad: "error",
  none: null,
};

/** Most reasons shown here; the list has all of them. */
const MOST = 4;

/**
 * The verdict on a program in words, with its reasons where there is room for them. The same everywhere on the page.
 */
export function VerdictText({ verdict, reasons = 0 }: { readonly verdict: ShownVerdict; readonly reasons?: number }) {
  const t = useTexts().findings.verdict;
  const lengths = useLengths();
  const task = useTaskResult((s) => s.result);
  // Against its own contour a wrong part is verified, too: beside a failed check that is no good news.
  const isOwn = task !== null && task.against !== null && verdict.state === "proved";
  const tone = isOwn && toneOf(verdict) === "good" && task.rows.length > 0 ? "plain" : toneOf(verdict);
  const icon = icons[tone];
  const all = reasons > 0 ? verdictReasons(t, verdict).slice(0, Math.min(MOST, reasons)) : [];
  return (
    <span className={`verdict verdict-${tone}`}>
      {icon && <Icon name={icon} />}
      <span>
        <span className="verdict-title">{verdictTitle(t, lengths, verdict)}</span>
        {isOwn && <span className="verdict-reason verdict-against">{task.against}</span>}
        {all.map((reason) => (
          <span key={reason} className="verdict-reason">
            {reason}
          </span>
        ))}
      </span>
    </span>
  );
}

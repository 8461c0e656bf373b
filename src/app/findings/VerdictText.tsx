import { Icon, type IconName } from "../base/Icon.tsx";
import { useLengths } from "../calculation/lengths.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import { toneOf, type ShownVerdict } from "./verdict.ts";
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
  const tone = toneOf(verdict);
  const icon = icons[tone];
  const all = reasons > 0 ? verdictReasons(t, verdict).slice(0, Math.min(MOST, reasons)) : [];
  return (
    <span className={`verdict verdict-${tone}`}>
      {icon && <Icon name={icon} />}
      <span>
        <span className="verdict-title">{verdictTitle(t, lengths, verdict)}</span>
        {all.map((reason) => (
          <span key={reason} className="verdict-reason">
            {reason}
          </span>
        ))}
      </span>
    </span>
  );
}

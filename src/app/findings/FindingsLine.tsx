import { showSection } from "../place.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useListed, useVerdict } from "./use-findings.ts";
import { VerdictText } from "./VerdictText.tsx";

/** The verdict under the picture, with the way to the list. */
export function FindingsLine() {
  const t = useTexts().findings;
  const verdict = useVerdict();
  const { length } = useListed();
  return (
    <p className="findings-line">
      <VerdictText verdict={verdict} />
      {length > 0 && <button type="button" className="button plain small" onClick={() => showSection("findings")}>{t.count(length)}
      </button>}
    </p>
  );
}

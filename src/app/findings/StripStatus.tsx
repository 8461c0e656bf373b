import { Icon } from "../base/Icon.tsx";
import { enterSection } from "../place/place.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import { useListed, useVerdict } from "./use-findings.ts";

/** The number of findings, with a button to the list; empty prompts alone look calm. */
export function StripStatus({ otherwise = "" }: { readonly otherwise?: string }) {
  const {
    findings: t,
    dialog: { done },
  } = useTexts();
  const listed = useListed();
  const { open } = useVerdict();
  const worst = listed[0]?.issue.severity ?? "info";
  return (
    // The count of open prompts falls with each value: only findings are announced.
    <p className="effect-status" role="status" aria-live={listed.length > 0 ? "polite" : "off"}>
      {(listed.length > 0 || open > 0) && (
        <button type="button" className={`problem-button ${worst}`} onClick={() => enterSection("findings")}>
          <Icon name={worst} /> {listed.length > 0 ? t.count(listed.length) : done.open(open)}
        </button>
      )}
      {listed.length === 0 && open === 0 && otherwise !== "" && <span className="small">{otherwise}</span>}
    </p>
  );
}

import { useEffect } from "react";
import { toneOf } from "../findings/verdict.ts";
import { verdictReasons, verdictTitle } from "../findings/verdict-words.ts";
import { blockCount } from "../printed.ts";
import { closeCopying, useCopying } from "../program/copy.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";

/** What was taken along, with the verdict on it; read out. `otherwise` is said while nothing was copied. */
export function CopyStatus({ otherwise = "" }: { readonly otherwise?: string }) {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const { state, text, verdict } = useCopying();
  useEffect(() => closeCopying, []);
  const copied = state === "copied" && verdict !== null;
  const tone = copied ? toneOf(verdict) : "good";
  const note = !copied || tone === "good" || tone === "plain"
    ? ""
    : verdict.faults > 0
    ? t.findings.leaving.withFaults(verdict.faults)
    : verdict.open > 0
    ? `${t.dialog.done.open(verdict.open)}.`
    : [`${verdictTitle(t.findings.verdict, language, verdict)}.`, ...verdictReasons(t.findings.verdict, verdict).slice(0, 1)].join(" ");
  return (
    <p role="status" className={`small copy-status copy-${tone}`}>
      {copied ? `${t.page.text.copiedLong(blockCount(text))} ${note}`.trim() : otherwise}
    </p>
  );
}

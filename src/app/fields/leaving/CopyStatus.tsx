import { useEffect } from "react";
import type { Texts } from "../../../i18n/index.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import { toneOf, type ShownVerdict } from "../../findings/verdict.ts";
import { verdictReasons, verdictTitle } from "../../findings/verdict-words.ts";
import { closeCopying, useCopying } from "../../findings/copy.ts";
import { useFileKind } from "../../document/output.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { blockCount } from "../../document/printed.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Warning for a program with faults or open prompts. */
function doubtOf(verdict: ShownVerdict, { dialog, findings }: Texts, lengths: Lengths): string {
  if (verdict.faults > 0) return findings.leaving.withFaults(verdict.faults);
  if (verdict.open > 0) return `${dialog.done.open(verdict.open)}.`;
  return [
    `${verdictTitle(findings.verdict, lengths, verdict)}.`,
    ...verdictReasons(findings.verdict, verdict).slice(0, 1),
  ].join(" ");
}

/** What was copied, with its verdict, as a live status. `otherwise` is the text before anything is copied. */
export function CopyStatus({ otherwise = "" }: { readonly otherwise?: string }) {
  const t = useTexts();
  const lengths = useLengths();
  const { state, text, verdict } = useCopying();
  const kind = useFileKind();
  useEffect(() => closeCopying, []);
  const copied = state === "copied" && verdict !== null;
  const tone = copied ? toneOf(verdict) : "good";
  const note = copied && tone !== "good" && tone !== "plain" ? doubtOf(verdict, t, lengths) : "";
  return (
    <p role="status" className={`small copy-status copy-${tone}`}>
      {copied ? `${t.page.text.copiedLong(blockCount(text))} ${t.page.text.files[kind]}. ${note}`.trim() : otherwise}
    </p>
  );
}

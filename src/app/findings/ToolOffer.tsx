import { useEffect, useState } from "react";
import type { ToolFit } from "../../program/tools/which-tool.ts";
import { FIXED_BY_TOOL } from "../../report/offered-tool.ts";
import { CALCULATING } from "../base/waits.ts";
import { fitsOfCall } from "../calculation/tool-questions.ts";
import { useOutcome } from "../calculation/outcome.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import type { FindingEntry } from "./entry.ts";
import type { FindingsHost } from "./host.ts";

/** A tool of the table that can make the contour if the chosen one cannot; it is tried before it is offered. */
export function ToolOffer({ entry, host }: { readonly entry: FindingEntry; readonly host: FindingsHost }) {
  const t = useTexts().setup.tool;
  const newest = useOutcome((s) => s.newest);
  const [best, offer] = useState<ToolFit | null>(null);
  const asked = FIXED_BY_TOOL.has(entry.issue.code) && entry.issue.severity !== "info";
  useEffect(() => {
    const operation = asked && entry.operation !== null ? newest?.run.operations[entry.operation] : undefined;
    if (!operation) return undefined;
    let gone = false;
    const timer = setTimeout(() => {
      void fitsOfCall(operation).then((fits) => {
        if (!gone) offer(fits?.find((f) => f.makesContour) ?? null);
      });
    }, CALCULATING.otherTools);
    return () => {
      gone = true;
      clearTimeout(timer);
    };
  }, [asked, newest, entry]);
  if (!asked || !best) return null;
  return (
    <button
      type="button"
      className="button small mend"
      title={best.tool.NAME}
      onClick={() => host.takeTool(entry, best.tool.T)}
    >
      {t.take(best.tool.T)}
    </button>
  );
}

import { Suspense } from "react";
import type { AnyIssue } from "../../../i18n/message-texts.ts";
import { lazyWithin } from "../../base/parts.ts";
import { useLengths } from "../../calculation/lengths.ts";

const ToleranceOffer = lazyWithin(async () => ({ default: (await import("./ToleranceOffer.tsx")).ToleranceOffer }));

/** A number followed by a letter or a sign of a tolerance. */
const MAY_BE_SIZE = /\d\s*[a-z±/+-]/i;

interface Props {
  readonly issue: AnyIssue;
  readonly onTake: (middle: number) => void;
}

/** Below the problem of a text that is no number: the middle, if the text is a size in mm with a tolerance. */
export function TypedTolerance({ issue, onTake }: Props) {
  const { unit } = useLengths();
  const typed = issue.code === "notANumber" || issue.code === "badExpression" ? issue.data.text : "";
  if (unit !== "mm" || !MAY_BE_SIZE.test(typed)) return null;
  return (
    <Suspense fallback={null}>
      <ToleranceOffer typed={typed} onTake={onTake} />
    </Suspense>
  );
}

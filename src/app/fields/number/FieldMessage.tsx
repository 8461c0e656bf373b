import { useFixesHeldBack } from "../../findings/task-result.ts";
import { useContext } from "react";
import { cycleByNumber } from "../../../cycles/index.ts";
import { valueInProgram } from "../../../program/blocks/cycle-values.ts";
import { Message } from "../../base/Message.tsx";
import { goToField } from "../../place/place.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import { CycleInWork, useIssueText } from "../../calculation/issue-text.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { writeTyped } from "../dialog/write-value.ts";
import { TypedTolerance } from "./TypedTolerance.tsx";

interface Props {
  readonly problem: Pick<FindingEntry, "issue">;
  /** Decimals that the control keeps of the value. */
  readonly decimals: number;
  /** Name of its field, if shown at another one. */
  readonly place?: string;
  /** Not wrong, only not filled in yet: shown without alarm. */
  readonly calm?: boolean;
  /** Sets the nearest valid value. */
  readonly onTake?: (nearest: number) => void;
  /** The set-up has a field for the value of a Q parameter that is missing. */
  readonly parameterField?: boolean;
}

/** Problem of a field, with a button that sets the nearest valid value. */
export function FieldMessage({ problem, decimals, place, calm = false, onTake, parameterField = false }: Props) {
  const t = useTexts();
  const say = useIssueText();
  const lengths = useLengths(),
    cycle = useContext(CycleInWork);
  const { issue } = problem;
  const shown = calm ? "info" : issue.severity;
  const offered = "nearest" in issue.data && typeof issue.data.nearest === "number" ? issue.data.nearest : null;
  const param = cycle === null || !("at" in issue) ? undefined : cycleByNumber(cycle)?.params[issue.at ?? ""];
  const isSize = !param || ["diameter", "axial", "length"].includes(param.kind);
  const isInch = lengths.unit === "inch",
    nearest = offered === null ? null : valueInProgram(param, offered, isInch);
  const isHeldBack = useFixesHeldBack();
  return (
    <Message as="div" tone={shown}>
      <p>
        <span className="unseen">{t.findings.severities[shown]}: </span>
        {place !== undefined && (
          <>
            <b>{place}:</b>{" "}
          </>
        )}
        {say(issue)}
      </p>
      {parameterField && issue.code === "unknownParameter" && (
        <button type="button" className="button" onClick={() => goToField("setup", `parameter.${issue.data.name}`)}>
          {t.dialog.giveParameter(issue.data.name)}
        </button>
      )}
      {onTake && isSize && !isHeldBack && <TypedTolerance issue={issue} onTake={onTake} />}
      {nearest !== null && onTake && !isHeldBack && (
        <button type="button" className="button" onClick={() => onTake(nearest)}>
          {t.dialog.takeNearest(writeTyped(lengths.language, nearest, isInch ? decimals + 1 : decimals))}
        </button>
      )}
    </Message>
  );
}

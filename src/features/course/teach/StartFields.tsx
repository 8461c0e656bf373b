import { useId } from "react";
import type { Answer } from "../../../course/judge/judgement.ts";
import { cycleByNumber, type ParamTextId } from "../../../cycles/index.ts";
import { possibleFaults } from "../../../course/made/faults.ts";
import { linesOfText, learnerProgramOfForm, promptsOf } from "../../../course/made/task-from-form.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { TeachText, type FormPart } from "./WordFields.tsx";

/** The start program of the task. */
export function StartFields({ made, change, answer }: FormPart & { readonly answer: Answer }) {
  const t = useTexts("course-teach");
  const { params } = useTexts();
  const name = useId();
  const { operations } = answer.run;
  const {
    prompts: { operation, emptied },
    faults,
    start,
  } = made;
  const starts = (["empty", "prompts", "program"] as const).filter(
    (each) => (each !== "prompts" || operations.length > 0) && (each !== "empty" || made.kind !== "predict"),
  );
  const nameOf = (q: string): string => {
    const param = cycleByNumber(operations[operation]?.cycle ?? 0)?.params[q];
    return param ? params[param.text as ParamTextId].label : "";
  };
  const toggled = <T,>(list: readonly T[], one: T): readonly T[] =>
    list.includes(one) ? list.filter((each) => each !== one) : [...list, one];
  return (
    <fieldset>
      <legend>{t.start}</legend>
      <div className="teach-choices" role="radiogroup" aria-label={t.start}>
        {starts.map((each) => (
          <label key={each} className="teach-check">
            <input type="radio" name={name} checked={start === each} onChange={() => change({ start: each })} />
            {t.starts[each]}
          </label>
        ))}
      </div>
      {start === "prompts" && (
        <>
          <label className="teach-text">
            {t.which}
            <select
              className="select"
              value={operation}
              onChange={(event) => change({ prompts: { operation: Number(event.currentTarget.value), emptied: [] } })}
            >
              {operations.map(({ block, cycle }, i) => (
                <option key={i} value={i}>
                  {t.call(String(block), String(cycle))}
                </option>
              ))}
            </select>
          </label>
          <div role="group" aria-label={t.empty} className="teach-values">
            <span className="soft">{t.empty}</span>
            {promptsOf(answer, operation).map(([q, value]) => (
              <label key={q} className="teach-check number">
                <input
                  type="checkbox"
                  checked={emptied.includes(q)}
                  onChange={() => change({ prompts: { operation, emptied: toggled(emptied, q) } })}
                />
                {q}={value} <span className="teach-q">{nameOf(q)}</span>
              </label>
            ))}
          </div>
        </>
      )}
      {start === "program" && (
        <>
          <div role="group" aria-label={t.faults} className="teach-choices">
            <span className="soft">{t.faults}</span>
            {possibleFaults(linesOfText(answer.text)).map((fault) => (
              <label key={fault} className="teach-check">
                <input
                  type="checkbox"
                  checked={faults.includes(fault)}
                  onChange={() => change({ faults: toggled(faults, fault), program: null })}
                />
                {t.fault[fault]}
              </label>
            ))}
          </div>
          <TeachText
            label={t.program}
            isNc
            rows={12}
            value={made.program ?? learnerProgramOfForm(made, answer).join("\n")}
            change={(program) => change({ program })}
          />
        </>
      )}
    </fieldset>
  );
}

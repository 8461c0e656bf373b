import { useId } from "react";
import {
  fieldId,
  OWN_KINDS,
  type OwnCell,
  type OwnKind,
  type OwnParameterEntry,
  type OwnProblem,
} from "../../program/edits/own-cycle.ts";
import { Icon, type IconName } from "../../app/base/Icon.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { closeStep } from "../../app/document/steps.ts";
import { moveParameter, removeParameter, setOwnParameter } from "../../app/fields/blocks/own-edits.ts";
import { OwnField } from "./OwnField.tsx";

interface Props {
  readonly cycle: string;
  readonly parameter: OwnParameterEntry;
  /** Its place in the list, and the length of that. */
  readonly at: number;
  readonly count: number;
  readonly problems: readonly OwnProblem[];
}

const isKind = (text: string): text is OwnKind => OWN_KINDS.some((kind) => kind === text);

/** One parameter of a description. */
export function ParameterCard({ cycle, parameter, at, count, problems }: Props) {
  const t = useTexts("tables").own;
  const id = useId();
  const q = parameter.q.trim() || String(at + 1);
  const cell = (name: OwnCell, kind: "number" | "text" = "text", hint?: string) => (
    <OwnField
      key={name}
      className={`own-${name}`}
      label={t.cells[name]}
      name={`${q}: ${t.cells[name]}`}
      text={parameter[name]}
      problems={problems.filter((problem) => problem.at === fieldId(parameter.id, name))}
      kind={kind}
      {...(hint !== undefined && { hint })}
      onText={(text) => setOwnParameter(cycle, parameter.id, { [name]: text })}
    />
  );
  const tool = (icon: IconName, name: string, act: () => void, disabled = false) => (
    <button
      type="button"
      className="button icon plain"
      aria-label={name}
      title={name}
      disabled={disabled}
      onClick={act}
    >
      <Icon name={icon} />
    </button>
  );
  return (
    <div className="own-parameter" role="group" aria-label={t.parameter(q)} data-parameter={parameter.id}>
      {cell("q")}
      <div className="own-field own-kind">
        <label htmlFor={id}>{t.kind}</label>
        <select
          id={id}
          className="select"
          aria-label={`${q}: ${t.kind}`}
          value={parameter.kind}
          onChange={({ target }) => {
            closeStep();
            if (isKind(target.value)) setOwnParameter(cycle, parameter.id, { kind: target.value });
            closeStep();
          }}
        >
          {OWN_KINDS.map((kind) => (
            <option key={kind} value={kind}>
              {t.kinds[kind]}
            </option>
          ))}
        </select>
      </div>
      <div className="own-tools">
        {tool("raise", t.raise(q), () => moveParameter(cycle, parameter.id, -1), at === 0)}
        {tool("lower", t.lower(q), () => moveParameter(cycle, parameter.id, 1), at === count - 1)}
        {tool("remove", t.removeParameter(q), () => removeParameter(cycle, parameter.id))}
      </div>
      {cell("prompt")}
      {parameter.kind === "choice"
        ? cell("choices", "text", t.choicesHint)
        : [cell("min", "number"), cell("max", "number")]}
      {cell("first", "number")}
    </div>
  );
}

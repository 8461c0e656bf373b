import { usedParameters } from "../../../program/job/job-parameters.ts";
import { parameterField } from "../../../program/job/setup-fields.ts";
import { setParameter } from "../../document/edits.ts";
import type { JobReading } from "../../document/reading.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { NumberField } from "./NumberField.tsx";

/** The Q parameters that stand in the prompts, each with its value; nothing while none does. */
export function ParameterFields({ read: { job } }: { readonly read: JobReading }) {
  const t = useTexts().setup.parameters;
  const used = usedParameters(job);
  if (used.length === 0) return null;
  return (
    <fieldset className="setup-group">
      <legend>{t.title}</legend>
      <p className="small soft">{t.hint}</p>
      {used.map((name) => (
        <NumberField key={name} field={parameterField(name)} name={name} unit="" text={job.parameters[name] ?? ""} ask={t.ask(name)}
          onText={(value) => setParameter(name, value)} />
      ))}
    </fieldset>
  );
}

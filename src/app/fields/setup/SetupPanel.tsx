import type { ComponentProps } from "react";
import { Radio, RadioGroup } from "react-aria-components/RadioGroup";
import type { CycleNumber } from "../../../cycles/index.ts";
import type { SetupPlace } from "../../../program/job/setup-places.ts";
import { typedAt } from "../../../program/job/setup-place.ts";
import { usedParameters } from "../../../program/job/job-parameters.ts";
import { parameterField, SETUP_FIELDS as FIELDS } from "../../../program/job/setup-fields.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { useFixesHeldBack } from "../../findings/task-result.ts";
import { useFits } from "../../calculation/use-tool-fits.ts";
import { setParameter, setPerRevolution, setRapid, setSpindle } from "../../document/edits.ts";
import { setPlace } from "../../document/setup-edits.ts";
import { LazyPromptMore } from "../said/LazyPromptMore.tsx";
import { lazyPart, lazyWithin } from "../../base/parts.ts";
import { setupStartSlot } from "../slots.ts";
import type { JobReading } from "../../document/reading.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { NumberField } from "./NumberField.tsx";
import { ToolSummary } from "./ToolSummary.tsx";
import { ToolTable } from "./ToolTable.tsx";

/** Loaded if a machine states its rapid rates. */
const MachineRapid = lazyPart(async () => ({ default: (await import("../machine/MachineRapid.tsx")).MachineRapid }));
const SetupStart = lazyWithin(async () => ({ default: await setupStartSlot.fetch() }));

const MaterialGroup = lazyWithin(async () => ({ default: (await import("../said/MaterialField.tsx")).MaterialGroup }));
const JobClamping = lazyWithin(async () => ({ default: (await import("./JobClamping.tsx")).JobClamping }));

interface PlaceFieldProps extends Pick<ComponentProps<typeof NumberField>, "field" | "name" | "unit"> {
  readonly read: JobReading;
  readonly place: SetupPlace;
}

/** Heading of a set-up section, with a link to its guide pages. */
function Legend({ name, page }: { readonly name: string; readonly page: string }) {
  return (
    <>
      <legend>{name}</legend>
      <LazyPromptMore page={["guide", "setup", page]} name={name} />
    </>
  );
}

/** Fields for the Q parameters used in the prompts. */
function ParameterFields({ read: { job } }: { readonly read: JobReading }) {
  const t = useTexts().setup.parameters;
  const used = usedParameters(job);
  if (used.length === 0) return null;
  return (
    <fieldset className="setup-group">
      <legend>{t.title}</legend>
      <p className="small soft">{t.hint}</p>
      {used.map((name) => (
        <NumberField
          key={name}
          field={parameterField(name)}
          name={name}
          unit=""
          text={job.parameters[name] ?? ""}
          ask={t.ask(name)}
          onText={(value) => setParameter(name, value)}
        />
      ))}
    </fieldset>
  );
}

/** A field that is proposed until it is set. */
function PlaceField({ read, place, ...field }: PlaceFieldProps) {
  const value = typedAt(read.job, place);
  const isProposed = read.setup?.proposed.has(place) === true;
  return (
    <NumberField
      {...field}
      place={place}
      text={isProposed ? "" : value}
      proposal={isProposed ? value : undefined}
      onText={(text) => setPlace(place, text)}
    />
  );
}

/**
 * Everything besides the cycle: tool, blank, start point, spindle, feed unit, rapid rate. It appears as a whole, with the
 * parts that are fetched for it: a group that came later would push the fields below it away.
 */
export function SetupPanel({ read }: { readonly read: JobReading }) {
  const { setup: t, cycles } = useTexts();
  const isHeldBack = useFixesHeldBack();
  const found = useFits();
  const fits = isHeldBack ? null : found;
  const { spindle, perRevolution, rapid } = read.job;
  const isOfMachine = useOutcome((s) => typeof s.pictured?.run.timing.rates === "object");
  return (
    <div className="setup">
      <ParameterFields read={read} />
      <ToolSummary read={read} fits={fits} />
      <MaterialGroup />
      <fieldset className="setup-group">
        <Legend name={t.start.title} page="start.x" />
        <p className="small soft">{t.start.hint}</p>
        <PlaceField read={read} place="start.x" field={FIELDS.startX} name={t.start.x} unit={t.units.diameter} />
        <PlaceField read={read} place="start.z" field={FIELDS.startZ} name={t.start.z} unit={t.units.mm} />
      </fieldset>
      <fieldset className="setup-group">
        <Legend name={t.blank.title} page="blank.outside" />
        <PlaceField
          read={read}
          place="blank.outside"
          field={FIELDS.outside}
          name={t.blank.outside}
          unit={t.units.diameter}
        />
        <PlaceField read={read} place="blank.bore" field={FIELDS.bore} name={t.blank.bore} unit={t.units.diameter} />
        <PlaceField read={read} place="blank.length" field={FIELDS.length} name={t.blank.length} unit={t.units.mm} />
        <PlaceField
          read={read}
          place="blank.allowance"
          field={FIELDS.allowance}
          name={t.blank.allowance}
          unit={t.units.mm}
        />
      </fieldset>
      <JobClamping read={read} />
      <fieldset className="setup-group">
        <Legend name={t.spindle.title} page="spindle.cuttingSpeed" />
        <RadioGroup
          className="choice-pair"
          aria-label={t.spindle.mode}
          value={spindle.mode}
          onChange={(mode) => setSpindle("mode", mode === "constant" ? mode : "surface")}
        >
          {(["surface", "constant"] as const).map((mode) => (
            <Radio key={mode} value={mode} className="choice radio">
              <span>{t.spindle[mode]}</span>
            </Radio>
          ))}
        </RadioGroup>
        {spindle.mode === "constant" ? (
          <NumberField
            field={FIELDS.speed}
            name={t.spindle.speed}
            unit={t.units.rpm}
            text={spindle.speed}
            onText={(v) => setSpindle("speed", v)}
          />
        ) : (
          <>
            <NumberField
              field={FIELDS.cuttingSpeed}
              name={t.spindle.cuttingSpeed}
              unit={t.units.cuttingSpeed}
              text={spindle.cuttingSpeed}
              onText={(v) => setSpindle("cuttingSpeed", v)}
            />
            <NumberField
              field={FIELDS.limit}
              name={t.spindle.limit}
              unit={t.units.rpm}
              text={spindle.limit}
              onText={(v) => setSpindle("limit", v)}
            />
          </>
        )}
        <SetupStart cycle={read.cycle} surface={spindle.mode !== "constant"} perRevolution={perRevolution} />
      </fieldset>
      <fieldset className="setup-group">
        <Legend name={t.feed.title} page="perRevolution" />
        <label className="choice">
          <input type="checkbox" checked={perRevolution} onChange={(e) => setPerRevolution(e.currentTarget.checked)} />
          <span>{t.feed.perRevolution}</span>
        </label>
        {isOfMachine ? (
          <MachineRapid />
        ) : (
          <NumberField
            field={FIELDS.rapid}
            name={t.feed.rapid}
            unit={t.units.perMinute}
            text={rapid}
            onText={setRapid}
          />
        )}
      </fieldset>
      <section className="setup-group" aria-label={t.notes}>
        <h2>{t.notes}</h2>
        <ul className="small cycle-notes">
          {cycles.of[read.cycle.number as CycleNumber].notes.map((note) => (
            <li key={note}>{note}</li>
          ))}
        </ul>
      </section>
      <ToolTable read={read} fits={fits} />
    </div>
  );
}

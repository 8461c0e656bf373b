import { SETUP_FIELDS as FIELDS } from "../../../program/job/setup-fields.ts";
import type { SetJob, SpindleDraft } from "../../../program/job/job.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { AskedNumber, isUsable } from "./AskedNumber.tsx";

interface Props {
  readonly job: Pick<SetJob, "start" | "spindle">;
  readonly onStart: (axis: "x" | "z", text: string) => void;
  readonly onSpindle: (spindle: SpindleDraft) => void;
}

/** Whether start point and spindle can be written. */
export const arePlaceFieldsUsable = ({ start, spindle }: Props["job"]): boolean =>
  isUsable(FIELDS.startX, start.x) &&
  isUsable(FIELDS.startZ, start.z) &&
  (spindle.mode === "surface"
    ? isUsable(FIELDS.cuttingSpeed, spindle.cuttingSpeed) && isUsable(FIELDS.limit, spindle.limit)
    : isUsable(FIELDS.speed, spindle.speed));

/** Start point and spindle of an operation. */
export function PlaceFields({ job: { start, spindle }, onStart, onSpindle }: Props) {
  const t = useTexts();
  const ofSpindle = (name: "cuttingSpeed" | "limit" | "speed", unit: string) => (
    <AskedNumber
      name={t.setup.spindle[name]}
      unit={unit}
      field={FIELDS[name]}
      text={spindle[name]}
      onText={(text) => onSpindle({ ...spindle, [name]: text })}
    />
  );
  return (
    <>
      <AskedNumber
        name={t.setup.start.x}
        unit={t.setup.units.diameter}
        field={FIELDS.startX}
        text={start.x}
        onText={(text) => onStart("x", text)}
      />
      <AskedNumber
        name={t.setup.start.z}
        unit={t.setup.units.mm}
        field={FIELDS.startZ}
        text={start.z}
        onText={(text) => onStart("z", text)}
      />
      <label>
        <span>{t.operations.spindle}</span>
        <select
          className="select"
          value={spindle.mode}
          onChange={(event) =>
            onSpindle({ ...spindle, mode: event.target.value === "constant" ? "constant" : "surface" })
          }
        >
          {(["surface", "constant"] as const).map((mode) => (
            <option key={mode} value={mode}>
              {t.setup.spindle[mode]}
            </option>
          ))}
        </select>
      </label>
      {spindle.mode === "surface" ? (
        <>
          {ofSpindle("cuttingSpeed", t.setup.units.cuttingSpeed)}
          {ofSpindle("limit", t.setup.units.rpm)}
        </>
      ) : (
        ofSpindle("speed", t.setup.units.rpm)
      )}
    </>
  );
}

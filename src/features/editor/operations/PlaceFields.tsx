import { SETUP_FIELDS as FIELDS } from "../../../program/job/setup-fields.ts";
import type { SetJob, SpindleDraft } from "../../../program/job/job.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { AskedNumber, isUsable } from "./AskedNumber.tsx";

type Place = Pick<SetJob, "start" | "spindle">;

export const isSpindleUsable = (spindle: SpindleDraft): boolean =>
  spindle.mode === "surface"
    ? isUsable(FIELDS.cuttingSpeed, spindle.cuttingSpeed) && isUsable(FIELDS.limit, spindle.limit)
    : isUsable(FIELDS.speed, spindle.speed);

/** Whether start point and spindle can be written. */
export const arePlaceFieldsUsable = ({ start, spindle }: Place): boolean =>
  isUsable(FIELDS.startX, start.x) && isUsable(FIELDS.startZ, start.z) && isSpindleUsable(spindle);

interface StartProps {
  /** In the unit of the program. */
  readonly start: SetJob["start"];
  /** Writes a unit in that of the program. */
  readonly unit: (mm: string) => string;
  readonly onStart: (axis: "x" | "z", text: string) => void;
}

/** Start point of an operation. */
export function StartFields({ start, unit, onStart }: StartProps) {
  const t = useTexts();
  return (
    <>
      <AskedNumber
        name={t.setup.start.x}
        unit={unit(t.setup.units.diameter)}
        field={FIELDS.startX}
        text={start.x}
        onText={(text) => onStart("x", text)}
      />
      <AskedNumber
        name={t.setup.start.z}
        unit={unit(t.setup.units.mm)}
        field={FIELDS.startZ}
        text={start.z}
        onText={(text) => onStart("z", text)}
      />
    </>
  );
}

interface SpindleProps {
  readonly spindle: SpindleDraft;
  readonly onSpindle: (spindle: SpindleDraft) => void;
}

/** Spindle of an operation. */
export function SpindleFields({ spindle, onSpindle }: SpindleProps) {
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

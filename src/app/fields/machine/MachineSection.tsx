import { useId, useRef, useState, type KeyboardEvent } from "react";
import type { MachineTexts } from "../../../i18n/en/machine.ts";
import { formatNumber } from "../../../i18n/number.ts";
import type { MachineData } from "../../../program/machine/machine-data.ts";
import { EXAMPLE_MACHINE_NAMES, EXAMPLE_MACHINES } from "../../../program/machine/example-machines.ts";
import { machineOf, readMachine, writeMachine, type MachineProblem } from "../../../program/machine/machine-file.ts";
import { downloadText } from "../../base/download.ts";
import { Icon } from "../../base/Icon.tsx";
import { Message } from "../../base/Message.tsx";
import { useSettings, type Settings } from "../../base/settings/settings.ts";
import { editSettings } from "../../document/edit-settings.ts";
import { LabelledInput } from "../number/LabelledInput.tsx";
import {
  draftOfMachine,
  problemAt,
  readMachineDraft,
  MACHINE_FIELDS,
  type DraftPoint,
  type MachineDraft,
  type MachineField,
} from "./draft.ts";
import { useTextsOrNull } from "../../base/settings/use-texts.ts";
import "./machine.css";

/** Machine data without the name, to compare with the examples. */
const valuesOf = ({ name: _, ...values }: MachineData): string => JSON.stringify(values);

const exampleOf = (machine: MachineData | null) =>
  machine && EXAMPLE_MACHINE_NAMES.find((name) => valuesOf(EXAMPLE_MACHINES[name]) === valuesOf(machine));

/** Machine of this device: preset, values, export and import. */
export function MachineSection() {
  const t = useTextsOrNull("machine");
  return t && <Section t={t} />;
}

function Section({ t }: { readonly t: MachineTexts }) {
  const kept = useSettings((s) => s.machine);
  const output = useSettings((s) => s.output);
  const [draft, setDraft] = useState(() => {
    const machine = machineOf(kept);
    return machine && draftOfMachine(machine);
  });
  const [isOpen, open] = useState(false);
  const [said, say] = useState("");
  /** The text that this form wrote last; another one comes from undo. */
  const [written, write] = useState(kept);
  if (kept !== written) {
    write(kept);
    const machine = machineOf(kept);
    setDraft(machine && draftOfMachine(machine));
  }
  const file = useRef<HTMLInputElement>(null);
  const read = draft && readMachineDraft(draft);
  const machine = read && "machine" in read ? read.machine : null;
  const preset = draft === null ? "none" : (exampleOf(machine) ?? "own");

  const put = (next: MachineData | null, more: Partial<Settings> = {}, place: string | null = null) => {
    const machine = next ? writeMachine(next) : "";
    write(machine);
    void editSettings({ machine, ...more }, place);
  };
  const take = (next: MachineData | null, more: Partial<Settings> = {}) => {
    setDraft(next && draftOfMachine(next));
    put(next, more);
  };
  /** Invalid text stays in its field; the last valid data stay in force. */
  const type = (next: MachineDraft, place: string | null) => {
    setDraft(next);
    const found = readMachineDraft(next);
    if ("machine" in found) put(found.machine, {}, place);
  };
  const choose = (chosen: string) => {
    say("");
    const example = EXAMPLE_MACHINE_NAMES.find((each) => each === chosen);
    if (example) take({ ...EXAMPLE_MACHINES[example], name: t.presets[example] });
    else if (chosen === "none") take(null);
    else if (draft === null) take({ name: t.newName });
    open(chosen === "own");
  };
  const bringIn = async (chosen: File) => {
    const found = readMachine(await chosen.text());
    if ("problems" in found) {
      const [{ kind, at, limit }] = found.problems;
      return say(t.refused(t.problems[kind](at === "" ? "" : `${at}: `, String(limit ?? ""))));
    }
    const { output: brought, ...data } = found.machine;
    take(data, brought ? { output: brought } : {});
    say(t.taken(data.name));
  };
  const functions = t.functions(
    `M${output.spindleOn}`,
    output.spindleOff === null ? t.noFunction : `M${output.spindleOff}`,
  );
  return (
    <section className="machine" aria-labelledby="machine-title">
      <h3 id="machine-title">{t.title}</h3>
      <p className="small soft">{t.lead}</p>
      <label>
        <span>{t.preset}</span>
        <select className="select" value={preset} onChange={(event) => choose(event.currentTarget.value)}>
          {(["none", ...EXAMPLE_MACHINE_NAMES, "own"] as const).map((each) => (
            <option key={each} value={each}>
              {t.presets[each]}
            </option>
          ))}
        </select>
      </label>
      {preset !== "none" && preset !== "own" && <p className="small soft">{t.examples}</p>}
      {draft && read && (
        <details open={isOpen} onToggle={(event) => open(event.currentTarget.open)}>
          <summary>{t.values}</summary>
          <MachineForm t={t} draft={draft} problems={"problems" in read ? read.problems : []} type={type} />
        </details>
      )}
      {draft && !machine && (
        <Message tone="warning" role="status">
          {t.kept}
        </Message>
      )}
      {draft && <p className="small soft">{functions}</p>}
      <div className="bring-buttons">
        {machine && (
          <button
            type="button"
            className="button"
            onClick={() => downloadText(writeMachine({ ...machine, output }), "MACHINE.json")}
          >
            <Icon name="download" /> {t.save}
          </button>
        )}
        <button type="button" className="button" onClick={() => file.current?.click()}>
          {t.open}
        </button>
        <input
          ref={file}
          type="file"
          hidden
          accept=".json,application/json"
          onChange={(event) => {
            const [chosen] = event.currentTarget.files ?? [];
            event.currentTarget.value = "";
            if (chosen) void bringIn(chosen);
          }}
        />
      </div>
      <p role="status" className="small">
        {said}
      </p>
    </section>
  );
}

/** Groups of values and their units. */
const GROUPS = {
  rapid: [
    ["rapidX", "rate"],
    ["rapidZ", "rate"],
  ],
  acceleration: [
    ["accelerationX", "acceleration"],
    ["accelerationZ", "acceleration"],
  ],
  change: [["toolChange", "seconds"]],
  spindle: [
    ["most", "rpm"],
    ["runUp", "seconds"],
    ["power", "power"],
  ],
} as const satisfies Readonly<
  Partial<
    Record<keyof MachineTexts["groups"], readonly (readonly [field: MachineField, unit: keyof MachineTexts["units"]])[]>
  >
>;
const GROUP_NAMES = Object.keys(GROUPS) as readonly (keyof typeof GROUPS)[];

const EMPTY_POINT: DraftPoint = { speed: "", torque: "" };
const MOST_POINTS = 20;

interface FormProps {
  readonly t: MachineTexts;
  readonly draft: MachineDraft;
  readonly problems: readonly MachineProblem[];
  /** `place`: typing on there is one step of undo. */
  readonly type: (draft: MachineDraft, place: string | null) => void;
}

/** Enter in a form would close the settings. */
function keepOpen(event: KeyboardEvent): void {
  if (event.key === "Enter") event.preventDefault();
}

function MachineForm({ t, draft, problems, type }: FormProps) {
  const id = useId();
  const language = useSettings((s) => s.language);
  const said = (at: string): string | null => {
    const problem = problemAt(problems, at);
    return problem ? t.problems[problem.kind]("", formatNumber(language, problem.limit ?? 0)) : null;
  };
  const input = (name: string, unit: string, text: string, at: string, onText: (text: string) => void) => {
    const wrong = said(at);
    return (
      <LabelledInput
        key={at}
        className="setup-field"
        label={name}
        unit={unit}
        text={text}
        onText={onText}
        keypad="none"
        aria-invalid={wrong !== null}
        messages={wrong !== null && <Message tone="error">{wrong}</Message>}
        onKeyDown={keepOpen}
      />
    );
  };
  const { torque } = draft;
  const setPoint = (which: number, change: Partial<DraftPoint>) =>
    type(
      { ...draft, torque: torque.map((point, i) => (i === which ? { ...point, ...change } : point)) },
      `machine torque ${which} ${Object.keys(change).join(" ")}`,
    );
  const alone = said("acceleration"),
    curve = said("spindle.torque");
  return (
    <div className="machine-form">
      <label className="machine-name">
        <span>{t.name}</span>
        <input
          className="input"
          type="text"
          maxLength={60}
          autoComplete="off"
          value={draft.name}
          aria-invalid={said("name") !== null}
          onKeyDown={keepOpen}
          onChange={(event) => type({ ...draft, name: event.currentTarget.value }, "machine name")}
        />
      </label>
      {GROUP_NAMES.map((group) => (
        <fieldset key={group} className="machine-group">
          <legend>{t.groups[group]}</legend>
          {GROUPS[group].map(([field, unit]) =>
            input(t.fields[field], t.units[unit], draft[field], MACHINE_FIELDS[field], (text) =>
              type({ ...draft, [field]: text }, `machine ${field}`),
            ),
          )}
          {group === "acceleration" && alone !== null && <Message tone="error">{alone}</Message>}
        </fieldset>
      ))}
      <fieldset className="machine-group">
        <legend>{t.groups.torque}</legend>
        {torque.map((point, i) => (
          <div key={`${id}${i}`} className="machine-point">
            {input(t.fields.speed(`${i + 1}`), t.units.rpm, point.speed, `spindle.torque.${i}.speed`, (speed) =>
              setPoint(i, { speed }),
            )}
            {input(t.fields.torque(`${i + 1}`), t.units.torque, point.torque, `spindle.torque.${i}.torque`, (of) =>
              setPoint(i, { torque: of }),
            )}
            <button
              type="button"
              className="button icon plain"
              aria-label={t.removePoint(`${i + 1}`)}
              onClick={() => type({ ...draft, torque: torque.filter((_, each) => each !== i) }, null)}
            >
              <Icon name="remove" />
            </button>
          </div>
        ))}
        {curve !== null && <Message tone="error">{curve}</Message>}
        <button
          type="button"
          className="button"
          disabled={torque.length >= MOST_POINTS}
          onClick={() => type({ ...draft, torque: [...torque, EMPTY_POINT] }, null)}
        >
          <Icon name="add" /> {t.addPoint}
        </button>
      </fieldset>
    </div>
  );
}

import { useId, useState } from "react";
import type { OutputTexts } from "../../../i18n/en/output.ts";
import {
  isFunctionNumber,
  NC_OUTPUT_NAMES,
  NC_OUTPUTS,
  nameOfOutput,
  type NcOutput,
} from "../../../program/machine/nc-output.ts";
import { ModalDialog } from "../../base/ModalDialog.tsx";
import { Message } from "../../base/Message.tsx";
import { NumberInput } from "../number/NumberInput.tsx";
import { useTextsOrNull } from "../../base/settings/use-texts.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { editSettings } from "../../document/edit-settings.ts";
import { useEditor } from "../../document/store.ts";
import { setOutput, useOutput } from "../../document/output.ts";
import "./output.css";

/** Output settings of the open program; each change applies at once and can be undone. */
export function OutputDialog({ done }: { readonly done: () => void }) {
  const words = useTextsOrNull("output");
  return words && <Opened words={words} done={done} />;
}

function Opened({ words: t, done }: { readonly words: OutputTexts; readonly done: () => void }) {
  const output = useOutput();
  const device = useSettings((s) => s.output);
  const isProgram = useEditor((s) => s.program !== null);
  const isDefault = JSON.stringify(output) === JSON.stringify(device);
  const set = (change: Partial<NcOutput>) => setOutput({ ...output, ...change });
  const name = nameOfOutput(output);
  return (
    <ModalDialog title={t.title} done={done}>
      <p>{isProgram ? t.leadProgram : t.lead}</p>
      <div className="nc-output">
        <Choice
          name={t.preset}
          wide
          value={name ?? "own"}
          texts={t.presets}
          names={name === null ? [...NC_OUTPUT_NAMES, "own"] : NC_OUTPUT_NAMES}
          set={(preset) => preset !== "own" && setOutput(NC_OUTPUTS[preset])}
        />
        <FunctionNumber
          name={t.spindleOn}
          wrong={t.functionWrong}
          value={output.spindleOn}
          set={(spindleOn) => spindleOn !== null && set({ spindleOn })}
        />
        <FunctionNumber
          name={t.spindleOff}
          wrong={t.functionWrong}
          value={output.spindleOff}
          hint={t.spindleOffHint}
          set={(spindleOff) => set({ spindleOff })}
        />
        <Choice
          name={t.retract}
          wide
          value={output.retract}
          texts={t.retracts}
          names={["position", "limit"]}
          set={(retract) => set({ retract })}
        />
        <Choice
          name={t.end}
          value={`${output.end}`}
          texts={t.ends}
          names={["30", "2"]}
          set={(end) => set({ end: end === "2" ? 2 : 30 })}
        />
        <Choice
          name={t.newLine}
          value={output.newLine}
          texts={t.newLines}
          names={["\n", "\r\n"]}
          set={(newLine) => set({ newLine })}
        />
        <Choice
          name={t.name}
          value={output.capitals ? "capitals" : "typed"}
          texts={t.names}
          names={["typed", "capitals"]}
          set={(as) => set({ capitals: as === "capitals" })}
        />
        <label className="nc-output-check">
          <input
            type="checkbox"
            checked={output.numbered}
            onChange={(event) => set({ numbered: event.target.checked })}
          />
          <span>{t.numbered}</span>
        </label>
      </div>
      <p className="small soft">{t.unverified}</p>
      <div className="modal-ways">
        {isDefault ? (
          <p className="small soft" role="status">
            {t.isDefault}
          </p>
        ) : (
          <button type="button" className="button" onClick={() => void editSettings({ output })}>
            {t.makeDefault}
          </button>
        )}
      </div>
    </ModalDialog>
  );
}

interface ChoiceProps<N extends string> {
  readonly name: string;
  readonly value: N;
  readonly names: readonly N[];
  readonly texts: Readonly<Record<N, string>>;
  readonly set: (value: N) => void;
  readonly wide?: boolean;
}

function Choice<N extends string>({ name, value, names, texts, set, wide = false }: ChoiceProps<N>) {
  return (
    <label className={wide ? "wide" : ""}>
      <span>{name}</span>
      <select
        className="select"
        value={value}
        onChange={(event) => {
          const chosen = names.find((each) => each === event.target.value);
          if (chosen !== undefined) set(chosen);
        }}
      >
        {names.map((each) => (
          <option key={each} value={each}>
            {texts[each]}
          </option>
        ))}
      </select>
    </label>
  );
}

interface FunctionProps {
  readonly name: string;
  readonly value: number | null;
  readonly wrong: string;
  readonly hint?: string;
  readonly set: (value: number | null) => void;
}

/** An M function by its number. Invalid text stays in the field while the last valid number applies. */
function FunctionNumber({ name, value, wrong, hint, set }: FunctionProps) {
  const id = useId();
  const [typed, type] = useState<string | null>(null);
  const text = typed ?? (value === null ? "" : String(value));
  const read = text.trim() === "" ? null : Number(text);
  const isWrong = read === null ? hint === undefined : !/^\d+$/.test(text.trim()) || !isFunctionNumber(read);
  return (
    <label>
      <span>{name}</span>
      <span className="nc-output-function">
        M
        <NumberInput
          kind="typed"
          inputMode="numeric"
          maxLength={4}
          text={text}
          aria-label={name}
          aria-invalid={isWrong}
          aria-describedby={id}
          onText={(next) => {
            type(next);
            const number = next.trim() === "" ? null : Number(next);
            if (number === null ? hint !== undefined : /^\d+$/.test(next.trim()) && isFunctionNumber(number))
              set(number);
          }}
          onLeave={() => !isWrong && type(null)}
        />
      </span>
      {isWrong ? (
        <Message as="span" id={id} tone="warning">
          {wrong}
        </Message>
      ) : (
        hint !== undefined && (
          <span id={id} className="small soft">
            {hint}
          </span>
        )
      )}
    </label>
  );
}

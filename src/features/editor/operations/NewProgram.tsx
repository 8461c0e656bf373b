import { Suspense, useRef, useState } from "react";
import { emptyProgram } from "../../../program/job/empty-program.ts";
import { SETUP_FIELDS as FIELDS } from "../../../program/job/setup-fields.ts";
import type { BlankDraft } from "../../../program/job/job.ts";
import { openText } from "../../../app/fields/open/open-program.ts";
import { ModalDialog } from "../../../app/base/ModalDialog.tsx";
import { toFirstPrompt } from "../../../app/place/place.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { AskedNumber, isUsable } from "./AskedNumber.tsx";
import { setMaterial } from "../../../app/document/edits.ts";
import { MaterialSelect } from "../../../app/fields/said/MaterialField.tsx";
import { askForOperation } from "../../../app/document/inserting.ts";
import "./operations.css";

const USUAL: BlankDraft = { outside: "80", bore: "0", length: "100", allowance: "1" };

/** Asks for name and blank of a program, then for its first operation. */
export function NewProgram({ done }: { readonly done: () => void }) {
  const t = useTexts();
  const words = t.operations;
  const dialog = useRef<HTMLDialogElement>(null);
  const [name, setName] = useState("PROGRAM");
  const [blank, setBlank] = useState(USUAL);
  const [material, choose] = useState("");
  const usable =
    name.trim() !== "" &&
    (["outside", "bore", "length", "allowance"] as const).every((each) => isUsable(FIELDS[each], blank[each]));
  const number = (field: keyof BlankDraft, unit: string) => (
    <AskedNumber
      name={t.setup.blank[field]}
      unit={unit}
      field={FIELDS[field]}
      text={blank[field]}
      onText={(text) => setBlank((now) => ({ ...now, [field]: text }))}
    />
  );
  return (
    <ModalDialog ref={dialog} className="operation-dialog" first="input" title={words.newProgram} done={done}>
      <form
        className="operation-form"
        onSubmit={(event) => {
          event.preventDefault();
          if (!usable) return;
          dialog.current?.close();
          toFirstPrompt();
          openText(emptyProgram(name, blank));
          if (material !== "") setMaterial(material);
          askForOperation(null);
        }}
      >
        <div className="operation-body">
          <div className="operation-ask">
            <label className="wide">
              <span>{words.programName}</span>
              <input
                className="input"
                type="text"
                maxLength={32}
                autoComplete="off"
                spellCheck={false}
                value={name}
                onFocus={(event) => event.currentTarget.select()}
                onChange={(event) => setName(event.currentTarget.value)}
              />
            </label>
            <Suspense>
              <MaterialSelect id={material} choose={choose} />
            </Suspense>
          </div>
          <section className="operation-group" aria-label={words.blank}>
            <h3>{words.blank}</h3>
            <div className="operation-ask">
              {number("outside", t.setup.units.diameter)}
              {number("bore", t.setup.units.diameter)}
              {number("length", t.setup.units.mm)}
              {number("allowance", t.setup.units.mm)}
            </div>
          </section>
        </div>
        <footer className="operation-foot">
          <button type="button" className="button" onClick={() => dialog.current?.close()}>
            {words.cancel}
          </button>
          <button type="submit" className="button primary" disabled={!usable}>
            {words.create}
          </button>
        </footer>
      </form>
    </ModalDialog>
  );
}

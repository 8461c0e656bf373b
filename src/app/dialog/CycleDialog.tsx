import { useRef } from "react";
import { HelpSlot } from "./HelpSlot.tsx";
import { usePlace } from "../place.ts";
import type { JobReading } from "../reading.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useFingers } from "../use-fingers.ts";
import { ActivePrompt } from "./ActivePrompt.tsx";
import { DialogDone } from "./DialogDone.tsx";
import { Keypad } from "./Keypad.tsx";
import { PromptList } from "./PromptList.tsx";
import { step } from "./prompts.ts";
import type { ValueField } from "./ValueInput.tsx";

/** The dialog of a cycle, as the control leads through it: one prompt open, all others one line each. */
export function CycleDialog({ read }: { readonly read: JobReading }) {
  const t = useTexts();
  const fingers = useFingers();
  const prompt = usePlace((p) => p.prompt);
  const field = useRef<ValueField | null>(null);
  const param = prompt === null ? undefined : read.cycle.params[prompt];

  return (
    <div className="cycle-dialog" role="form" aria-label={t.dialog.form}>
      {prompt !== null && param
        ? <ActivePrompt read={read} q={prompt} param={param} ownKeypad={fingers} field={field} />
        : <DialogDone read={read} />}
      {fingers && prompt !== null && param && <Keypad q={prompt} param={param} field={field} />}
      <div className="below-prompt">
        <HelpSlot read={read} q={prompt} />
        <div
          className="prompt-list-box"
          onKeyDown={(event) => {
            const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
            if (by === 0) return;
            event.preventDefault();
            step(by);
          }}
        >
          <PromptList read={read} />
          {!fingers && <p className="small soft dialog-keys">{t.dialog.help}</p>}
        </div>
      </div>
    </div>
  );
}

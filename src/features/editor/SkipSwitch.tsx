import { useOutcome } from "../../app/calculation/outcome.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { changeProgram, useEditor } from "../../app/document/store.ts";
import "./work-files.css";

/** The control's switch for blocks with a skip mark, if the program has any. It belongs to the work. */
export function SkipSwitch() {
  const t = useTexts().editor;
  const on = useEditor((s) => s.program?.skipMarked ?? false);
  const marked = useOutcome((s) => s.newest?.marked ?? false);
  if (!marked && !on) return null;
  return (
    <label className="skip-switch">
      <input
        type="checkbox"
        checked={on}
        onChange={({ currentTarget: { checked } }) =>
          changeProgram(({ skipMarked: _, ...program }) => (checked ? { ...program, skipMarked: true } : program))
        }
      />
      <span>{t.leaveOut}</span>
    </label>
  );
}

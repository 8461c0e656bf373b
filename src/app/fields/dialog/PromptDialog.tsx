import { useLayoutEffect, useRef, type ReactNode } from "react";
import { createPortal } from "react-dom";
import { useFingers } from "../../base/use-media.ts";
import { fillHelpDock, useHelpDock } from "./help-dock.ts";
import { Keypad } from "./Keypad.tsx";
import { OpenPrompt } from "./OpenPrompt.tsx";
import { onPromptKey } from "./prompt-keys.ts";
import { PromptList } from "./PromptList.tsx";
import { openPromptOf, type PromptSession } from "./session.ts";

interface Props {
  readonly session: PromptSession;
  readonly name: string;
  readonly listName: string;
  /** Shown instead of the open prompt at the end. */
  readonly done: ReactNode;
  /** Below the list, on devices with a keyboard. */
  readonly hint?: string;
  /** Above the prompts. */
  readonly head?: ReactNode;
  /** Replaces the prompts while something else is asked. */
  readonly instead?: ReactNode;
  readonly className?: string;
}

/** Where the help picture is docked; null where the page has no such pane. `fills`: its place is taken. */
function useDock(fills: boolean): HTMLElement | null {
  const dock = useHelpDock((d) => d.dock),
    isFilled = dock !== null && fills;
  useLayoutEffect(() => (isFilled ? fillHelpDock() : undefined), [isFilled]);
  return dock;
}

/** Holds the place of a dialog, and of its help picture, whose parts are still fetched. */
export function ComingDialog() {
  useDock(true);
  return <div className="cycle-dialog" aria-busy="true" />;
}

/** Dialog as on the control: one prompt open, all others on one line each, with a picture. */
export function PromptDialog({ session, name, listName, done, hint, head, instead, className = "" }: Props) {
  const fingers = useFingers();
  const input = useRef<HTMLInputElement>(null);
  const open = openPromptOf(session);
  const dock = useDock(!instead);
  return (
    <div className={`cycle-dialog ${className}`.trim()} role="form" id="prompts" data-keys="prompts" aria-label={name}>
      {head}
      {instead ?? (
        <>
          {open ? <OpenPrompt session={session} prompt={open} ownKeypad={fingers} input={input} /> : done}
          {fingers && open && <Keypad session={session} prompt={open} input={input} />}
          <div className={`below-prompt${session.fields.length === 0 ? " no-prompts" : ""}`}>
            {dock ? createPortal(session.picture, dock) : session.picture}
            <div className="prompt-list-box" onKeyDown={(event) => onPromptKey(event, session)}>
              <PromptList session={session} name={listName} />
              {hint !== undefined && !fingers && <p className="small soft dialog-hint">{hint}</p>}
            </div>
          </div>
        </>
      )}
    </div>
  );
}

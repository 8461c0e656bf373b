import { useEffectEvent, useLayoutEffect, useRef } from "react";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { commandsOf, type Prompt, type PromptSession } from "./session.ts";
import { inScreenWriting } from "./write-value.ts";

/** Actions of a prompt besides its value: confirm the proposal, open a place outside the dialog, leave the set-up. */
export function PromptSteps({ session, prompt }: { readonly session: PromptSession; readonly prompt: Prompt }) {
  const { setup, dialog: t } = useTexts();
  const language = useSettings((s) => s.language);
  const way = useRef<HTMLButtonElement>(null);
  const { action, suggestion, group, label, hasNoValue } = prompt;
  const isProposed = suggestion?.holds === true && (session.draft[prompt.id] ?? "").trim() === "";
  const { take, finish } = commandsOf(session);
  const opened = useEffectEvent(() => {
    if (hasNoValue && session.mayFocus()) way.current?.focus({ preventScroll: true });
  });
  useLayoutEffect(() => opened(), [prompt.id, session.opened.focus]);
  if (!action && !group) return null;
  const value = suggestion ? inScreenWriting(language, suggestion.text) : "";
  return (
    <div className="prompt-steps">
      {isProposed && (
        <>
          <span className="small soft">{setup.proposed}</span>
          <button
            type="button"
            className="button"
            aria-label={setup.keepLong(label, value)}
            onClick={() => take(suggestion.text)}
          >
            {setup.keep}
          </button>
        </>
      )}
      {action && (
        <button type="button" ref={way} className={`button${action.needed ? " primary" : ""}`} onClick={action.run}>
          {action.label}
        </button>
      )}
      {group && (
        <button type="button" className="button primary" onClick={finish}>
          {t.setup.toPrompts}
        </button>
      )}
    </div>
  );
}

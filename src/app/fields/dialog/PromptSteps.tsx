import { inScreenWriting } from "../../../i18n/number.ts";
import { useEffectEvent, useLayoutEffect, useRef } from "react";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { OtherProposal } from "../setup/OtherProposal.tsx";
import { commandsOf, suggestionFor, type Prompt, type PromptSession } from "./session.ts";
import { isSetupPlace } from "./setup-prompts.ts";

interface Props {
  readonly session: PromptSession;
  readonly prompt: Prompt;
  readonly take: (text: string) => void;
}

/** Actions of a prompt besides its value: confirm a proposal, open a place outside the dialog, leave the set-up. */
export function PromptSteps({ session, prompt, take }: Props) {
  const { setup, dialog: t } = useTexts();
  const language = useSettings((s) => s.language);
  const way = useRef<HTMLButtonElement>(null);
  const { id, action, group, label, hasNoValue } = prompt;
  const proposal = group ? suggestionFor(session, prompt) : null;
  const { finish } = commandsOf(session);
  const opened = useEffectEvent(() => {
    if (hasNoValue && session.mayFocus()) way.current?.focus({ preventScroll: true });
  });
  useLayoutEffect(() => opened(), [id, session.opened.focus]);
  if (!action && !group) return null;
  return (
    <div className="prompt-steps">
      {proposal !== null && (
        <button
          type="button"
          className="button"
          aria-label={setup.keepLong(label, inScreenWriting(language, proposal))}
          onClick={() => take(proposal)}
        >
          {setup.keep}
        </button>
      )}
      {isSetupPlace(id) && <OtherProposal place={id} take={take} />}
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

import { inScreenWriting } from "../../../i18n/number.ts";
import { useId, useLayoutEffect, useRef, type RefObject } from "react";
import { isError, isOpen, type FindingEntry } from "../../findings/entry.ts";
import { useMedia } from "../../base/use-media.ts";
import { Message } from "../../base/Message.tsx";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { closeStep } from "../../document/steps.ts";
import { isSetupPlace } from "./setup-prompts.ts";
import { KeysButton } from "../keys/KeysButton.tsx";
import { LazyPromptMore } from "../said/LazyPromptMore.tsx";
import { FieldMessage } from "../number/FieldMessage.tsx";
import { isOnlySign } from "../number/number-entry.ts";
import { ChoiceInput } from "./ChoiceInput.tsx";
import { onPromptKey, onPromptTab } from "./prompt-keys.ts";
import { commandsOf, suggestionFor, type Prompt, type PromptSession } from "./session.ts";
import { PromptSteps } from "./PromptSteps.tsx";
import { ValueInput } from "./ValueInput.tsx";
import { writeTyped } from "./write-value.ts";

interface Props {
  readonly session: PromptSession;
  readonly prompt: Prompt;
  readonly ownKeypad: boolean;
  readonly input: RefObject<HTMLInputElement | null>;
}

/** The open prompt with question, value, unit, range, problems and help. */
export function OpenPrompt({ session, prompt, ownKeypad, input }: Props) {
  const t = useTexts();
  const id = useId();
  const card = useRef<HTMLElement>(null);
  const tiny = useMedia("tiny");
  const language = useSettings((s) => s.language);
  const { fields, opened } = session;
  const besides = session.otherFindings(prompt.id);
  const reading = session.readings[prompt.id];
  const waits =
    reading?.issue === null &&
    reading.value === null &&
    typeof reading.written === "object" &&
    reading.written !== null;
  const untouched = opened.before.trim() === "";
  const calm = (entry: FindingEntry) => isOpen(entry) && (untouched || entry.issue.code === "unknownParameter");
  const isAsked = (entry: FindingEntry) => calm(entry) && entry.issue.code === "missing";
  const suggested = suggestionFor(session, prompt);
  // The suggestion says already that a value is needed.
  const isSaid = (entry: FindingEntry) => suggested !== null && entry.issue.code === "missing" && calm(entry);
  const typed = session.draft[prompt.id] ?? "";
  // A sign that was just typed is the beginning of a number.
  const isBegun = isOnlySign(typed) && typed !== opened.before;
  const own = session.findings.filter(
    (p) => p.at === prompt.id && !isSaid(p) && !(isBegun && p.issue.code === "notANumber"),
  );
  const takeAt = (id: string) => (nearest: number) => {
    closeStep();
    session.set(id, String(nearest));
    closeStep();
  };
  const take = (text: string) => {
    commandsOf(session).take(text);
    input.current?.focus({ preventScroll: true });
  };
  const beside = ({ entry, place }: (typeof besides)[number]) => (
    <FieldMessage
      key={entry.id}
      problem={entry}
      decimals={prompt.decimals}
      {...(place !== undefined && { place })}
      {...(entry.at !== null && isSetupPlace(entry.at) && { onTake: takeAt(entry.at) })}
    />
  );
  const ofField = (entry: FindingEntry) => (
    <FieldMessage
      key={entry.id}
      problem={entry}
      calm={calm(entry)}
      decimals={prompt.decimals}
      onTake={(n) => take(String(n))}
      parameterField={session.asksParameters}
    />
  );
  useLayoutEffect(() => {
    const { current } = card;
    // In a short window the field is pinned and its card has no box: the dialog scrolls back to its beginning.
    if (current?.getClientRects().length) current.scrollIntoView?.({ block: "nearest" });
    else current?.parentElement?.scrollIntoView?.({ block: "start" });
  }, [prompt.id, opened.focus, tiny]);

  return (
    <section
      className="active-prompt"
      ref={card}
      aria-label={t.dialog.active}
      onKeyDownCapture={(event) => {
        onPromptTab(event, session);
        onPromptKey(event, session);
      }}
    >
      <div className="prompt-field">
        <header>
          <span className="number prompt-q">{prompt.letter}</span>
          <h2>{prompt.question}</h2>
          <span className="soft small prompt-position">
            {prompt.group
              ? t.dialog.setup.position(...prompt.group.at)
              : t.dialog.position(
                  fields.filter((f) => !f.group).indexOf(prompt) + 1,
                  fields.filter((f) => !f.group).length,
                )}
          </span>
          <KeysButton place="prompts" />
        </header>
        {prompt.hasNoValue && <p className="bare-value number">{prompt.shown.text}</p>}
        {!prompt.choices && !prompt.hasNoValue && (
          <div className="value-row">
            <ValueInput
              session={session}
              prompt={prompt}
              describedBy={`${id}-range ${id}-about`}
              ownKeypad={ownKeypad}
              input={input}
              invalid={own.some((p) => p.issue.severity === "error" && !calm(p))}
            />
            {reading?.computed && reading.value !== null && (
              <span className="sum-result number" role="status">
                = {writeTyped(language, reading.value, prompt.decimals)}
              </span>
            )}
            <span className="unit number">{prompt.unit}</span>
            {prompt.auto && (
              <button type="button" className="button" aria-label={t.dialog.autoLong} onClick={() => take("FAUTO")}>
                FAUTO
              </button>
            )}
          </div>
        )}
      </div>
      {prompt.choices && (
        <ChoiceInput session={session} prompt={prompt} choices={prompt.choices} describedBy={`${id}-about`} />
      )}
      <PromptSteps session={session} prompt={prompt} take={take} />
      <div className="range small soft">
        <p className="range-said" id={`${id}-range`}>
          {prompt.range !== null && (
            <span>
              {t.dialog.rangeLabel} <span className="number">{prompt.range}</span>
            </span>
          )}
          {suggested !== null && (
            <span className="suggested-note">{t.dialog.suggested(inScreenWriting(language, suggested))}</span>
          )}
          {prompt.notes.map((note) => (
            <span key={note}>{note}</span>
          ))}
        </p>
        {prompt.page && <LazyPromptMore page={prompt.page} name={prompt.letter} />}
      </div>
      <div className="about" tabIndex={0} role="group" aria-label={t.dialog.aboutPrompt(prompt.letter)}>
        <div role="status" aria-label={t.findings.title}>
          {[
            ...besides.filter(({ entry }) => isError(entry)).map(beside),
            ...own.filter((entry) => !isAsked(entry)).map(ofField),
            ...besides.filter(({ entry }) => !isError(entry)).map(beside),
          ]}
          {waits && <Message tone="info">{t.approach.parameter}</Message>}
        </div>
        {/* That a value is missing is no news where the prompt asks for it: not announced. */}
        {own.filter(isAsked).map(ofField)}
        <p className="explanation" id={`${id}-about`}>
          {prompt.about}
        </p>
      </div>
    </section>
  );
}

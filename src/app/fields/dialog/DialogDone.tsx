import { useLayoutEffect, useRef } from "react";
import { isError } from "../../findings/entry.ts";
import { useVerdict } from "../../findings/use-findings.ts";
import { toneOf } from "../../findings/verdict.ts";
import { VerdictText } from "../../findings/VerdictText.tsx";
import { Icon } from "../../base/Icon.tsx";
import { mayTakeKeyboard, enterSection } from "../../place/place.ts";
import { CopyButton } from "../program/CopyButton.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { closeStep } from "../../document/steps.ts";
import { commandsOf, openSuggestions, type PromptSession } from "./session.ts";

const ICONS = { bad: "error", doubt: "warning", none: "info", plain: "check", good: "check" } as const;

interface Props {
  readonly session: PromptSession;
  readonly inBlock: boolean;
  /** Inserts the next operation of the program. */
  readonly onInsert?: (() => void) | undefined;
}

/** End of the dialog: open prompts, problems, or the program to export. */
export function DialogDone({ session, inBlock, onInsert }: Props) {
  const {
    dialog: { done: t, active },
    findings: words,
    operations,
  } = useTexts();
  const {
    fields,
    findings: entries,
    opened: { focus },
  } = session;
  const { goTo, step } = commandsOf(session);
  const box = useRef<HTMLElement>(null);
  const verdict = useVerdict();
  const errors = entries.filter(isError);
  const open = [...new Set(errors.flatMap((e) => (fields.some((f) => f.id === e.at && !f.hasNoValue) ? [e.at] : [])))];
  const firstOpen = fields.find(({ id }) => id === open[0]);
  const noContour = errors.some((e) => e.at === "contour" && e.issue.code === "contourMissing");
  const first = fields.find((f) => !f.group && !f.hasNoValue)?.id ?? null;
  const suggested = openSuggestions(session);
  const suggestions = Object.keys(suggested).length;
  const wrong = noContour && !inBlock ? "contour" : "faults";
  const answered = first !== null && !inBlock && verdict.state === "none" ? "checking" : "complete";
  const kind = open.length > 0 ? "open" : errors.length > 0 ? wrong : answered;
  const titles = {
    open: t.open(open.length),
    contour: words.done.contour,
    faults: words.done.faults(errors.length),
    checking: t.checking,
    complete: first === null ? t.nothing : t.title,
  };
  const title = titles[kind];
  // Prompts that are still open are no fault.
  const tone = kind === "complete" || kind === "checking" ? toneOf(verdict) : kind === "faults" ? "bad" : "none";
  const was = useRef(focus);

  useLayoutEffect(() => {
    const asked = was.current !== focus || focus > 0;
    was.current = focus;
    const lost = document.activeElement === document.body;
    if (asked && (lost || !box.current?.contains(document.activeElement)) && mayTakeKeyboard()) {
      box.current?.querySelector<HTMLElement>("button")?.focus({ preventScroll: true });
    }
  }, [focus, kind]);

  return (
    <section
      className="active-prompt dialog-done"
      ref={box}
      aria-label={active}
      onKeyDown={(event) => {
        if (event.key !== "ArrowUp") return;
        event.preventDefault();
        step(-1);
      }}
    >
      <div role="status">
        <h2 className={`done-${tone === "good" ? "complete" : tone === "bad" ? "open" : "doubt"}`}>
          <Icon name={ICONS[tone]} />
          {title}
        </h2>
        {kind === "complete" && !inBlock && verdict.state !== "none" && (
          <p className="done-verdict">
            <VerdictText verdict={verdict} reasons={1} />
          </p>
        )}
      </div>
      <div className="done-buttons">
        {kind === "open" && suggestions > 0 && session.setAll && (
          <button
            type="button"
            className={`button${suggestions === open.length ? " primary" : ""}`}
            onClick={() => {
              closeStep();
              session.setAll?.(suggested);
              closeStep();
            }}
          >
            {t.takeAll(suggestions)}
          </button>
        )}
        {kind === "open" && (
          <button
            type="button"
            className={`button${suggestions === open.length ? "" : " primary"}`}
            onClick={() => goTo(open[0] ?? first)}
          >
            {t.firstOpen}: {firstOpen?.group ? firstOpen.question : firstOpen?.letter}
          </button>
        )}
        {kind === "contour" && (
          <button type="button" className="button primary" onClick={() => enterSection("contour")}>
            {words.done.toContour}
          </button>
        )}
        {kind === "faults" && (
          <button type="button" className="button primary" onClick={() => enterSection("findings")}>
            {words.leaving.look}
          </button>
        )}
        {(kind === "complete" || kind === "checking") && <CopyButton main long />}
        {kind !== "open" && onInsert && (
          <button type="button" className={`button${kind === "complete" ? " primary" : ""}`} onClick={onInsert}>
            <Icon name="add" /> {operations.insert}
          </button>
        )}
        {first !== null && (
          <button type="button" className="button" onClick={() => goTo(first)}>
            {t.first}
          </button>
        )}
      </div>
    </section>
  );
}

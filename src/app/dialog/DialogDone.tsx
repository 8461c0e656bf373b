import { useLayoutEffect, useRef } from "react";
import { CopyButton } from "../program/CopyButton.tsx";
import { Icon } from "../Icon.tsx";
import { mayTakeKeyboard, usePlace } from "../place.ts";
import { useProblems } from "../problems/problems.ts";
import type { JobReading } from "../reading.ts";
import { useTexts } from "../settings/use-texts.ts";
import { goTo, promptsOf, step } from "./prompts.ts";

/** The end of the dialog: what is still open, or the program to take along. */
export function DialogDone({ read }: { readonly read: JobReading }) {
  const t = useTexts().dialog.done;
  const focus = usePlace((p) => p.focus);
  const box = useRef<HTMLElement>(null);
  const errors = useProblems().filter((p) => p.issue.severity === "error" && p.at !== null && p.at in read.cycle.params);
  const open = [...new Set(errors.map((p) => p.at ?? ""))];
  const first = promptsOf(read.cycle)[0] ?? null;

  useLayoutEffect(() => {
    if (focus > 0 && mayTakeKeyboard()) box.current?.querySelector<HTMLElement>("button")?.focus({ preventScroll: true });
  }, [focus]);

  return (
    <section
      className="active-prompt dialog-done"
      ref={box}
      aria-label={useTexts().dialog.active}
      onKeyDown={(event) => {
        if (event.key !== "ArrowUp") return;
        event.preventDefault();
        step(-1);
      }}
    >
      <div role="status">
        <h2 className={open.length > 0 ? "done-open" : "done-complete"}>
          <Icon name={open.length > 0 ? "error" : "check"} />
          {open.length > 0 ? t.open(open.length) : t.title}
        </h2>
      </div>
      <div className="done-buttons">
        {open.length > 0
          ? <button type="button" className="button primary" onClick={() => goTo(open[0] ?? first)}>{t.firstOpen}: {open[0]}</button>
          : <CopyButton className="primary" long />}
        <button type="button" className="button" onClick={() => goTo(first)}>{t.first}</button>
      </div>
    </section>
  );
}

import { useState } from "react";
import type { ParamTextId } from "../../../cycles/index.ts";
import { useOutcome } from "../../calculation/outcome.ts";
import { Icon } from "../../base/Icon.tsx";
import { readJob } from "../../document/reading.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useEditor, type Editor } from "../../document/store.ts";
import { setPinned, settingOf, restorePinned, useCompared } from "./compared.ts";
import { changedOperations, COMPARED, numberText } from "./changes.ts";

interface Row {
  readonly name: string;
  readonly pinned: string;
  readonly now: string;
}

/** The prompts of a job that differ from those of another state of it. */
function useChangedPrompts(pinned: Editor | null): readonly Row[] {
  const t = useTexts();
  const job = useEditor((s) => s.job);
  const [now, before] = [job && readJob(job), pinned?.job && readJob(pinned.job)];
  if (!now || !before || now.cycle !== before.cycle) return [];
  return Object.entries(now.cycle.params).flatMap(([q, param]) => {
    const [is, was] = [now.draft[q] ?? "", before.draft[q] ?? ""];
    return is === was
      ? []
      : [{ name: t.dialog.value(q, t.params[param.text as ParamTextId].label), pinned: was, now: is }];
  });
}

/** The pinned and the present setting side by side, with a button that restores the pinned one. */
export function PinnedValues() {
  const t = useTexts();
  const lengths = useLengths();
  const pinned = useCompared((c) => c.pinned);
  const shown = useOutcome((s) => s.shown);
  const pictured = useOutcome((s) => s.pictured);
  const [open, setOpen] = useState(true);
  const values = useChangedPrompts(pinned?.work ?? null);
  if (!pinned || !shown || !pictured) return null;
  const { pin: words, ...names } = t.page.effect;
  const now = settingOf(shown, pictured);
  const { operations } = pictured.run;
  const hasMany = operations.length > 1;
  // A number that neither setting has gets no row: a thread has no chip of one size, many operations no common infeed.
  const numbers = COMPARED.filter((name) =>
    name === "chip" ? pinned.chip !== null || now.chip !== null : name !== "infeed" || !hasMany,
  ).map((name): Row => ({
    name: names[name],
    pinned: numberText(t, lengths, pinned, name),
    now: numberText(t, lengths, now, name),
  }));
  const each = hasMany
    ? changedOperations(t, lengths, pinned.outcome.run.operations, operations).map(
        ({ operation, name, before, now: is }): Row => ({
          name: `${operation + 1} · ${operations[operation]?.cycle ?? ""} ${names[name]}`,
          pinned: before,
          now: is,
        }),
      )
    : [];
  return (
    <section className="pinned" aria-label={words.title}>
      <header>
        <h2 className="panel-title">{words.title}</h2>
        <button
          type="button"
          className="button icon plain"
          aria-expanded={open}
          aria-label={open ? words.fold : words.unfold}
          title={open ? words.fold : words.unfold}
          onClick={() => setOpen(!open)}
        >
          <Icon name={open ? "up" : "down"} />
        </button>
      </header>
      {open && (
        <>
          <table>
            <thead>
              <tr>
                <td />
                <th scope="col">{words.pinned}</th>
                <th scope="col">{words.now}</th>
              </tr>
            </thead>
            <tbody>
              {[...values, ...numbers, ...each].map((row) => (
                <tr key={row.name} className={row.pinned === row.now ? "" : "differs"}>
                  <th scope="row">{row.name}</th>
                  <td className="number">{row.pinned}</td>
                  <td className="number">{row.now}</td>
                </tr>
              ))}
            </tbody>
          </table>
          <footer>
            <button type="button" className="button small" onClick={restorePinned}>
              {words.back}
            </button>
            <button type="button" className="button small plain" onClick={() => setPinned(false)}>
              {words.letGo}
            </button>
          </footer>
        </>
      )}
    </section>
  );
}

import { useId } from "react";
import { threadsNamed } from "../../kernel/thread/threads.ts";
import { designationOf, type NamedThread } from "../../kernel/thread/named-thread.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { designationIn } from "../../app/fields/dialog/thread-numbers.ts";
import { ComboboxInput, optionOf, useCombobox } from "../../app/fields/find/Combobox.tsx";

/** Most names shown; another letter narrows the list. */
const SHOWN = 6;

/** Asks for a thread by its name, and says which one the numbers are. */
export function ThreadField({
  thread,
  inside,
  onThread,
}: {
  readonly thread: NamedThread | null;
  readonly inside: boolean;
  readonly onThread: (thread: NamedThread) => void;
}) {
  const t = useTextsOrNull("threads");
  const language = useSettings((s) => s.language);
  const box = useCombobox();
  const status = useId();
  if (!t) return null;
  const found = threadsNamed(box.typed, SHOWN);
  const take = (taken: NamedThread | undefined) => {
    if (!taken) return;
    onThread(taken);
    box.change({ typed: "", chosen: 0 });
  };
  const side = inside ? "inside" : "outside";
  const said = thread
    ? `${t.is(designationIn(language, designationOf(thread, side)))} · ${thread[side]?.tolerance ? t.middleOfClass : t.basic}`
    : "";
  return (
    <div className="which-thread">
      <span className="small soft" aria-hidden="true">
        {t.title}
      </span>
      <ComboboxInput
        box={box}
        count={found.length}
        label={t.title}
        placeholder={t.example}
        className="input"
        describedBy={status}
        take={(i) => take(found[i])}
      />
      <ul id={box.id} role="listbox" aria-label={t.found} className="which-threads" hidden={found.length === 0}>
        {found.map((each, i) => (
          <li
            key={`${each.standard} ${each.name}`}
            {...optionOf(box, i, found.length)}
            className="which-named"
            onClick={() => take(each)}
          >
            {designationIn(language, each.name)}
          </li>
        ))}
      </ul>
      <p className="small soft" id={status} role="status">
        {box.typed !== "" && found.length === 0 ? t.none : said}
      </p>
    </div>
  );
}

import { outlinesFrom } from "../../../course/made/task-from-form.ts";
import type { Answer } from "../../../course/judge/judgement.ts";
import type { ThreadDraft } from "../../../course/made/made-threads.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import type { FormPart } from "./WordFields.tsx";

/** The threads of the part, as the cycles cut them, each with its name. */
export function ThreadFields({ made, change, answer }: FormPart & { readonly answer: Answer }) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const { threads, outside, bore } = made;
  if (threads.length === 0) return null;
  const number = (value: number) => formatNumber(language, value);
  const put = (at: number, some: Partial<ThreadDraft>) => {
    const next = threads.map((thread, i) => (i === at ? { ...thread, ...some } : thread));
    // An unedited outline shows the crest of a selected thread, and the grooves of an unselected one.
    const was = outlinesFrom(answer, "made", threads);
    const again =
      some.on !== undefined && was.outside === outside && was.bore === bore ? outlinesFrom(answer, "made", next) : {};
    change({ threads: next, ...again });
  };
  return (
    <fieldset>
      <legend>{t.threads}</legend>
      <p className="small soft">{t.threadsHint}</p>
      <ul className="teach-list">
        {threads.map(({ from, to, crest, root, name, on }, i) => {
          const where = t.thread(number(from), number(to), number(crest), number(root));
          return (
            <li key={i} className="teach-row">
              <label className="teach-check">
                <input type="checkbox" checked={on} onChange={() => put(i, { on: !on })} />
                {where}
              </label>
              <input
                className="input"
                aria-label={t.threadName(where)}
                disabled={!on}
                value={name}
                maxLength={40}
                onChange={(event) => put(i, { name: event.currentTarget.value })}
              />
            </li>
          );
        })}
      </ul>
    </fieldset>
  );
}

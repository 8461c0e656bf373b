import type { Site } from "../../../cycles/shape-request.ts";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import type { Language } from "../../../i18n/languages.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import { HAND_WORKS, isOnAxis, type HandWork as PathWork } from "../../../program/edits/hand-operation.ts";
import { readUndercutName } from "../../../program/job/undercut-name.ts";
import type { OtherRows } from "../../../app/fields/chooser/use-cycle-chooser.tsx";
import { withoutAccents } from "../../../app/fields/chooser/search.ts";
import { threadRows, type ThreadWay } from "./thread-rows.tsx";
import { Icon } from "../../../app/base/Icon.tsx";

/** Operations beside the cycles: by path blocks, on the axis, and by the name of a standard. */
export type HandWork = PathWork | "undercut";
const WORKS: readonly HandWork[] = ["undercut", ...HAND_WORKS];

/** Whether an operation is listed under a site; the search finds it under each. */
function belongsTo(work: HandWork, site: Site): boolean {
  if (work === "undercut") return site !== "face";
  if (isOnAxis(work)) return site !== "outside";
  return work === "chamfer" ? site !== "face" : site === "outside";
}

/** The name of an operation. */
export const nameOf = (hand: InsertTexts["hand"], work: HandWork): string =>
  work === "undercut" ? hand.undercut : hand.of[work];

/** Operations without a turning cycle, as rows of the chooser. */
export function handOffer(
  words: InsertTexts,
  site: Site,
  /** `typed`: the designation of an undercut that was searched for. */
  onTake: (work: HandWork, typed?: string) => void,
  { language, onThread }: { language: Language; onThread: (thread: NamedThread, way: ThreadWay) => void },
): OtherRows {
  const { hand } = words;
  const rows = (works: readonly HandWork[], typed?: string) =>
    works.length > 0 && (
      <section aria-label={hand.title}>
        <h3 className="panel-title">{hand.title}</h3>
        <ul className="hand-works">
          {works.map((work) => (
            <li key={work}>
              <button type="button" className="button" onClick={() => onTake(work, typed)}>
                <Icon name="add" /> {nameOf(hand, work)}
              </button>
            </li>
          ))}
        </ul>
      </section>
    );
  return (sought) => {
    if (sought === null) return { count: 0, best: null, shown: rows(WORKS.filter((work) => belongsTo(work, site))) };
    const thread = threadRows(words, sought, { site, language, onTake: onThread });
    if (thread) return thread;
    const terms = withoutAccents(sought).split(/\s+/);
    // A form letter alone may begin any word.
    const isUndercut = /din|iso/i.test(sought) && readUndercutName(sought) !== null;
    const typed = isUndercut ? sought : undefined;
    const found: readonly HandWork[] = isUndercut
      ? ["undercut"]
      : WORKS.filter((work) => terms.every((word) => withoutAccents(nameOf(hand, work)).includes(word)));
    const [first] = found;
    return {
      count: found.length,
      isNamed: true,
      best: first ? { name: nameOf(hand, first), go: () => onTake(first, typed) } : null,
      shown: rows(found, typed),
    };
  };
}

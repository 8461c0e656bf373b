import type { Site } from "../../../cycles/shape-request.ts";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import { HAND_WORKS, isOnAxis, type HandWork } from "../../../program/edits/hand-operation.ts";
import type { OtherRows } from "../../../app/fields/chooser/use-cycle-chooser.tsx";
import { withoutAccents } from "../../../app/fields/chooser/search.ts";
import { Icon } from "../../../app/base/Icon.tsx";

/** Whether an operation is listed under a site; the search finds it under each. */
function belongsTo(work: HandWork, site: Site): boolean {
  if (isOnAxis(work)) return site !== "outside";
  return work === "chamfer" ? site !== "face" : site === "outside";
}

/** Operations without a turning cycle, as rows of the chooser. */
export function handOffer({ hand }: InsertTexts, site: Site, onTake: (work: HandWork) => void): OtherRows {
  const rows = (works: readonly HandWork[]) =>
    works.length > 0 && (
      <section aria-label={hand.title}>
        <h3 className="panel-title">{hand.title}</h3>
        <ul className="hand-works">
          {works.map((work) => (
            <li key={work}>
              <button type="button" className="button" onClick={() => onTake(work)}>
                <Icon name="add" /> {hand.of[work]}
              </button>
            </li>
          ))}
        </ul>
      </section>
    );
  return (sought) => {
    if (sought === null)
      return { count: 0, best: null, shown: rows(HAND_WORKS.filter((work) => belongsTo(work, site))) };
    const words = withoutAccents(sought).split(/\s+/);
    const found = HAND_WORKS.filter((work) => words.every((word) => withoutAccents(hand.of[work]).includes(word)));
    const [first] = found;
    return {
      count: found.length,
      best: first ? { name: hand.of[first], go: () => onTake(first) } : null,
      shown: rows(found),
    };
  };
}

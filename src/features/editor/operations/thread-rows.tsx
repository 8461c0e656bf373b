import { catalogue } from "../../../cycles/index.ts";
import type { Cycle } from "../../../cycles/define.ts";
import type { Site } from "../../../cycles/shape-request.ts";
import { valuesOfThread, type ThreadFill } from "../../../cycles/thread-values.ts";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import type { Language } from "../../../i18n/languages.ts";
import type { NamedThread } from "../../../kernel/thread/named-thread.ts";
import { readThread } from "../../../kernel/thread/threads.ts";
import type { Draft } from "../../../program/job/read-draft.ts";
import { hasTap } from "../../../program/tools/tap-of-thread.ts";
import { designationIn } from "../../../app/fields/dialog/thread-numbers.ts";
import { Icon } from "../../../app/base/Icon.tsx";

/** How a thread is made: with a cycle on a side, or with a tap. */
export type ThreadWay = { readonly cycle: Cycle; readonly site: Site } | "tap";

/** The values of a thread for a cycle, with those that its surface gives; null where it has no such side. */
export function fillFor(thread: NamedThread, cycle: Cycle, site: Site, placed: Draft): ThreadFill | null {
  if (!cycle.thread) return null;
  const typed = Object.fromEntries(Object.entries(placed).map(([q, text]) => [q, Number(text)]));
  const position = Number(site === "inside");
  const values = { ...typed, [cycle.thread.position]: position };
  const fill = valuesOfThread(thread, cycle.thread, values, { aim: "middle", nose: null });
  return typeof fill === "string" || fill.inside !== (site === "inside") ? null : fill;
}

/** The ways to make a thread, those on a side first. */
function waysOf(thread: NamedThread, first: Site): readonly ThreadWay[] {
  // A taper needs the cycle with both ends; a cylinder takes the one with a diameter.
  const cycle = catalogue.find((c) => c.thread && (thread.taper > 0 ? c.thread.line : c.thread.diameters.length === 1));
  const sites = (["outside", "inside"] as const).filter((site) => thread[site] && (thread.side ?? site) === site);
  const cut = cycle ? sites.map((site) => ({ cycle, site })) : [];
  const tapped = hasTap(thread) ? (["tap"] as const) : [];
  return first === "inside"
    ? [...cut.filter(({ site }) => site === first), ...tapped, ...cut.filter(({ site }) => site !== first)]
    : [...cut, ...tapped];
}

/** Rows of the chooser for a typed name of a thread; null for any other text. */
export function threadRows(
  { sites, hand }: InsertTexts,
  sought: string,
  {
    site,
    language,
    onTake,
  }: {
    readonly site: Site;
    readonly language: Language;
    readonly onTake: (thread: NamedThread, way: ThreadWay) => void;
  },
) {
  const thread = readThread(sought);
  if (!thread) return null;
  const name = designationIn(language, thread.name);
  const nameOf = (way: ThreadWay) =>
    way === "tap" ? hand.tapOf(name) : hand.threadOf(name, sites[way.site], way.cycle.number);
  const rows = waysOf(thread, site).map((way) => ({ name: nameOf(way), go: () => onTake(thread, way) }));
  return {
    count: rows.length,
    best: rows[0] ?? null,
    shown: (
      <ul className="hand-works" aria-label={hand.threads}>
        {rows.map(({ name: text, go }) => (
          <li key={text}>
            <button type="button" className="button" onClick={go}>
              <Icon name="add" /> {text}
            </button>
          </li>
        ))}
      </ul>
    ),
  };
}

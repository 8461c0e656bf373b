import { useId } from "react";
import { useTexts } from "../../base/settings/use-texts.ts";
import { Drawing } from "./Drawing.tsx";
import type { MenuCycle } from "./menu.ts";

/** What can be done with a cycle: the first of them by pressing its row, the others by a button of their own. */
export interface CycleWay {
  /** What it does, for its name. */
  readonly name: string;
  /** What its own button says. */
  readonly short: string;
  readonly go: (cycle: number) => void;
}

interface Props {
  readonly cycle: MenuCycle;
  readonly ways: readonly CycleWay[];
  /** Enter takes it while a search is typed. */
  readonly first: boolean;
  /** Its group is said, where it does not stand under it. */
  readonly grouped: boolean;
  /** The Tab key comes here; the arrow keys go to the others. */
  readonly inTurn: boolean;
}

/** One cycle of the chooser: its drawing, number, name and sentence. */
export function CycleRow({ cycle, ways, first, grouped, inTurn }: Props) {
  const {
    page: { start },
    chooser: t,
    menu,
  } = useTexts("first");
  const id = useId();
  const words = menu.of[cycle.number];
  const name = start.cycle(cycle.number, words?.name ?? "");
  const tabIndex = inTurn ? 0 : -1;
  const [main, ...others] = ways;
  return (
    <li className={`cycle-row${first ? " first" : ""}`} data-cycle={cycle.number}>
      <button
        type="button"
        className="cycle-take"
        tabIndex={tabIndex}
        aria-label={`${name}: ${main?.name ?? ""}`}
        aria-describedby={id}
        onClick={() => main?.go(cycle.number)}
      >
        <span className="pictograms">
          <Drawing of={cycle.pictograms[0]} id={`${id}a`} turned={cycle.group === "transverse"} />
          {cycle.pictograms[1] && (
            <Drawing of={cycle.pictograms[1]} id={`${id}b`} turned={cycle.group === "transverse"} />
          )}
        </span>
        <span className="cycle-words">
          <span className="cycle-name">
            <b className="number card-number">{cycle.number}</b> <span>{words?.name}</span>
          </span>
          <span className="cycle-summary small soft" id={id}>
            {grouped && <span className="cycle-of">{menu.groups[cycle.group]}:</span>} {words?.summary}
            {cycle.recalled && (
              <span className="recalled-mark" title={start.unconfirmed}>
                {t.recalled}
              </span>
            )}
          </span>
        </span>
      </button>
      {others.map((way) => (
        <button
          key={way.short}
          type="button"
          className="button cycle-way"
          tabIndex={tabIndex}
          aria-label={`${name}: ${way.name}`}
          onClick={() => way.go(cycle.number)}
        >
          {way.short}
        </button>
      ))}
    </li>
  );
}

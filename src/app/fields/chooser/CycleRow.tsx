import { useId } from "react";
import { useTexts } from "../../base/settings/use-texts.ts";
import { Drawing } from "./Drawing.tsx";
import type { MenuCycle } from "./menu.ts";

/** An action for a cycle: the first one by clicking the row, the others by their own buttons. */
export interface CycleWay {
  /** Full name of the action. */
  readonly name: string;
  /** Text on its button. */
  readonly short: string;
  readonly go: (cycle: number) => void;
}

interface Props {
  readonly cycle: MenuCycle;
  readonly ways: readonly CycleWay[];
  /** Enter takes it while a search is typed. */
  readonly first: boolean;
  /** Shows the group, for a row outside its group. */
  readonly grouped: boolean;
  /** Tab stop; arrow keys reach the other rows. */
  readonly inTurn: boolean;
}

/** One cycle of the chooser: its drawing, number, name and sentence. */
export function CycleRow({ cycle, ways, first, grouped, inTurn }: Props) {
  const {
    page: { start },
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

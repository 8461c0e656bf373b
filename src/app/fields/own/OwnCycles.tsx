import { Suspense, useId, useState, type ReactNode } from "react";
import type { OtherRows } from "../chooser/use-cycle-chooser.tsx";
import { Drawing } from "../chooser/Drawing.tsx";
import { withoutAccents } from "../chooser/search.ts";
import type { OwnCycle } from "../../../program/edits/own-cycle.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { showOwn } from "../../place/place.ts";
import { useOwnCycles } from "../../document/own-reading.ts";

interface Rows {
  readonly cycles: readonly OwnCycle[];
  /** Cycle that is the tab stop. */
  readonly turn: number | null;
  readonly way: string;
  readonly onTake: (cycle: OwnCycle) => void;
  /** Enter takes the first while a search is typed. */
  readonly first?: boolean;
  readonly id?: string;
}

function OwnRows({ cycles, turn, way, onTake, first = false, id }: Rows) {
  const { own: t } = useTexts("tables");
  const {
    page: { start },
  } = useTexts();
  const about = useId();
  const inTurn = cycles.some(({ number }) => number === turn) ? turn : cycles[0]?.number;
  return (
    <ul className="cycle-rows" id={id}>
      {cycles.map((cycle, i) => (
        <li key={cycle.number} className={`cycle-row${first && i === 0 ? " first" : ""}`} data-cycle={cycle.number}>
          <button
            type="button"
            className="cycle-take"
            tabIndex={cycle.number === inTurn ? 0 : -1}
            aria-label={`${start.cycle(cycle.number, cycle.name)}: ${way}`}
            aria-describedby={`${about}${cycle.number}`}
            onClick={() => onTake(cycle)}
          >
            <span className="pictograms">
              <Drawing of={undefined} id={`${about}d${cycle.number}`} />
            </span>
            <span className="cycle-words">
              <span className="cycle-name">
                <b className="number card-number">{cycle.number}</b> <span>{cycle.name}</span>
              </span>
              <span className="cycle-summary small soft" id={`${about}${cycle.number}`}>
                {t.parameterCount(cycle.parameters.length)}
                <span className="recalled-mark">{t.mark}</span>
              </span>
            </span>
          </button>
        </li>
      ))}
    </ul>
  );
}

function OwnGroup(rows: Rows) {
  const { own: t } = useTexts("tables");
  const { page, chooser } = useTexts();
  const [open, setOpen] = useState(false);
  const id = useId();
  return (
    <section className="cycle-group" aria-label={page.own.title}>
      <h2>
        <button
          type="button"
          className="cycle-group-head"
          aria-expanded={open}
          aria-controls={open ? id : undefined}
          onClick={() => setOpen(!open)}
        >
          <Icon name={open ? "down" : "fold"} />
          <span>{page.own.title}</span>
          <span className="small soft">{chooser.count(rows.cycles.length)}</span>
        </button>
      </h2>
      {open && (
        <div id={id}>
          {rows.cycles.length > 0 ? <OwnRows {...rows} /> : <p className="own-none small soft">{t.none}</p>}
          <div className="own-edit">
            <button type="button" className="button" onClick={() => showOwn()}>
              {t.edit}
            </button>
          </div>
        </div>
      )}
    </section>
  );
}

const fits = ({ number, name }: OwnCycle, sought: string): boolean =>
  withoutAccents(sought)
    .split(/[\s,;]+/)
    .filter((word) => word !== "")
    .every((word) => (/^\d+$/.test(word) ? String(number).startsWith(word) : withoutAccents(name).includes(word)));

/** Suspends on its own texts, so that its neighbours need not wait. */
const later = (shown: ReactNode) => <Suspense>{shown}</Suspense>;

/** Own cycles next to the catalogue: as a group, or those that match the search. */
export function useOwnOffer(way: string, onTake: (cycle: OwnCycle) => void): OtherRows {
  const {
    page: { start },
  } = useTexts();
  const all = [...useOwnCycles().values()].sort((a, b) => a.number - b.number);
  return (sought, turn, isFirst) => {
    if (sought === null)
      return { count: 0, best: null, shown: later(<OwnGroup cycles={all} turn={turn} way={way} onTake={onTake} />) };
    const cycles = all.filter((cycle) => fits(cycle, sought));
    const [first] = cycles;
    return {
      count: cycles.length,
      best: first ? { name: start.cycle(first.number, first.name), go: () => onTake(first) } : null,
      shown:
        cycles.length > 0 && later(<OwnRows cycles={cycles} turn={turn} way={way} onTake={onTake} first={isFirst} />),
    };
  };
}

import { useId, useState } from "react";
import type { Group } from "../../../cycles/define.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { CycleRow, type CycleWay } from "./CycleRow.tsx";
import type { MenuCycle } from "./menu.ts";

interface Props {
  readonly group: Group;
  readonly cycles: readonly MenuCycle[];
  readonly ways: readonly CycleWay[];
  /** Cycle that is the tab stop. */
  readonly turn: number | null;
  readonly startsOpen: boolean;
}

/** The cycles of one group; its heading collapses them. */
export function CycleGroup({ group, cycles, ways, turn, startsOpen }: Props) {
  const { chooser: t, menu } = useTexts("first");
  const [chosen, choose] = useState<boolean | null>(null);
  const open = chosen ?? startsOpen;
  const id = useId();
  const inTurn = cycles.some(({ number }) => number === turn) ? turn : cycles[0]?.number;
  return (
    <section className="cycle-group" aria-label={menu.groups[group]}>
      <h2>
        <button
          type="button"
          className="cycle-group-head"
          aria-expanded={open}
          aria-controls={open ? id : undefined}
          onClick={() => choose(!open)}
        >
          <Icon name={open ? "down" : "fold"} />
          <span>{menu.groups[group]}</span>
          <span className="small soft">{t.count(cycles.length)}</span>
        </button>
      </h2>
      {open && (
        <ul className="cycle-rows" id={id}>
          {cycles.map((cycle) => (
            <CycleRow
              key={cycle.number}
              cycle={cycle}
              ways={ways}
              first={false}
              grouped={false}
              inTurn={cycle.number === inTurn}
            />
          ))}
        </ul>
      )}
    </section>
  );
}

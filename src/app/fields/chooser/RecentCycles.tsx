import { useId } from "react";
import { useTexts } from "../../base/settings/use-texts.ts";
import { Drawing } from "./Drawing.tsx";
import type { CycleWay } from "./CycleRow.tsx";
import type { MenuCycle } from "./menu.ts";
import { useRecent } from "./recent.ts";

/** The last chosen cycles in one row. */
export function RecentCycles({
  offered,
  ways,
}: {
  readonly offered: readonly MenuCycle[];
  readonly ways: readonly CycleWay[];
}) {
  const {
    chooser: t,
    page: { start },
    menu,
  } = useTexts("first");
  const cycles = useRecent((r) => r.cycles).flatMap((number) => offered.find((cycle) => cycle.number === number) ?? []);
  const id = useId();
  const [main] = ways;
  if (cycles.length === 0 || !main) return null;
  return (
    <section className="recent-cycles" aria-label={t.recent}>
      <h2 className="small soft">{t.recent}</h2>
      <ul>
        {cycles.map((cycle) => {
          const name = menu.of[cycle.number]?.name ?? "";
          return (
            <li key={cycle.number}>
              <button
                type="button"
                className="button recent-cycle"
                title={name}
                aria-label={`${t.recentOne(start.cycle(cycle.number, name))}: ${main.name}`}
                onClick={() => main.go(cycle.number)}
              >
                <Drawing of={cycle.pictograms[0]} id={`${id}${cycle.number}`} turned={cycle.group === "transverse"} />
                <b className="number card-number">{cycle.number}</b> <span>{name}</span>
              </button>
            </li>
          );
        })}
      </ul>
    </section>
  );
}

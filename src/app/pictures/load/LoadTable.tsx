import type { Run } from "../../../program/state/run-types.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import { placeText } from "../lathe/running.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { goToLoad } from "./go-to-load.ts";
import { loadPlaceText, useGreatest, loadValue, type LoadQuantity } from "./use-load.ts";

export interface LoadTableProps {
  readonly of: LoadQuantity;
  readonly run: Run;
  readonly playback: PlaybackStore;
}

/** The colour map in words: the highest value of each operation, and its place. */
export function LoadTable({ of, run, playback }: LoadTableProps) {
  const t = useTexts("load"),
    { lathe } = useTexts(),
    lengths = useLengths();
  const { each } = useGreatest(run, of) ?? { each: [] };
  return (
    <details className="lathe-moves" name="lathe-more">
      <summary>{t.table(t.names[of])}</summary>
      {each.length === 0 ? (
        <p>{t.nothing}</p>
      ) : (
        <table>
          <thead>
            <tr>
              {[t.operation, t.value, lathe.axisX, lathe.axisZ, lathe.moveBlock].map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
              <td />
            </tr>
          </thead>
          <tbody>
            {each.map((place) => {
              const { x, z } = placeText(lengths, place.place),
                operation = place.operation === null ? null : run.operations[place.operation];
              return (
                <tr key={place.operation}>
                  <th scope="row">
                    {operation ? lathe.operation(String(operation.cycle), String(operation.tool.T)) : lathe.outside}
                  </th>
                  <td className="number">
                    {loadValue(t, lengths, of, place.value)}
                    {place.limited && of === "speed" && ` (${t.limited})`}
                  </td>
                  <td className="number">{x}</td>
                  <td className="number">{z}</td>
                  <td className="number">{place.block}</td>
                  <td>
                    <button
                      type="button"
                      className="lathe-goto"
                      aria-label={t.goTo(loadPlaceText(t, lengths, place))}
                      onClick={() => goToLoad(playback, place)}
                    >
                      {t.go}
                    </button>
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
      )}
    </details>
  );
}

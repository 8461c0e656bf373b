import type { Place } from "../../view/camera.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import type { LookAt } from "./places.ts";
import { useSeeing, type Seeing } from "./seeing.ts";

/** Where a mark stands from its place, pixels: beside it, so that the place stays to be seen. */
const ASIDE = { x: 18, y: -18 };
/** Never more marks than this on the picture; the list has them all. */
const MOST = 40;

/** Marks nearer than this would hide one another, pixels. */
const APART = 24;

interface Put {
  readonly place: LookAt;
  readonly at: Place;
  readonly left: number;
  readonly top: number;
}

/** Where each mark stands: those that would lie on one another stand in a row. */
function apart(places: readonly LookAt[], { at: seenAt }: Seeing): readonly Put[] {
  const put: Put[] = [];
  for (const place of places) {
    const at = seenAt(place.place);
    if (!at) continue;
    const top = at.y + ASIDE.y;
    let left = at.x + ASIDE.x;
    while (put.some((other) => Math.abs(other.left - left) < APART && Math.abs(other.top - top) < APART)) left += APART;
    put.push({ place, at, left, top });
  }
  return put;
}

/** The mark of each place in the picture: a number in a circle, a letter in a square. */
export function PlaceButtons({ seeing, places, chosen, choose }: { readonly seeing: Seeing; readonly places: readonly LookAt[];
  readonly chosen: LookAt | null; readonly choose: (place: LookAt | null) => void })
{
  const seen = useSeeing(seeing), { width, height } = seen.size();
  return (
    <>
      {apart(places.slice(0, MOST), seen).map(({ place: each, at, left, top }) => {
        const on = chosen?.id === each.id;
        if (at.x < SCALE_LEFT || at.x > width || at.y < 0 || at.y > height - SCALE_BELOW) return null;
        return (
          <button key={each.id} type="button" className={`lathe-place badge badge-${each.kind}`} style={{ left, top }} title={each.line}
            aria-label={`${each.mark}: ${each.line}`} aria-pressed={on} onClick={() => choose(on ? null : each)}
          >
            {each.mark}
          </button>
        );
      })}
      {chosen && (
        <p className={`lathe-note lathe-note-${chosen.kind}`}>
          <span className={`badge badge-${chosen.kind}`} aria-hidden="true">{chosen.mark}</span>
          {chosen.line}
        </p>
      )}
    </>
  );
}

/** The ring round each finding and the leader from each place to its mark. */
export function PlaceLines({ seeing, places }: { readonly seeing: Seeing; readonly places: readonly LookAt[] }) {
  const seen = useSeeing(seeing);
  const drawn = places.slice(0, MOST).flatMap((each) => {
    const at = seen.at(each.place);
    return at ? [{ ...each, at }] : [];
  });
  const leaders = (kind: LookAt["kind"], from: number) =>
    drawn.filter((each) => each.kind === kind).map(({ at: { x, y } }) => `M${x + from} ${y - from}L${x + ASIDE.x - 6} ${y + ASIDE.y + 6}`)
      .join("");
  return (
    <g aria-hidden="true">
      <path className="lathe-leader-residual" d={leaders("residual", 0)} />
      <path className="lathe-leader-finding" d={leaders("finding", 6)} />
      <path className="lathe-leader-told" d={leaders("told", 6)} />
      {drawn.filter((each) => each.kind !== "residual").map(({ id, kind, at }) => (
        <circle key={id} className={`lathe-ring lathe-ring-${kind}`} cx={at.x} cy={at.y} r="9" />
      ))}
    </g>
  );
}

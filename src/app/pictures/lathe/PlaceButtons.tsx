import { badgePlaces, SHARED } from "../../../view/badge-places.ts";
import type { Place } from "../../../view/camera.ts";
import type { LabelBox } from "../../../view/dimensions/labels.ts";
import { pageLength } from "../../base/unit.ts";
import { holds } from "../../base/use-media.ts";
import { SCALE_BELOW, SCALE_LEFT } from "./Axes.tsx";
import type { PicturePlace } from "./places.ts";
import { useProjection, type PlaceProjection } from "./place-projection.ts";

/** Most marks in the picture; the list has them all. */
const MOST = 40;
/** Radius of the ring around a finding, pixels. */
const RING = 9;
/** Width of the tools that float over the right edge, and of the single button in the corner on a phone, pixels. */
export const TOOLS = 56;
/** Width at the right edge that the floating tools cover now, pixels. */
export const underTools = (): number => (holds("narrow") && !holds("phone") ? TOOLS : 0);

interface Badge {
  readonly place: PicturePlace;
  /** The place, and the centre of its mark, pixels. */
  readonly at: Place;
  readonly left: number;
  readonly top: number;
}

/** The marks of all visible places. */
function badgesOf(places: readonly PicturePlace[], { at: seenAt, size }: PlaceProjection): readonly Badge[] {
  const { width, height } = size(),
    seen = { left: SCALE_LEFT, right: width, top: 0, bottom: height - SCALE_BELOW };
  const put = places.slice(0, MOST).flatMap((place) => {
    const at = seenAt(place.place);
    return at && at.x >= seen.left && at.x <= seen.right && at.y >= seen.top && at.y <= seen.bottom
      ? [{ place, at }]
      : [];
  });
  const badges = badgePlaces(
    put.map(({ at }) => at),
    holds("narrow") ? { ...seen, right: width - TOOLS } : seen,
  );
  return put.map((each, i) => ({ ...each, left: badges[i]?.x ?? each.at.x, top: badges[i]?.y ?? each.at.y }));
}

/** Half the height of a mark, of a start point or zero too, with some room around it, pixels. */
const AROUND = 12;
/** The area of a mark of the picture about its centre. */
export const markArea = ({ x, y }: Place, width = 2 * AROUND): LabelBox => ({
  x: x - width / 2,
  y: y - AROUND,
  width,
  height: 2 * AROUND,
});

/** The areas that the marks of places take. */
export const badgeAreas = (places: readonly PicturePlace[], seeing: PlaceProjection): readonly LabelBox[] =>
  sharedBadges(badgesOf(places, seeing), null).map(({ left, top, more }) =>
    markArea({ x: left, y: top }, more > 0 ? SHARED : undefined),
  );

/** One badge for those at the same spot, preferring the chosen one, and how many more it stands for. */
function sharedBadges(
  badges: readonly Badge[],
  chosen: PicturePlace | null,
): readonly (Badge & { readonly more: number })[] {
  const spots = new Map<string, Badge[]>();
  for (const badge of badges) {
    const key = `${badge.left} ${badge.top}`,
      known = spots.get(key);
    if (known) known.push(badge);
    else spots.set(key, [badge]);
  }
  return [...spots.values()].flatMap((all) => {
    const first = all.find(({ place }) => place.id === chosen?.id) ?? all[0];
    return first ? [{ ...first, more: all.length - 1 }] : [];
  });
}

/** The mark of each place in the picture: a number in a circle, a letter in a square. */
export function PlaceButtons({
  seeing,
  places,
  chosen,
  choose,
}: {
  readonly seeing: PlaceProjection;
  readonly places: readonly PicturePlace[];
  readonly chosen: PicturePlace | null;
  readonly choose: (place: PicturePlace | null) => void;
}) {
  return (
    <>
      {sharedBadges(badgesOf(places, useProjection(seeing)), chosen).map(({ place: each, left, top, more }) => {
        const on = chosen?.id === each.id,
          mark = more > 0 ? `${each.mark}+${more}` : each.mark;
        return (
          <button
            key={each.id}
            type="button"
            className={`lathe-place badge badge-${each.kind}`}
            style={{ left: pageLength(left), top: pageLength(top) }}
            title={each.line}
            aria-label={`${mark}: ${each.line}`}
            aria-pressed={on}
            onClick={() => choose(on ? null : each)}
          >
            {mark}
          </button>
        );
      })}
      {chosen && (
        <p className={`lathe-note lathe-note-${chosen.kind}`}>
          <span className={`badge badge-${chosen.kind}`} aria-hidden="true">
            {chosen.mark}
          </span>
          {chosen.line}
        </p>
      )}
    </>
  );
}

/** The ring around each finding, and the leader from each place to its mark. */
export function PlaceLines({
  seeing,
  places,
}: {
  readonly seeing: PlaceProjection;
  readonly places: readonly PicturePlace[];
}) {
  const drawn = badgesOf(places, useProjection(seeing));
  /** From the edge of a ring, or the place itself, to the centre of its mark, which covers the end. */
  const leaders = (kind: PicturePlace["kind"], from: number) =>
    drawn
      .filter(({ place }) => place.kind === kind)
      .map(({ at: { x, y }, left, top }) => {
        const share = from / Math.max(from, Math.hypot(left - x, top - y), 1);
        return `M${x + (left - x) * share} ${y + (top - y) * share}L${left} ${top}`;
      })
      .join("");
  return (
    <g aria-hidden="true">
      <path className="lathe-leader-residual" d={leaders("residual", 0)} />
      <path className="lathe-leader-finding" d={leaders("finding", RING)} />
      <path className="lathe-leader-told" d={leaders("told", RING)} />
      {drawn
        .filter(({ place }) => place.kind !== "residual")
        .map(({ place: { id, kind }, at }) => (
          <circle key={id} className={`lathe-ring lathe-ring-${kind}`} cx={at.x} cy={at.y} r={RING} />
        ))}
    </g>
  );
}

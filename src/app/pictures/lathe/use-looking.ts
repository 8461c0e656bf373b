import { useEffect, useEffectEvent } from "react";
import { useOutcome } from "../../calculation/outcome.ts";
import { chooseFinding, useChosen } from "../../document/chosen.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import type { Viewport } from "./viewport.ts";
import type { LookAt } from "./places.ts";

/** What a picture does to show a place, and everything again. */
type Looks = Pick<Viewport, "fit" | "show">;

/** Several pictures of one work look at the same place. */
export const lookingAt = (pictures: readonly (Looks | null)[]): Looks => ({
  fit: () => pictures.forEach((each) => each?.fit()),
  show: (bounds) => pictures.forEach((each) => each?.show(bounds)),
});

/**
 * The place that is looked at, chosen in the list or in the picture: the picture goes near it, and playback to its
 * moment.
 */
export function useLooking<P extends Pick<LookAt, "id" | "bounds" | "position">>(
  places: readonly P[],
  viewport: Looks,
  playback: PlaybackStore,
) {
  const { id, count } = useChosen();
  const chosen = places.find((place) => place.id === id) ?? null;
  const look = useEffectEvent(() => {
    // A picture that comes up later stays as it is, and what the other one shows is not looked for here.
    if (count <= useChosen.getState().shown || (id !== null && !chosen)) return;
    useChosen.setState({ shown: count });
    if (!chosen) return viewport.fit();
    // Steps of what was proved are not those of a path that is still to be proved.
    if (!useOutcome.getState().planned) playback.dispatch({ do: "seek", position: chosen.position });
    viewport.show(chosen.bounds);
  });
  // Only a new choice moves the picture: a place that is found again after a change of values leaves it where it is.
  useEffect(() => look(), [count]);
  return { chosen, choose: (place: Pick<LookAt, "id"> | null) => chooseFinding(place?.id ?? null) };
}

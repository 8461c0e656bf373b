import { useEffect, useEffectEvent } from "react";
import { useOutcome } from "../../calculation/outcome.ts";
import { chooseFinding, useChosenFinding } from "../../document/chosen-finding.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";
import type { Viewport } from "./viewport.ts";
import type { PicturePlace } from "./places.ts";

/** Shows a place, or everything again. */
type Looks = Pick<Viewport, "fit" | "show">;

/** Applies the same view to several pictures of one work. */
export const combineViews = (pictures: readonly (Looks | null)[]): Looks => ({
  fit: () => pictures.forEach((each) => each?.fit()),
  show: (bounds) => pictures.forEach((each) => each?.show(bounds)),
});

/** The chosen place: the picture zooms to it, and playback seeks its moment. */
export function useFindingFocus<P extends Pick<PicturePlace, "id" | "bounds" | "position">>(
  places: readonly P[],
  viewport: Looks,
  playback: PlaybackStore,
) {
  const { id, count } = useChosenFinding();
  const chosen = places.find((place) => place.id === id) ?? null;
  const look = useEffectEvent(() => {
    // A picture that opens later keeps its view, and a place of the other picture is ignored here.
    if (count <= useChosenFinding.getState().shown || (id !== null && !chosen)) return;
    useChosenFinding.setState({ shown: count });
    if (!chosen) return viewport.fit();
    // The steps of the simulated run are not those of a path that is only planned yet.
    if (!useOutcome.getState().planned) playback.dispatch({ do: "seek", position: chosen.position });
    viewport.show(chosen.bounds);
  });
  // Only a new choice moves the picture; a place that is found again after a change of values does not.
  useEffect(() => look(), [count]);
  return { chosen, choose: (place: Pick<PicturePlace, "id"> | null) => chooseFinding(place?.id ?? null) };
}

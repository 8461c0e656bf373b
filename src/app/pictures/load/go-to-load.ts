import type { LoadPlace } from "../../../view/load/values.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** Moves the tool to the moment of a place and pauses. */
export function goToLoad(playback: PlaybackStore, { position }: LoadPlace): void {
  playback.dispatch({ do: "pause" });
  playback.dispatch({ do: "seek", position });
}

import type { LoadPlace } from "../../../view/load/values.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** The tool goes to the moment of a place and stays there. */
export function goToLoad(playback: PlaybackStore, { position }: LoadPlace): void {
  playback.dispatch({ do: "pause" });
  playback.dispatch({ do: "seek", position });
}

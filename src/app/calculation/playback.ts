import { clock } from "../base/clock.ts";
import { createPlaybackStore } from "./playback-store.ts";

/** The playback of the page: lathe view, timeline and program text follow the same one. */
export const playback = createPlaybackStore(clock);

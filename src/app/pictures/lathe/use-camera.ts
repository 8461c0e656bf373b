import { useSyncExternalStore } from "react";
import type { Camera } from "../../../view/camera.ts";
import type { Viewport } from "./viewport.ts";

/** The camera, for the few elements in screen space that follow it. */
export const useCamera = (viewport: Viewport): Camera => useSyncExternalStore(viewport.subscribe, viewport.get);

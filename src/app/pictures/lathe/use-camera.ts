import { useSyncExternalStore } from "react";
import type { Camera } from "../../../view/camera.ts";
import type { Viewport } from "./viewport.ts";

/** The camera, for the few elements that stand in screen space and follow it. */
export const useCamera = (viewport: Viewport): Camera => useSyncExternalStore(viewport.subscribe, viewport.get);
